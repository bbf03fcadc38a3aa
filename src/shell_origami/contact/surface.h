/// \file
/// The surfaces of rigid bodies that paper touches.
#pragma once

#include <shell_origami/base/geometry.h>

#include <vector>

namespace shell_origami {

/// Triangles in the frame of a body.
struct Surface {
  Positions vertices;           ///< [m]
  std::vector<Triangle> faces;  ///< counter-clockwise seen from outside
  /// A part of a plane, with the body below it. It has no border: where paper goes, it is moved
  /// along in its plane.
  bool half_space = false;
};

/// Largest number of vertices and of faces of a surface.
constexpr int kMostSurfaceParts = 100000;

/// Part of the plane z = 0 with `center` in its middle, which reaches `size` [m] in each direction.
Surface planePatch(const Vector3& center, double size);
/// A box with its center at the origin; `size` [m] along each axis.
Surface boxSurface(const Vector3& size);
/// A sphere about the origin, of 2,048 triangles with corners on it: 2e-3 of the radius too small
/// at most.
Surface sphereSurface(double radius);
/// A cylinder about the z axis, with the origin in its middle, as a prism of 96 sides with edges on
/// it: 5.4e-4 of the radius too small at most.
Surface cylinderSurface(double radius, double length);

/// Whether a point is inside the closed surface (the sum of solid angles: van Oosterom and Strackee
/// 1983). \pre it is not on it
bool contains(const Surface& surface, const Vector3& point);

}  // namespace shell_origami
