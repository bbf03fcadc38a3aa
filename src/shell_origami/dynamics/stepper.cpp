#include <shell_origami/dynamics/stepper.h>

#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// Viscous steps of a relaxation: factors of their length after success and failure; the length, in
/// time steps, from which no motion means equilibrium, and its bounds; and their largest number.
constexpr double kGrowth = 2, kShrink = 0.25;
constexpr double kLongEnough = 64, kLongest = 1e3, kShortest = 1e-3;
constexpr int kMostRounds = 200;

SolverConfig retryConfig(const SolverConfig& config) {
  SolverConfig retry = config;
  if (config.integrator == IntegratorKind::kNewmark) {
    retry.integrator = IntegratorKind::kBackwardEuler;
  }
  return retry;
}

}  // namespace

Stepper::Stepper(const SolverConfig& config)
    : config_(config),
      solver_(std::make_unique<ImplicitSolver>(config)),
      integrator_(makeIntegrator(config, *solver_)),
      retry_(makeIntegrator(retryConfig(config), *solver_)) {}

void Stepper::setFree(std::vector<bool> free, int body_vertices) {
  free_ = std::move(free);
  solver_->setFree(free_, static_cast<int>(free_.size()) - body_vertices);
}

/// Takes the part of the whole step between the fractions `from` and `to`.
bool Stepper::take(Integrator& integrator, const Whole& whole, double from, double to,
                   Motion& motion, StepReport& report) {
  whole.conditions.applyAt(to, prescribed_);
  const StepInput input{whole.potentials,  whole.masses,
                        whole.air_damping, free_,
                        prescribed_,       whole.conditions.constant()};
  return integrator.step(input, (to - from) * config_.time_step, motion, report);
}

bool Stepper::stepInParts(const Whole& whole, double from, double to, int depth, Motion& motion,
                          StepReport& report) {
  if (take(*retry_, whole, from, to, motion, report)) return true;
  if (depth >= whole.conditions.mostDivisions()) return false;
  ++report.retries;
  const double middle = (from + to) / 2;
  return stepInParts(whole, from, middle, depth + 1, motion, report) &&
         stepInParts(whole, middle, to, depth + 1, motion, report);
}

StepReport Stepper::step(const Potentials& potentials, const Eigen::VectorXd& masses,
                         double air_damping, BoundaryConditions& conditions, Motion& motion) {
  StepReport report;
  const Whole whole{potentials, masses, air_damping, conditions};
  prescribed_ = motion.positions;
  // Newmark's accelerations would pass the forces of contact on to the next step, which chatters.
  Integrator& integrator = motion.rough ? *retry_ : *integrator_;
  if (take(integrator, whole, 0, 1, motion, report)) return report;
  ++report.retries;
  Motion trial = motion;
  report.converged =
      stepInParts(whole, 0, 0.5, 1, trial, report) && stepInParts(whole, 0.5, 1, 1, trial, report);
  if (report.converged) {
    report.failure.clear();
    report.vertex = -1;
    solver_->restoreState({});
    if (config_.integrator == IntegratorKind::kNewmark) trial.accelerations.setZero();
    motion = std::move(trial);
  }
  return report;
}

StepReport Stepper::relax(const Potentials& potentials, const Eigen::VectorXd& masses,
                          const std::function<void(const Positions&)>& adapt, Motion& motion) {
  StepReport report;
  const Positions start = motion.positions;
  const double still = config_.tolerance * config_.time_step;
  Positions x = start;
  double length = 1;  // of a viscous step, in time steps
  for (int round = 0; round < kMostRounds && length >= kShortest; ++round) {
    const double dt = length * config_.time_step;
    Positions next;
    if (!solver_->solve({potentials, masses, 0, free_, start, true}, {1 / (dt * dt), x}, x,
                        config_.time_step, x, next, report)) {
      ++report.retries;
      length *= kShrink;
      continue;
    }
    const double moved = std::sqrt((next - x).colwise().squaredNorm().maxCoeff());
    x = std::move(next);
    adapt(x);
    if (moved <= still && length >= kLongEnough) {
      motion = {std::move(x), Positions::Zero(3, start.cols()), Positions::Zero(3, start.cols())};
      report.failure.clear();
      report.vertex = -1;
      return report;
    }
    length = std::min(kGrowth * length, kLongest);
  }
  report.converged = false;
  report.failure = "the paper finds no equilibrium" +
                   (report.failure.empty() ? std::string() : ": " + report.failure);
  return report;
}

}  // namespace shell_origami
