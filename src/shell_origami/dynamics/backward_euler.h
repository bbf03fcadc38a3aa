/// \file
/// Implicit backward Euler (Baraff & Witkin 1998; Discrete Shells Origami, figure 3), converged.
#pragma once

#include <shell_origami/dynamics/implicit_solver.h>

namespace shell_origami {

/// First order and damps; it remembers no acceleration, so that steps may differ in length.
class BackwardEuler : public Integrator {
 public:
  explicit BackwardEuler(ImplicitSolver& solver) : solver_(solver) {}
  bool step(const StepInput& input, double dt, Motion& motion, StepReport& report) override;

 private:
  ImplicitSolver& solver_;
};

}  // namespace shell_origami
