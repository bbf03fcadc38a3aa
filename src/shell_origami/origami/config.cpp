#include <shell_origami/origami/config.h>

#include <shell_origami/origami/parameter_table.h>

namespace shell_origami {
namespace {

constexpr Bounds kCurvatureBounds{-1e4, 1e4};  ///< [1/m]

/// Speed [m/s] below which friction holds paper with less than its bound.
constexpr double kSticking = 1e-4;

}  // namespace

void checkConfig(SimulationConfig config) {
  checkValues(simulationParameters(), config);
  checkValue("sheet/curvature", &config.rest.curvature, kCurvatureBounds);
}

// Pairs in contact are as stiff as creases lever the paper against itself; a softer barrier lets
// gaps shrink to nothing, and steps take a hundred iterations.
ContactParameters contactParameters(const SimulationConfig& config) {
  constexpr double kPart = 0.02;  // of the membrane's stiffness
  return {config.contact.distance,
          kPart * config.material.youngs_modulus * config.material.thickness,
          config.contact.friction, kSticking * config.solver.time_step};
}

}  // namespace shell_origami
