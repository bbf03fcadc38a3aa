/// \file
/// The nonlinear solve that the implicit schemes share.
#pragma once

#include <shell_origami/dynamics/integrator.h>
#include <shell_origami/dynamics/newton.h>

#include <utility>

namespace shell_origami {

class ImplicitSolver {
 public:
  explicit ImplicitSolver(const SolverConfig& config);

  /// Says that the mesh, the potentials or the held vertices changed. `free[v]` is false for held
  /// vertices; those from `first_body` on are of bodies.
  void setFree(const std::vector<bool>& free, int first_body);

  const SolverState& state() const { return newton_.state(); }
  void restoreState(const SolverState& state) { newton_.restoreState(state); }
  const VertexGraph& pattern() const { return newton_.pattern(); }
  bool restorePattern(VertexGraph pattern) { return newton_.restorePattern(std::move(pattern)); }

  /// Moves x to the minimum of energy and inertia, within the tolerance. The search begins at
  /// `start`, or where the paper cannot get there in one step, at `before`; prescribed vertices
  /// stand at their places in either. Returns false, with the failure in the report, where it finds
  /// none.
  bool solve(const StepInput& input, const Inertia& inertia, const Positions& start, double dt,
             const Positions& before, Positions& x, StepReport& report);

  /// Returns by how much the potentials at x, which solve() found last, are above those at `before`
  /// [J].
  double potentialChange(const Positions& before, const Positions& x) {
    return newton_.potentialChange(before, x);
  }
  /// Whether forces at that x may jump within a step.
  bool rough() const { return newton_.rough(); }
  /// Returns what one of the potentials keeps of that x.
  Potential::Iterate& reached(const Potential& potential) { return newton_.reached(potential); }

 private:
  double tolerance_;
  int max_iterations_;
  Newton newton_;
};

}  // namespace shell_origami
