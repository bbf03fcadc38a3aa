/// \file
/// Everything about a simulation but the sheet.
#pragma once

#include <shell_origami/contact/contact_potential.h>
#include <shell_origami/dynamics/integrator.h>
#include <shell_origami/energy/material.h>
#include <shell_origami/energy/rest_shape.h>
#include <shell_origami/origami/compliance.h>

namespace shell_origami {

struct SimulationConfig {
  Material material;
  Vector3 gravity = Vector3::Zero();  ///< [m/s^2]; zero: the paper floats
  SolverConfig solver;
  double fold_duration = 1.0;  ///< of a fold that states none [s]
  ComplianceConfig compliance;
  ContactConfig contact;
  NaturalCurvature rest;  ///< how the sheet is rolled up when it rests
};

/// The part of a configuration that may change while the paper moves.
struct LiveConfig {
  Vector3 gravity = Vector3::Zero();  ///< [m/s^2]
  double air_damping = 0;             ///< [1/s]
  double fold_duration = 1;           ///< of a fold that states none [s]

  bool operator==(const LiveConfig& other) const {
    return gravity == other.gravity && air_damping == other.air_damping &&
           fold_duration == other.fold_duration;
  }
};

inline LiveConfig liveConfigOf(const SimulationConfig& config) {
  return {config.gravity, config.material.air_damping, config.fold_duration};
}

/// Returns what contact is made of, between layers of the paper and with obstacles.
ContactParameters contactParameters(const SimulationConfig& config);

/// \throws std::invalid_argument that names the offending parameter, its value and its bounds.
void checkConfig(SimulationConfig config);

}  // namespace shell_origami
