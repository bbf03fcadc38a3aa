#include <shell_origami/dynamics/newmark.h>

#include <algorithm>

namespace shell_origami {
namespace {

/// Which part of the accelerations `before` those `after` are, 0 to 1, masses weighed.
double keptPart(const Positions& before, const Positions& after, const Eigen::VectorXd& masses) {
  const double all = before.colwise().squaredNorm().dot(masses.transpose());
  const double kept = before.cwiseProduct(after).colwise().sum().dot(masses.transpose());
  return all > 0 ? std::clamp(kept / all, 0.0, 1.0) : 1;
}

}  // namespace

Newmark::Newmark(const SolverConfig& config, ImplicitSolver& solver)
    : beta_(config.beta != 0 ? config.beta : (config.gamma + 0.5) * (config.gamma + 0.5) / 4),
      gamma_(config.gamma),
      solver_(solver) {}

// With x_pred = x + dt v + dt^2 (1/2 - beta) a and v_pred = v + dt (1 - gamma) a the scheme says
//   a' = (x' - x_pred) / (beta dt^2),   v' = v_pred + gamma dt a'.
// M a' = -dW/dx - c M v' is then the minimum of W + s/2 |x' - anchor|^2_M with
//   s = (1 + c gamma dt) / (beta dt^2),   anchor = x_pred - (c / s) v_pred.
bool Newmark::step(const StepInput& input, double dt, Motion& motion, StepReport& report) {
  predicted_ =
      motion.positions + dt * motion.velocities + dt * dt * (0.5 - beta_) * motion.accelerations;
  velocity_ = motion.velocities + dt * (1 - gamma_) * motion.accelerations;
  const double damping = input.air_damping;
  inertia_.stiffness = (1 + damping * gamma_ * dt) / (beta_ * dt * dt);
  inertia_.anchor = predicted_ - damping / inertia_.stiffness * velocity_;
  // As if as much of the accelerations stayed as last time: all of them, while paper is folded
  // smoothly; none, where it snaps, and what they would throw it to costs several factorizations.
  start_ = motion.positions + dt * motion.velocities +
           motion.acceleration_persistence * dt * dt / 2 * motion.accelerations;
  if (!solver_.solve(input, inertia_, start_, dt, motion.positions, x_, report)) return false;
  acceleration_before_.swap(motion.accelerations);
  velocity_before_.swap(motion.velocities);
  motion.accelerations = (x_ - predicted_) / (beta_ * dt * dt);
  motion.velocities = velocity_ + gamma_ * dt * motion.accelerations;
  for (int v = 0; v < static_cast<int>(x_.cols()); ++v) {
    if (input.free[v]) continue;
    motion.velocities.col(v) = (x_.col(v) - motion.positions.col(v)) / dt;
    motion.accelerations.col(v) = (motion.velocities.col(v) - velocity_before_.col(v)) / dt;
  }
  motion.acceleration_persistence =
      keptPart(acceleration_before_, motion.accelerations, input.masses);
  motion.positions.swap(x_);
  return true;
}

}  // namespace shell_origami
