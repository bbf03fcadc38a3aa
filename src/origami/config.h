/// \file
/// Everything about a simulation but the sheet.
#pragma once

#include "dynamics/integrator.h"
#include "shell/material.h"
#include "shell/rest_shape.h"

namespace shell_origami {

struct SimulationConfig {
  Material material;
  Vector3 gravity = Vector3::Zero();  ///< [m/s^2]; zero: the paper floats
  SolverConfig solver;
  double fold_duration = 1.0;  ///< of a fold that states none [s]
  Roll rest;                   ///< how the sheet is rolled up when it rests
};

/// \throws std::invalid_argument with a sentence that names the offending parameter and value.
void checkConfig(const SimulationConfig& config);

}  // namespace shell_origami
