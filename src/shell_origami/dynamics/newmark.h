/// \file
/// Implicit Newmark (Newmark 1959; Discrete Shells Origami, figure 4).
#pragma once

#include <shell_origami/dynamics/implicit_solver.h>

namespace shell_origami {

/// Second order at beta = 1/4, gamma = 1/2, where it conserves energy; above gamma = 1/2 it damps.
class Newmark : public Integrator {
 public:
  Newmark(const SolverConfig& config, ImplicitSolver& solver);
  bool step(const StepInput& input, double dt, Motion& motion, StepReport& report) override;

 private:
  bool gainsEnergy(const StepInput& input, const Motion& motion);

  double tolerance_;
  double beta_, gamma_;
  ImplicitSolver& solver_;
  // Scratch, kept between steps.
  Positions predicted_, velocity_, velocity_after_, acceleration_after_, start_, x_;
  Inertia inertia_;
};

}  // namespace shell_origami
