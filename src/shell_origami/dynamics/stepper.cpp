#include <shell_origami/dynamics/stepper.h>

#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// A step is cut in two at most this often.
constexpr int kDeepest = 10;
/// Viscous steps of a relaxation: how they grow, how long they have to be before standing still
/// counts as equilibrium, and how short they may get, in time steps; and how many it takes at most.
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

void Stepper::setTopology(std::vector<bool> free) {
  free_ = std::move(free);
  solver_->topologyChanged();
}

bool Stepper::stepInParts(Shell& shell, double air_damping, Drive& drive, double from, double to,
                          int depth, Motion& motion, StepReport& report) {
  drive.moveTo(to, shell, held_);
  const Loading loading{shell, air_damping, free_, held_};
  if (retry_->step(loading, (to - from) * config_.time_step, motion, report)) return true;
  if (depth == kDeepest) return false;
  ++report.retries;
  const double middle = (from + to) / 2;
  return stepInParts(shell, air_damping, drive, from, middle, depth + 1, motion, report) &&
         stepInParts(shell, air_damping, drive, middle, to, depth + 1, motion, report);
}

StepReport Stepper::step(Shell& shell, double air_damping, Drive& drive, Motion& motion) {
  StepReport report;
  held_ = motion.positions;
  drive.moveTo(1, shell, held_);
  if (integrator_->step({shell, air_damping, free_, held_}, config_.time_step, motion, report)) {
    return report;
  }
  ++report.retries;
  Motion trial = motion;
  report.converged = stepInParts(shell, air_damping, drive, 0, 0.5, 1, trial, report) &&
                     stepInParts(shell, air_damping, drive, 0.5, 1, 1, trial, report);
  if (report.converged) {
    report.failure.clear();
    report.vertex = -1;
    if (config_.integrator == IntegratorKind::kNewmark) trial.accelerations.setZero();
    motion = std::move(trial);
  }
  return report;
}

StepReport Stepper::relax(Shell& shell, const std::function<void(Shell&, const Positions&)>& adapt,
                          Motion& motion) {
  StepReport report;
  const Positions start = motion.positions;
  const double still = config_.tolerance * config_.time_step;
  Positions x = start;
  double length = 1;  // of a viscous step, in time steps
  for (int round = 0; round < kMostRounds && length >= kShortest; ++round) {
    const double dt = length * config_.time_step;
    Positions next;
    if (!solver_->solve({shell, 0, free_, start}, {1 / (dt * dt), x}, x, config_.time_step, x, next,
                        report)) {
      ++report.retries;
      length *= kShrink;
      continue;
    }
    const double moved = std::sqrt((next - x).colwise().squaredNorm().maxCoeff());
    x = std::move(next);
    adapt(shell, x);
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
