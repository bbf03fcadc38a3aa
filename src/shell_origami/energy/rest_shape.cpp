#include <shell_origami/energy/rest_shape.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// Paper is not pressed shut: it rests short of 180 degrees.
constexpr double kLastSet = 170 * M_PI / 180;

/// Returns the position of a flat point on the rolled sheet.
Vector3 rolledUp(const Vector2& flat, const NaturalCurvature& roll) {
  const Vector2 axis(std::cos(roll.axis), std::sin(roll.axis));
  const Vector2 around(axis.y(), -axis.x());
  const double angle = roll.curvature * around.dot(flat);
  Vector3 place;
  place.head<2>() = axis.dot(flat) * axis + std::sin(angle) / roll.curvature * around;
  place.z() = (1 - std::cos(angle)) / roll.curvature;
  return place;
}

}  // namespace

RestShape::RestShape(const NaturalCurvature& roll, const Sheet& sheet)
    : RestShape(roll, sheet, std::vector<double>(sheet.edges().size()),
                std::vector<double>(sheet.edges().size())) {}

RestShape::RestShape(const NaturalCurvature& roll, const Sheet& sheet, std::vector<double> set,
                     std::vector<double> plastic)
    : roll_(roll), set_(std::move(set)), plastic_(std::move(plastic)) {
  this->roll(sheet);
}

void RestShape::roll(const Sheet& sheet) {
  rolled_.assign(sheet.edges().size(), 0);
  if (roll_.curvature == 0) return;
  for (std::size_t j = 0; j < sheet.edges().size(); ++j) {
    const Edge& edge = sheet.edges()[j];
    if (edge.onBorder()) continue;
    const auto at = [&](int v) { return rolledUp(sheet.flatPositions()[v], roll_); };
    rolled_[j] = foldAngle({at(edge.vertices[0]), at(edge.vertices[1]), at(edge.opposite[0]),
                            at(edge.opposite[1])})
                     .radians;
  }
}

void RestShape::apply(const Shell& shell, RestState& rest) const {
  for (int j = 0; j < static_cast<int>(shell.hinges().size()); ++j) {
    const Hinge& hinge = shell.hinges()[j];
    if (hinge.crease < 0) Shell::setRestAngle(j, rolled_[hinge.edge] + set_[hinge.edge], rest);
  }
}

void RestShape::follow(const Remap& remap, const Sheet& after) {
  const auto follow = [&remap](std::vector<double>& values) {
    std::vector<double> followed;
    for (int edge : remap.edges) followed.push_back(edge == Remap::kNone ? 0 : values[edge]);
    values = std::move(followed);
  };
  follow(set_);
  follow(plastic_);
  roll(after);
}

void RestShape::yield(const Material& material, const CurvatureFit& fit, const Positions& positions,
                      const Shell& shell, RestState& rest) {
  if (material.yield_curvature == 0) return;
  std::vector<int> hinges;
  std::vector<double> bends;  // of each of them, from rest [rad]
  for (int j = 0; j < static_cast<int>(shell.hinges().size()); ++j) {
    if (shell.hinges()[j].crease >= 0) continue;
    hinges.push_back(j);
    bends.push_back(shell.foldAngle(j, positions) - rest.angles[j].radians);
  }
  const std::vector<Curvature> curvatures = fit.edgeCurvatures(bends);
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const int edge = shell.hinges()[hinges[i]].edge;
    const double bent = std::abs(largestPrincipal(curvatures[i]));
    const double limit =
        std::max(0.0, material.yield_curvature + material.hardening * plastic_[edge]);
    if (bent <= limit) continue;
    const double flow = std::min((bent - limit) / (1 + material.hardening), bent);
    plastic_[edge] += flow;
    set_[edge] = std::clamp(set_[edge] + flow / bent * bends[i], -kLastSet - rolled_[edge],
                            kLastSet - rolled_[edge]);
    Shell::setRestAngle(hinges[i], rolled_[edge] + set_[edge], rest);
  }
}

}  // namespace shell_origami
