/// \file
/// Paper that nothing drives: the integrator alone, from any start.
#pragma once

#include <shell_origami/dynamics/stepper.h>
#include <shell_origami/energy/shell_potential.h>

#include <vector>

namespace shell_origami {

/// So thick and soft that time steps follow its stretching as well as its bending, as they would
/// have to in paper of which every wave is to be kept.
Material softBoard();

/// Uncreased paper without gravity or air. It starts with the accelerations that its forces give
/// it: with others a scheme of second order starts with an error of first order.
class FreeMotion {
 public:
  /// `held` vertices stay where they are.
  FreeMotion(const Sheet& sheet, const Material& material, const SolverConfig& solver,
             const Positions& positions, const Positions& velocities,
             const std::vector<std::int64_t>& held = {});

  /// \throws std::runtime_error when the step had to be cut, and so was not one of the scheme.
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
