#include <shell_origami/dynamics/symplectic_euler.h>

#include <utility>

namespace shell_origami {

// M (v' - v) / dt = -dW/dx - c M v',   x' = x + dt v'. Air damping is taken at the end of the step,
// which costs nothing and bounds no step.
bool SymplecticEuler::step(const Loading& loading, double dt, Motion& motion, StepReport& report) {
  loading.shell.foldAngles(motion.positions, angles_);
  loading.shell.angleGradients(motion.positions, angle_gradients_);
  gradient_.setZero(3, motion.positions.cols());
  loading.shell.addGradient(motion.positions, angles_, angle_gradients_, gradient_);
  Positions velocity = motion.velocities;
  for (int v = 0; v < static_cast<int>(velocity.cols()); ++v) {
    if (loading.free[v]) {
      velocity.col(v) -= dt / loading.shell.masses()[v] * gradient_.col(v);
      velocity.col(v) /= 1 + loading.air_damping * dt;
    } else {
      velocity.col(v) = (loading.held.col(v) - motion.positions.col(v)) / dt;
    }
  }
  Positions x = motion.positions + dt * velocity;
  if (const auto fault = loading.shell.findInfeasibility(x, angles_)) {
    report.failure = std::string(fault->what) + ": the explicit step is too long";
    report.vertex = fault->vertex;
    return false;
  }
  motion.accelerations = (velocity - motion.velocities) / dt;
  motion.velocities = std::move(velocity);
  motion.positions = std::move(x);
  return true;
}

}  // namespace shell_origami
