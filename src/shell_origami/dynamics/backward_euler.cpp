#include <shell_origami/dynamics/backward_euler.h>

#include <utility>

namespace shell_origami {

// v' = (x' - x) / dt,   M (v' - v) / dt = -dW/dx - c M v'.
bool BackwardEuler::step(const StepInput& input, double dt, Motion& motion, StepReport& report) {
  const Positions predicted = motion.positions + dt * motion.velocities;
  const double damped = 1 + input.air_damping * dt;
  const Inertia inertia{damped / (dt * dt), motion.positions + dt / damped * motion.velocities};
  Positions x;
  if (!solver_.solve(input, inertia, predicted, dt, motion.positions, x, report)) return false;
  const Positions velocity = (x - motion.positions) / dt;
  motion.rough = solver_.rough();
  motion.accelerations = (velocity - motion.velocities) / dt;
  motion.velocities = velocity;
  motion.positions = std::move(x);
  return true;
}

}  // namespace shell_origami
