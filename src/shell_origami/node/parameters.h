/// \file
/// The node's parameters. config/origami.yaml is their manual.
#pragma once

#include <shell_origami/node/draw/coloring.h>
#include <shell_origami/node/draw/labels.h>
#include <shell_origami/node/sense/depth_config.h>
#include <shell_origami/origami/parameter_table.h>

#include <ros/node_handle.h>

#include <string>

namespace shell_origami {

enum class ClockMode {
  kFollow,  ///< keeps pace with ROS time
  kLead,    ///< publishes /clock itself
};

struct NodeConfig {
  SimulationConfig simulation;
  SheetSource sheet;
  std::string recipe;   ///< path of the recipe to run; empty: none
  std::string output;   ///< folder for the results of the recipe; empty: none are written
  bool paused = false;  ///< whether the node starts paused
  bool wait_for_recorder = false;  ///< whether to start once ~sheet, ~state, ~edits are heard
  double wait_for_viewer = 0;      ///< how long to wait at the start for ~markers to be heard [s]
  double publish_rate = 30;        ///< [Hz]
  std::string checkpoint;          ///< file to go on from and to keep; empty: none
  double checkpoint_period = 10;   ///< [s] of wall time
  double undo_memory = 100;        ///< for the papers before edits that can be undone [MB]
  double diagnostic_period = 1;    ///< [s] of wall time
  bool watch_master = false;       ///< whether to register again with a master that is restarted
  std::string world_frame = "world";
  std::string frame_prefix;  ///< with which the names of the paper's own frames begin
  MarkerOptions markers;     ///< what the markers show on demand
  Coloring colouring = Coloring::kPaper;
  int cloud_points = 20000;  ///< about how many ~cloud has, on both sides together
  DepthConfig depth;
  ClockMode clock = ClockMode::kFollow;
  double real_time_factor = 1;  ///< simulated over elapsed time, lead only; 0: as fast as it can
};

/// Every private parameter of the node, those of its paper included.
const ParameterTable<NodeConfig>& nodeParameters();

/// Reads the private parameters of the node; those that are not set keep their defaults.
/// \throws std::invalid_argument with one error message that names the offending parameter and
///         value, for a wrong type, a value out of bounds, and a name that no parameter has.
NodeConfig loadParameters(const ros::NodeHandle& private_node);

/// \throws std::invalid_argument with the same messages.
void checkParameters(const NodeConfig& config);

/// The path of a recipe given as a path, or by the bare name of one that comes with the package.
/// \throws std::invalid_argument when there is no such file.
std::string findRecipe(const std::string& recipe);

}  // namespace shell_origami
