#include <shell_origami/energy/in_plane_set.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

double norm(const GreenStrain& e) { return std::sqrt(e[0] * e[0] + e[1] * e[1] + 2 * e[2] * e[2]); }

/// The largest change of a length, over that length.
double largestStretch(const GreenStrain& e) {
  const double mean = (e[0] + e[1]) / 2, radius = std::hypot((e[0] - e[1]) / 2, e[2]);
  const double long_way = std::sqrt(1 + 2 * (mean + radius)) - 1;
  const double short_way = 1 - std::sqrt(std::max(0.0, 1 + 2 * (mean - radius)));
  return std::max(long_way, short_way);
}

GreenStrain strainOf(const Sheet& sheet, int triangle, const Positions& positions) {
  const Triangle& t = sheet.triangles()[triangle];
  const auto& flat = sheet.flatPositions();
  Eigen::Matrix2d before;
  before << flat[t[1]] - flat[t[0]], flat[t[2]] - flat[t[0]];
  Eigen::Matrix<double, 3, 2> after;
  after << positions.col(t[1]) - positions.col(t[0]), positions.col(t[2]) - positions.col(t[0]);
  const Eigen::Matrix2d e = greenStrain(after * before.inverse());
  return {e(0, 0), e(1, 1), e(0, 1)};
}

}  // namespace

void InPlaneSet::apply(const Shell& shell, RestState& rest) const {
  for (std::size_t i = 0; i < strains_.size(); ++i) {
    shell.setRestStrain(static_cast<int>(i), strains_[i], rest);
  }
}

void InPlaneSet::follow(const Remap& remap) {
  std::vector<GreenStrain> followed;
  for (int triangle : remap.triangles) followed.push_back(strains_[triangle]);
  strains_ = std::move(followed);
}

void InPlaneSet::flow(double yield, const Sheet& sheet, const Positions& positions,
                      const Shell& shell, RestState& rest) {
  for (std::size_t i = 0; i < strains_.size(); ++i) {
    const int triangle = static_cast<int>(i);
    const GreenStrain total = strainOf(sheet, triangle, positions);
    const double stress = rest.membrane[i] * norm(total);
    const GreenStrain excess =
        stress > yield ? GreenStrain((1 - yield / stress) * total) : GreenStrain::Zero();
    if (excess == strains_[i]) continue;
    strains_[i] = excess;
    shell.setRestStrain(triangle, strains_[i], rest);
  }
}

double InPlaneSet::length(int triangle, const Vector2& flat) const {
  return std::sqrt(flat.dot(metricOf(strains_[triangle]) * flat));
}

InPlaneSet::Size InPlaneSet::size(const Sheet& sheet) const {
  const auto& flat = sheet.flatPositions();
  Size size;
  double area = 0;
  for (std::size_t i = 0; i < strains_.size(); ++i) {
    const Triangle& t = sheet.triangles()[i];
    const double own = doubleArea(flat[t[0]], flat[t[1]], flat[t[2]]) / 2;
    const double stretch = largestStretch(strains_[i]);
    size.mean += own * stretch;
    size.worst = std::max(size.worst, stretch);
    area += own;
  }
  size.mean /= area;
  return size;
}

}  // namespace shell_origami
