/// \file
/// What the implicit schemes share: finding where a step ends.
#pragma once

#include <shell_origami/dynamics/integrator.h>
#include <shell_origami/dynamics/newton.h>

namespace shell_origami {

class ImplicitSolver {
 public:
  explicit ImplicitSolver(const SolverConfig& config);

  /// Says that topology or held vertices changed: the next solve makes its matrix anew.
  void topologyChanged();

  const SolverState& memory() const { return newton_.memory(); }
  void restoreState(const SolverState& memory) { newton_.restoreState(memory); }

  /// The minimum of energy and inertia into x, within the tolerance. The search begins at `start`,
  /// or where that throws a hinge through 180 degrees, at `before`.
  bool solve(const Loading& loading, const Inertia& inertia, const Positions& start, double dt,
             const Positions& before, Positions& x, StepReport& report);

 private:
  double tolerance_;
  int max_iterations_;
  bool stale_ = true;
  Newton newton_;
};

}  // namespace shell_origami
