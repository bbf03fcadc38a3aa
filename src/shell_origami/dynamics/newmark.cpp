#include <shell_origami/dynamics/newmark.h>

#include <algorithm>

namespace shell_origami {
namespace {

/// Returns the part of the accelerations `before` that persists in `after`, 0 to 1, by mass.
double keptPart(const Positions& before, const Positions& after, const Eigen::VectorXd& masses) {
  const double all = before.colwise().squaredNorm().dot(masses.transpose());
  const double kept = before.cwiseProduct(after).colwise().sum().dot(masses.transpose());
  return all > 0 ? std::clamp(kept / all, 0.0, 1.0) : 1;
}

/// The part of a step's kinetic energy by which its energy may rise, where no work is done on the
/// paper, times gamma - 1/2: the less the scheme damps, the more the energy rises and falls by
/// itself. At the default gamma swinging paper rises by 0.12 at most, and mostly falls.
constexpr double kRise = 0.01;

}  // namespace

Newmark::Newmark(const SolverConfig& config, ImplicitSolver& solver)
    : tolerance_(config.tolerance),
      beta_(config.beta != 0 ? config.beta : (config.gamma + 0.5) * (config.gamma + 0.5) / 4),
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
  // Assumes that accelerations persist as far as in the last step: completely while paper is folded
  // smoothly, not at all where it snaps, where a wrong start would cost several factorizations.
  start_ = motion.positions + dt * motion.velocities +
           motion.acceleration_persistence * dt * dt / 2 * motion.accelerations;
  if (!solver_.solve(input, inertia_, start_, dt, motion.positions, x_, report)) return false;
  acceleration_after_ = (x_ - predicted_) / (beta_ * dt * dt);
  velocity_after_ = velocity_ + gamma_ * dt * acceleration_after_;
  for (int v = 0; v < static_cast<int>(x_.cols()); ++v) {
    if (input.free[v]) continue;
    velocity_after_.col(v) = (x_.col(v) - motion.positions.col(v)) / dt;
    acceleration_after_.col(v) = (velocity_after_.col(v) - motion.velocities.col(v)) / dt;
  }
  if (gainsEnergy(input, motion)) {
    report.failure = "the step gained energy";
    return false;
  }
  motion.acceleration_persistence =
      keptPart(motion.accelerations, acceleration_after_, input.masses);
  motion.rough = solver_.rough();
  motion.positions.swap(x_);
  motion.velocities.swap(velocity_after_);
  motion.accelerations.swap(acceleration_after_);
  return true;
}

/// Whether the step's energy rises though no work is done on the paper. Beyond linear problems
/// Newmark's scheme may feed motion of a few steps' period: a corner of paper that snaps to and fro
/// between two dents never came to rest.
bool Newmark::gainsEnergy(const StepInput& input, const Motion& motion) {
  if (!input.constant || gamma_ <= 0.5) return false;
  const double before = kineticEnergy(motion.velocities, input.masses);
  const double after = kineticEnergy(velocity_after_, input.masses);
  const double unseen = input.masses.sum() * tolerance_ * tolerance_ / 2;
  const double rise = after - before + solver_.potentialChange(motion.positions, x_);
  return rise > kRise / (gamma_ - 0.5) * (before + after) + unseen;
}

}  // namespace shell_origami
