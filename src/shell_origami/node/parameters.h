/// \file
/// The node's parameters. config/origami.yaml is their manual.
#pragma once

#include <shell_origami/node/draw/coloring.h>
#include <shell_origami/origami/recipe.h>

#include <ros/node_handle.h>

#include <string>

namespace shell_origami {

enum class ClockMode {
  kFollow,  ///< keeps pace with ROS time
  kLead,    ///< publishes /clock itself
};

constexpr Bounds kPublishRateBounds{0.01, 1000};     ///< [Hz]
constexpr Bounds kCheckpointPeriodBounds{0.1, 1e6};  ///< [s]

struct NodeConfig {
  SimulationConfig simulation;
  SheetSource sheet;
  std::string recipe;   ///< path of the recipe to run; empty: none
  std::string output;   ///< folder for the results of the recipe; empty: none are written
  bool paused = false;  ///< whether the node starts paused
  bool wait_for_recorder = false;  ///< whether to start once ~sheet, ~state, ~edits are heard
  double publish_rate = 30;        ///< [Hz]
  std::string checkpoint;          ///< file to go on from and to keep; empty: none
  double checkpoint_period = 10;   ///< [s] of wall time
  std::string world_frame = "world";
  bool vertex_ids = false;  ///< whether the markers show the vertices' numbers
  Coloring colouring = Coloring::kPaper;
  ClockMode clock = ClockMode::kFollow;
  double real_time_factor = 1;  ///< simulated over elapsed time, lead only; 0: as fast as it can
};

/// Reads the private parameters of the node; those that are not set keep their defaults.
/// \throws std::invalid_argument with one sentence that names the offending parameter and value,
///         for a wrong type, a value out of bounds, and a name that no parameter has.
NodeConfig loadParameters(const ros::NodeHandle& private_node);

/// \throws std::invalid_argument with the same sentences.
void checkParameters(const NodeConfig& config);

/// The path of a recipe given as a path, or by the bare name of one that comes with the package.
/// \throws std::invalid_argument when there is no such file.
std::string findRecipe(const std::string& recipe);

}  // namespace shell_origami
