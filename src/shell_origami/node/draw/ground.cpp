#include <shell_origami/node/draw/ground.h>

#include <shell_origami/node/draw/coloring.h>
#include <shell_origami/node/draw/marker.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace shell_origami {
namespace {

using visualization_msgs::Marker;

const std_msgs::ColorRGBA kGrid = color(0.66, 0.68, 0.71);
const std_msgs::ColorRGBA kShadow = color(0.74, 0.75, 0.78);
/// Lines on either side of the middle.
constexpr int kReach = 10;
/// From one ground to the next over the size of the sheet. Paper falls at some 2 m/s: the grounds
/// of closer ones would flicker.
constexpr double kFall = 4;

/// The largest of 1, 2 and 5 times a power of ten that is not above a value.
double roundedDown(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double multiple : {5, 2}) {
    if (multiple * decade <= value * (1 + 1e-9)) return multiple * decade;
  }
  return decade;
}

/// The middle of the box around the paper.
Eigen::Vector3d middle(const Eigen::Matrix3Xd& positions) {
  return (positions.rowwise().minCoeff() + positions.rowwise().maxCoeff()) / 2;
}

}  // namespace

double groundBelow(const Eigen::Matrix3Xd& positions, double size) {
  return std::min(middle(positions).z() - 0.55 * size, positions.row(2).minCoeff() - 0.05 * size);
}

double groundUnder(const Eigen::Matrix3Xd& positions, double size, double ground) {
  const double fallen = ground - middle(positions).z();
  if (!(fallen > 0) || !std::isfinite(fallen)) return ground;
  return ground - kFall * size * std::ceil(fallen / (kFall * size));
}

Marker groundGrid(const Eigen::Matrix3Xd& positions, double size, double ground,
                  const std_msgs::Header& header) {
  Marker marker = newMarker("ground", Marker::LINE_LIST, header);
  marker.scale.x = size / 400;
  marker.color = kGrid;
  // As much above the shadow as keeps the two apart in rviz.
  marker.pose.position.z = ground + size / 1000;
  const Eigen::Vector3d center = middle(positions);
  if (!center.allFinite()) return finished(marker);
  const double spacing = roundedDown(size / 3);
  const double x = spacing * std::round(center.x() / spacing);
  const double y = spacing * std::round(center.y() / spacing);
  const double reach = kReach * spacing;
  for (int i = -kReach; i <= kReach; ++i) {
    const double along = i * spacing;
    marker.points.push_back(markerPoint({x + along, y - reach, 0}));
    marker.points.push_back(markerPoint({x + along, y + reach, 0}));
    marker.points.push_back(markerPoint({x - reach, y + along, 0}));
    marker.points.push_back(markerPoint({x + reach, y + along, 0}));
  }
  return finished(marker);
}

Marker shadow(const Eigen::Matrix3Xd& positions, double size, double ground,
              const msg::Sheet& sheet, const std_msgs::Header& header) {
  Marker marker = newMarker("shadow", Marker::TRIANGLE_LIST, header);
  marker.color.a = 1;
  const Eigen::Vector3d& light = lightDirection();
  for (const auto& triangle : sheet.triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    bool above = true;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = positions.col(triangle.vertex_indices[k]);
      const double height = p.z() - ground;
      above = above && height > 0;
      corners[k] = p - height / light.z() * light;
    }
    const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    // rviz cannot draw triangles without area (rviz #925).
    if (!above || !(area > 1e-9 * size * size)) continue;
    for (const Eigen::Vector3d& corner : corners) marker.points.push_back(markerPoint(corner));
    marker.colors.push_back(kShadow);
  }
  return finished(marker);
}

}  // namespace shell_origami
