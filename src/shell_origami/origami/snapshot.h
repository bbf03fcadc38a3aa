/// \file
/// All that a simulation is at one moment, and how it is kept in a file or a recording.
#pragma once

#include <shell_origami/contact/crossings.h>
#include <shell_origami/dynamics/integrator.h>
#include <shell_origami/energy/in_plane_set.h>
#include <shell_origami/energy/rest_shape.h>
#include <shell_origami/origami/compliance.h>
#include <shell_origami/origami/config.h>
#include <shell_origami/origami/crease_actuation.h>
#include <shell_origami/origami/grasps.h>
#include <shell_origami/origami/held_vertices.h>
#include <shell_origami/origami/obstacles.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace shell_origami {

/// Sums over the life of the simulation.
struct Counters {
  std::uint64_t steps = 0;
  std::uint64_t newton_iterations = 0;
  std::uint64_t factorizations = 0;
  std::uint64_t retries = 0;
  SolverTimes times;

  Counters& operator+=(const Counters& other);
  Counters& operator-=(const Counters& other);
};

/// A simulation made of it goes on as the one it was taken of, to the bit.
struct Snapshot {
  SimulationConfig config;
  Sheet sheet;
  Motion motion;
  CreaseActuation creases;
  Compliance compliance;
  RestShape rest;
  InPlaneSet in_plane;
  HeldVertices held;
  Obstacles obstacles;
  Grasps grasps;
  SolverState solver;
  VertexGraph pattern;  ///< of the solver's matrix, where contact made it; otherwise of no vertices
  Counters counters;
  double time = 0;  ///< [s]
  bool resting = false;
  bool edited = false;                 ///< since the last step
  std::vector<TrianglePair> left_out;  ///< of contact, ascending
};

/// Returns about how much memory it takes [bytes].
std::size_t memoryOf(const Snapshot& snapshot);

nlohmann::json toJson(const SimulationConfig& config);
/// Throws std::invalid_argument or nlohmann::json::exception for anything else than toJson() made.
SimulationConfig configFrom(const nlohmann::json& json);
nlohmann::json toJson(const Counters& counters);
/// \throws nlohmann::json::exception
Counters countersFrom(const nlohmann::json& json);

/// Exact: what is read back is what was written, but for Counters::times.
nlohmann::json toJson(const Snapshot& snapshot);
/// Throws std::invalid_argument if the JSON is not that of a snapshot.
Snapshot snapshotFrom(const nlohmann::json& json);

}  // namespace shell_origami
