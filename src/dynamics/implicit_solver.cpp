#include "dynamics/implicit_solver.h"

#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// x with the held vertices where they stand at the end of the step.
Positions withHeld(const Load& load, Positions x) {
  for (std::size_t v = 0; v < load.free.size(); ++v) {
    if (!load.free[v]) x.col(v) = load.held.col(v);
  }
  return x;
}

}  // namespace

ImplicitSolver::ImplicitSolver(const SolverConfig& config)
    : tolerance_(config.tolerance), max_iterations_(config.max_iterations) {}

bool ImplicitSolver::solve(const Load& load, const Inertia& inertia, const Positions& predicted,
                           double dt, const Positions& before, Positions& x, StepReport& report) {
  if (std::exchange(stale_, false)) newton_.setTopology(load.shell, load.free);
  std::vector<double> angles;
  load.shell.foldAngles(before, angles);
  x = withHeld(load, predicted);
  if (!std::isfinite(load.shell.energy(x, angles))) x = withHeld(load, before);
  if (const auto fault = load.shell.findFault(x, angles)) {
    report.failure = std::string("where pins are carried ") + fault->what;
    report.vertex = fault->vertex;
    return false;
  }
  const NewtonResult result =
      newton_.minimize(load.shell, inertia, tolerance_ * dt, max_iterations_, x);
  report.newton_iterations += result.iterations;
  report.factorizations += result.factorizations;
  report.residual = result.last_step / dt;
  const auto fault = load.shell.findFault(x, angles);
  if (result.converged && !fault) return true;
  report.failure = result.converged ? fault->what : result.failure;
  report.vertex = result.converged ? fault->vertex : result.vertex;
  return false;
}

}  // namespace shell_origami
