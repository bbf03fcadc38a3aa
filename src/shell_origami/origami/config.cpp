#include <shell_origami/origami/config.h>

#include <shell_origami/origami/parameter_table.h>

namespace shell_origami {
namespace {

constexpr Bounds kCurvatureBounds{-1e4, 1e4};  ///< [1/m]

}  // namespace

void checkConfig(SimulationConfig config) {
  checkValues(simulationParameters(), config);
  checkValue("sheet/curvature", &config.rest.curvature, kCurvatureBounds);
}

}  // namespace shell_origami
