/// \file
/// Explicit symplectic Euler: no equation to solve, but stiff paper needs tiny steps.
#pragma once

#include <shell_origami/dynamics/integrator.h>
#include <shell_origami/dynamics/objective.h>

namespace shell_origami {

/// First order. Stable only below 2 over the highest frequency of the mesh (Discrete Shells
/// Origami, figure 2).
class SymplecticEuler : public Integrator {
 public:
  bool step(const StepInput& input, double dt, Motion& motion, StepReport& report) override;

 private:
  // Scratch, kept between steps.
  Objective objective_;
  Positions gradient_;
};

}  // namespace shell_origami
