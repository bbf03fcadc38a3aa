/// \file
/// Everything about a simulation but the sheet.
#pragma once

#include <shell_origami/dynamics/integrator.h>
#include <shell_origami/energy/material.h>
#include <shell_origami/energy/rest_shape.h>

namespace shell_origami {

struct SimulationConfig {
  Material material;
  Vector3 gravity = Vector3::Zero();  ///< [m/s^2]; zero: the paper floats
  SolverConfig solver;
  double fold_duration = 1.0;  ///< of a fold that states none [s]
  NaturalCurvature rest;       ///< how the sheet is rolled up when it rests
};

/// Bounds of what a configuration may hold.
struct Bounds {
  double low, high;
};
constexpr Bounds kGravityBounds{-1e4, 1e4};  ///< of each component [m/s^2]
constexpr Bounds kAirDampingBounds{0, 1e6};  ///< [1/s]

/// What of a configuration may change while the paper moves.
struct LiveConfig {
  Vector3 gravity = Vector3::Zero();  ///< [m/s^2]
  double air_damping = 0;             ///< [1/s]
  double fold_duration = 1;           ///< of a fold that states none [s]
};

/// \throws std::invalid_argument with a sentence that names the offending parameter and value.
void checkConfig(const SimulationConfig& config);

}  // namespace shell_origami
