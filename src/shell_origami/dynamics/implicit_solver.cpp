#include <shell_origami/dynamics/implicit_solver.h>

#include <shell_origami/base/timer.h>

#include <utility>

namespace shell_origami {
namespace {

/// Puts the held vertices where they stand at the end of the step.
void placeHeld(const Loading& loading, Positions& x) {
  for (std::size_t v = 0; v < loading.free.size(); ++v) {
    if (!loading.free[v]) x.col(v) = loading.held.col(v);
  }
}

}  // namespace

ImplicitSolver::ImplicitSolver(const SolverConfig& config)
    : tolerance_(config.tolerance), max_iterations_(config.max_iterations) {}

void ImplicitSolver::topologyChanged() {
  stale_ = true;
  newton_.restoreState({});
}

bool ImplicitSolver::solve(const Loading& loading, const Inertia& inertia, const Positions& start,
                           double dt, const Positions& before, Positions& x, StepReport& report) {
  if (std::exchange(stale_, false)) {
    const Timer timer(report.times.symbolic);
    newton_.setTopology(loading.shell, loading.free);
  }
  const auto minimizeFrom = [&](const Positions& place) {
    x = place;
    placeHeld(loading, x);
    const NewtonResult result =
        newton_.minimize(loading.shell, inertia, before, tolerance_ * dt, max_iterations_, x);
    report.newton_iterations += result.iterations;
    report.factorizations += result.factorizations;
    report.residual = result.last_step / dt;
    report.times += result.times;
    report.failure = result.failure;
    report.vertex = result.vertex;
    return result;
  };
  const NewtonResult result = minimizeFrom(start);
  if (result.converged) return true;
  // The start itself may be no paper.
  return result.iterations == 0 && minimizeFrom(before).converged;
}

}  // namespace shell_origami
