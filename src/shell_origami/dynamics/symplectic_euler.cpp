#include <shell_origami/dynamics/symplectic_euler.h>

#include <utility>

namespace shell_origami {

// M (v' - v) / dt = -dW/dx - c M v',   x' = x + dt v'. Air damping is taken at the end of the step,
// which costs nothing and bounds no step.
bool SymplecticEuler::step(const StepInput& input, double dt, Motion& motion, StepReport& report) {
  objective_.use(input.potentials, input.masses, nullptr);
  objective_.start(motion.positions);
  objective_.startGradient(motion.positions, gradient_);
  Positions velocity = motion.velocities;
  for (int v = 0; v < static_cast<int>(velocity.cols()); ++v) {
    if (input.free[v]) {
      velocity.col(v) -= dt / input.masses[v] * gradient_.col(v);
      velocity.col(v) /= 1 + input.air_damping * dt;
    } else {
      velocity.col(v) = (input.prescribed.col(v) - motion.positions.col(v)) / dt;
    }
  }
  Positions x = motion.positions + dt * velocity;
  if (const auto infeasibility = objective_.findInfeasibility(x)) {
    report.failure = std::string(infeasibility->what) + ": the explicit step is too long";
    report.vertex = infeasibility->vertex;
    return false;
  }
  motion.accelerations = (velocity - motion.velocities) / dt;
  motion.velocities = std::move(velocity);
  motion.positions = std::move(x);
  return true;
}

}  // namespace shell_origami
