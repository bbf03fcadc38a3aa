#include "dynamics/newmark.h"

#include "dynamics/newton.h"

#include <cmath>

namespace shell_origami {
namespace {

/// A step is cut in two at most this often.
constexpr int kDeepest = 10;

void add(const NewtonResult& result, double dt, StepReport& report) {
  report.newton_iterations += result.iterations;
  report.factorizations += result.factorizations;
  report.residual = result.last_step / dt;
}

}  // namespace

struct Newmark::Implementation {
  SolverConfig config;
  Newton newton;

  // One step of length dt. False, and `motion` is as it was, when Newton fails.
  bool newmarkStep(const Shell& shell, double air_damping, double dt, Motion& motion,
                   StepReport& report);
  bool backwardEulerStep(const Shell& shell, double air_damping, double dt, Motion& motion,
                         StepReport& report);
  bool solve(const Shell& shell, const Inertia& inertia, const Positions& predicted, double dt,
             const Motion& motion, Positions& x, StepReport& report);
  void holdPinned(Motion& motion) const;
  bool stepInParts(Shell& shell, double air_damping, Drive& drive, double from, double to,
                   int depth, Motion& motion, StepReport& report);
};

Newmark::Newmark(const SolverConfig& config) : implementation_(new Implementation{config, {}}) {
  const double gamma = config.gamma;
  if (config.beta == 0) implementation_->config.beta = (gamma + 0.5) * (gamma + 0.5) / 4;
}
Newmark::~Newmark() = default;
Newmark::Newmark(Newmark&&) noexcept = default;
Newmark& Newmark::operator=(Newmark&&) noexcept = default;

void Newmark::setTopology(const Shell& shell, const std::vector<bool>& free) {
  implementation_->newton.setTopology(shell, free);
}

// The minimum from the predictor, which is the best start unless it throws a hinge through 180
// degrees.
bool Newmark::Implementation::solve(const Shell& shell, const Inertia& inertia,
                                    const Positions& predicted, double dt, const Motion& motion,
                                    Positions& x, StepReport& report) {
  std::vector<double> angles;
  shell.foldAngles(motion.positions, angles);
  x = std::isfinite(shell.energy(predicted, angles)) ? predicted : motion.positions;
  const NewtonResult result =
      newton.minimize(shell, inertia, config.tolerance * dt, config.max_iterations, x);
  add(result, dt, report);
  if (result.converged && std::isfinite(shell.energy(x, angles))) return true;
  report.failure = result.converged ? "a hinge jumped or a triangle collapsed" : result.failure;
  return false;
}

void Newmark::Implementation::holdPinned(Motion& motion) const {
  for (Eigen::Index v = 0; v < motion.positions.cols(); ++v) {
    if (newton.isFree(static_cast<int>(v))) continue;
    motion.velocities.col(v).setZero();
    motion.accelerations.col(v).setZero();
  }
}

// With x_pred = x + dt v + dt^2 (1/2 - beta) a and v_pred = v + dt (1 - gamma) a the scheme says
//   a' = (x' - x_pred) / (beta dt^2),   v' = v_pred + gamma dt a'.
// M a' = -dW/dx - c M v' is then the minimum of W + s/2 |x' - anchor|^2_M with
//   s = (1 + c gamma dt) / (beta dt^2),   anchor = x_pred - (c / s) v_pred.
bool Newmark::Implementation::newmarkStep(const Shell& shell, double air_damping, double dt,
                                          Motion& motion, StepReport& report) {
  const double beta = config.beta, gamma = config.gamma;
  const Positions predicted = motion.positions + dt * motion.velocities +
                              dt * dt * (0.5 - beta) * motion.accelerations;
  const Positions velocity = motion.velocities + dt * (1 - gamma) * motion.accelerations;
  const double stiffness = (1 + air_damping * gamma * dt) / (beta * dt * dt);
  const Inertia inertia{stiffness, predicted - air_damping / stiffness * velocity};
  Positions x;
  if (!solve(shell, inertia, predicted, dt, motion, x, report)) return false;
  motion.accelerations = (x - predicted) / (beta * dt * dt);
  motion.velocities = velocity + gamma * dt * motion.accelerations;
  motion.positions = std::move(x);
  holdPinned(motion);
  return true;
}

// v' = (x' - x) / dt,   M (v' - v) / dt = -dW/dx - c M v'. It remembers no acceleration: those of
// a step much shorter or longer, multiplied by this one's dt^2, would throw the paper about.
bool Newmark::Implementation::backwardEulerStep(const Shell& shell, double air_damping, double dt,
                                                Motion& motion, StepReport& report) {
  const Positions predicted = motion.positions + dt * motion.velocities;
  const double damped = 1 + air_damping * dt;
  const Inertia inertia{damped / (dt * dt),
                        motion.positions + dt / damped * motion.velocities};
  Positions x;
  if (!solve(shell, inertia, predicted, dt, motion, x, report)) return false;
  motion.velocities = (x - motion.positions) / dt;
  motion.accelerations.setZero();
  motion.positions = std::move(x);
  holdPinned(motion);
  return true;
}

bool Newmark::Implementation::stepInParts(Shell& shell, double air_damping, Drive& drive,
                                          double from, double to, int depth, Motion& motion,
                                          StepReport& report) {
  drive.moveTo(to, shell);
  if (backwardEulerStep(shell, air_damping, (to - from) * config.time_step, motion, report)) {
    return true;
  }
  if (depth == kDeepest) return false;
  ++report.retries;
  const double middle = (from + to) / 2;
  return stepInParts(shell, air_damping, drive, from, middle, depth + 1, motion, report) &&
         stepInParts(shell, air_damping, drive, middle, to, depth + 1, motion, report);
}

StepReport Newmark::step(Shell& shell, double air_damping, Drive& drive, Motion& motion) {
  StepReport report;
  drive.moveTo(1, shell);
  if (implementation_->newmarkStep(shell, air_damping, implementation_->config.time_step, motion,
                                   report)) {
    return report;
  }
  ++report.retries;
  Motion trial = motion;
  report.converged = implementation_->stepInParts(shell, air_damping, drive, 0, 0.5, 1, trial, report) &&
                     implementation_->stepInParts(shell, air_damping, drive, 0.5, 1, 1, trial, report);
  if (report.converged) {
    report.failure.clear();
    motion = std::move(trial);
  }
  return report;
}

}  // namespace shell_origami
