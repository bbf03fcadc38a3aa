/// \file
/// Points of the paper that can be followed, and its sides.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <vector>

namespace shell_origami {

/// The sides of the paper as numbers in clouds and label images. The front is the one that +z of
/// the flat sheet points out of. In label images kFirstObstacle is the first obstacle, and each
/// other one is one more.
constexpr float kFrontSide = 0, kBackSide = 1, kFirstObstacle = 2;

/// A point of the paper, and the triangle in which it lies now.
struct MaterialPoint {
  Vector2 flat;  ///< [m]
  Triangulation::Location place;
};

/// About so many points of a square lattice on the flat sheet, row by row. They depend on the
/// sheet's outline and area alone: after a fold has divided the sheet into other triangles the
/// points are the same, to the bit and in the same order.
/// \pre count > 0
std::vector<MaterialPoint> sampleSheet(const Sheet& sheet, double count);

/// Where the point is in space.
/// \param positions  of the sheet's vertices
Vector3 inSpace(const MaterialPoint& point, const Sheet& sheet, const Positions& positions);

}  // namespace shell_origami
