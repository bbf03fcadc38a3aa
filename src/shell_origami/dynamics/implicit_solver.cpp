#include <shell_origami/dynamics/implicit_solver.h>

namespace shell_origami {
namespace {

/// Puts the prescribed vertices where they stand at the end of the step.
void placePrescribed(const StepInput& input, Positions& x) {
  for (std::size_t v = 0; v < input.free.size(); ++v) {
    if (!input.free[v]) x.col(v) = input.prescribed.col(v);
  }
}

}  // namespace

ImplicitSolver::ImplicitSolver(const SolverConfig& config)
    : tolerance_(config.tolerance), max_iterations_(config.max_iterations) {}

void ImplicitSolver::setFree(const std::vector<bool>& free, int first_body) {
  newton_.setFree(free, first_body);
  newton_.restoreState({});
}

bool ImplicitSolver::solve(const StepInput& input, const Inertia& inertia, const Positions& start,
                           double dt, const Positions& before, Positions& x, StepReport& report) {
  const auto minimizeFrom = [&](const Positions& place) {
    x = place;
    placePrescribed(input, x);
    const NewtonResult result = newton_.minimize(input.potentials, input.masses, inertia, before,
                                                 tolerance_ * dt, max_iterations_, x);
    report.newton_iterations += result.iterations;
    report.factorizations += result.factorizations;
    report.analyses += result.analyses;
    report.newton_step_rate = result.last_step / dt;
    report.gradient_norm = result.gradient_norm;
    report.times += result.times;
    report.failure = result.failure;
    report.vertex = result.vertex;
    return result;
  };
  const NewtonResult result = minimizeFrom(start);
  if (result.converged) return true;
  // The start itself may be infeasible.
  return result.iterations == 0 && minimizeFrom(before).converged;
}

}  // namespace shell_origami
