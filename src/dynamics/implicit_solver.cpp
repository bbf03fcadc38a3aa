#include "dynamics/implicit_solver.h"

#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// x with the held vertices where they stand at the end of the step.
Positions withHeld(const Loading& loading, Positions x) {
  for (std::size_t v = 0; v < loading.free.size(); ++v) {
    if (!loading.free[v]) x.col(v) = loading.held.col(v);
  }
  return x;
}

}  // namespace

ImplicitSolver::ImplicitSolver(const SolverConfig& config)
    : tolerance_(config.tolerance), max_iterations_(config.max_iterations) {}

bool ImplicitSolver::solve(const Loading& loading, const Inertia& inertia, const Positions& predicted,
                           double dt, const Positions& before, Positions& x, StepReport& report) {
  if (std::exchange(stale_, false)) newton_.setTopology(loading.shell, loading.free);
  std::vector<double> angles;
  loading.shell.foldAngles(before, angles);
  x = withHeld(loading, predicted);
  if (!std::isfinite(loading.shell.energy(x, angles))) x = withHeld(loading, before);
  if (const auto fault = loading.shell.findFault(x, angles)) {
    report.failure = std::string("where pins are carried ") + fault->what;
    report.vertex = fault->vertex;
    return false;
  }
  const NewtonResult result =
      newton_.minimize(loading.shell, inertia, tolerance_ * dt, max_iterations_, x);
  report.newton_iterations += result.iterations;
  report.factorizations += result.factorizations;
  report.residual = result.last_step / dt;
  const auto fault = loading.shell.findFault(x, angles);
  if (result.converged && !fault) return true;
  report.failure = result.converged ? fault->what : result.failure;
  report.vertex = result.converged ? fault->vertex : result.vertex;
  return false;
}

}  // namespace shell_origami
