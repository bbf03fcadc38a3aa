/// \file
/// All that a simulation is at one moment, and how it is kept in a file or a recording.
#pragma once

#include "dynamics/newton.h"
#include "origami/config.h"
#include "origami/crease_drive.h"
#include "origami/held_vertices.h"
#include "shell/rest_shape.h"

#include <nlohmann/json.hpp>

namespace shell_origami {

/// Sums over the life of the simulation.
struct Counters {
  std::uint64_t steps = 0;
  std::uint64_t newton_iterations = 0;
  std::uint64_t factorizations = 0;
  std::uint64_t retries = 0;
  SolverTimes times;
};

/// A simulation made of it goes on as the one it was taken of, to the bit.
struct Snapshot {
  SimulationConfig config;
  Sheet sheet;
  Motion motion;
  CreaseDrive creases;
  RestShape rest;
  HeldVertices held;
  SolverMemory memory;
  Counters counters;
  double time = 0;  ///< [s]
  bool resting = false;
};

/// Exact: what is read back is what was written, but for Counters::times.
nlohmann::json toJson(const Snapshot& snapshot);
/// \throws std::invalid_argument with one sentence when it is none of a paper.
Snapshot snapshotFrom(const nlohmann::json& json);

}  // namespace shell_origami
