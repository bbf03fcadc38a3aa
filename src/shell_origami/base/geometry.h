/// \file
/// Points, vectors and plane geometry.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shell_origami {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
/// Points in space, one column a vertex [m].
using Positions = Eigen::Matrix3Xd;
/// Vertex ids, counter-clockwise seen from +z of the flat sheet.
using Triangle = std::array<int, 3>;
/// A straight line on the flat sheet, by its two ends [m].
using Segment = std::array<Vector2, 2>;

inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the signed area of the triangle a, b, c: positive when counter-clockwise.
inline double doubleArea(const Vector2& a, const Vector2& b, const Vector2& c) {
  return cross(b - a, c - a);
}

/// The matrix m of the cross product with a: m b = a x b.
inline Eigen::Matrix3d crossMatrix(const Vector3& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// Whether p lies inside the closed polygon or within `tolerance` [m] of its outline.
bool polygonContains(const std::vector<Vector2>& polygon, const Vector2& p, double tolerance);

/// Distance [m] from p to the segment a, b.
double distanceToSegment(const Vector2& p, const Vector2& a, const Vector2& b);

}  // namespace shell_origami
