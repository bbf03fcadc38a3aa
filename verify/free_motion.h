/// \file
/// Paper without loads or folds, to test the integrator alone from any initial state.
#pragma once

#include <shell_origami/dynamics/stepper.h>
#include <shell_origami/energy/shell_potential.h>

#include <vector>

namespace shell_origami {

/// Returns a material so thick and soft that time steps resolve stretching waves as well as bending
/// waves.
Material softBoard();

/// Uncreased paper without gravity or air. Its initial accelerations are consistent with its
/// forces; otherwise a scheme of second order would start with an error of first order.
class FreeMotion {
 public:
  /// `held` vertices do not move.
  FreeMotion(const Sheet& sheet, const Material& material, const SolverConfig& solver,
             const Positions& positions, const Positions& velocities,
             const std::vector<std::int64_t>& held = {});

  /// Throws std::runtime_error if the step was retried with backward Euler.
  void step();

  const Motion& motion() const { return motion_; }
  const Shell& shell() const { return shell_.shell(); }
  double kineticEnergy() const;  ///< [J]
  double elasticEnergy() const;  ///< [J]

 private:
  ShellPotential shell_;
  Motion motion_;
  Stepper stepper_;
};

}  // namespace shell_origami
