#include "verify/hanging.h"

#include "verify/clamped_sheet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shell_origami {

SimulationConfig hangingConfig(double gamma, double length, double swinging) {
  SimulationConfig config;
  config.material = strip();
  const double frequency = firstFrequency(config.material, swinging);
  config.material.air_damping = 4 * M_PI * frequency;
  config.gravity.z() = -gamma * config.material.bendingStiffness() /
                       (config.material.arealDensity() * std::pow(length, 3));
  config.solver.gamma = 1;
  config.solver.time_step = 0.05 / frequency;
  config.solver.tolerance = std::min(1.0, gamma) * 1e-5 * length * frequency;
  return config;
}

void comeToRest(Simulation& simulation) {
  constexpr int kMostSteps = 1000;
  do {
    const StepReport report = simulation.step();
    if (!report.converged) throw std::runtime_error("the hanging sheet: " + report.failure);
    if (simulation.counters().steps > kMostSteps) {
      throw std::runtime_error("the hanging sheet does not come to rest");
    }
  } while (simulation.velocities().colwise().norm().maxCoeff() >
           simulation.config().solver.tolerance);
}

}  // namespace shell_origami
