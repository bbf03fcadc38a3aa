#include <shell_origami/origami/config.h>

#include <shell_origami/base/error.h>

#include <cmath>

namespace shell_origami {
namespace {

void checkPositive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) reject(name, " must be positive, not ", value);
}

void checkRange(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    reject(name, " must be from ", low, " to ", high, ", not ", value);
  }
}

}  // namespace

void checkConfig(const SimulationConfig& config) {
  checkPositive("material/youngs_modulus", config.material.youngs_modulus);
  checkRange("material/poisson_ratio", config.material.poisson_ratio, 0, 0.49);
  checkPositive("material/thickness", config.material.thickness);
  checkPositive("material/density", config.material.density);
  checkRange("material/crease_stiffness", config.material.crease_stiffness, 1e-9, 100);
  checkRange("material/air_damping", config.material.air_damping, kAirDampingBounds.low,
             kAirDampingBounds.high);
  checkRange("material/yield_curvature", config.material.yield_curvature, 0, 1e6);
  checkRange("material/hardening", config.material.hardening, -0.99, 1e6);
  checkRange("sheet/curvature", config.rest.curvature, -1e4, 1e4);
  for (int i = 0; i < 3; ++i) {
    checkRange("gravity", config.gravity[i], kGravityBounds.low, kGravityBounds.high);
  }
  checkRange("solver/time_step", config.solver.time_step, 1e-8, 1);
  if (config.solver.beta != 0) checkRange("solver/beta", config.solver.beta, 1e-3, 1);
  checkRange("solver/gamma", config.solver.gamma, 0.5, 1);
  checkPositive("solver/tolerance", config.solver.tolerance);
  checkRange("solver/max_iterations", config.solver.max_iterations, 1, 1000);
  checkPositive("fold_duration", config.fold_duration);
}

}  // namespace shell_origami
