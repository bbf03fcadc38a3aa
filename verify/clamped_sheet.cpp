#include "verify/clamped_sheet.h"

#include <shell_origami/mesh/triangulate.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {

ClampedSheet clampedSheet(double length, double aspect, int rows) {
  const double tall = std::sqrt(0.75);
  // Half a row more lies behind the clamp.
  const double whole = length * (rows + 0.5) / rows;
  const double max_edge = 1.001 * length / rows / tall;
  Sheet sheet(triangulateRectangle(whole, aspect * length, max_edge));
  const auto& flat = sheet.flatPositions();
  double second = whole;  // x of the second row
  for (const Vector2& p : flat) {
    if (p.x() > 1e-6 * length) second = std::min(second, p.x());
  }
  ClampedSheet result{std::move(sheet), second / 2, whole - second / 2, {}, {}};
  for (int v = 0; v < result.sheet.vertexCount(); ++v) {
    const double x = result.sheet.flatPositions()[v].x();
    if (x < 1.001 * second) result.held.push_back(v);
    if (x > whole - 1e-6 * length) result.tip.push_back(v);
  }
  return result;
}

Material strip() {
  Material material;
  material.poisson_ratio = 0;
  return material;
}

double firstFrequency(const Material& material, double length) {
  return 0.55959 * std::sqrt(material.bendingStiffness() / material.arealDensity()) /
         (length * length);
}

}  // namespace shell_origami
