/// \file
/// Distance of a vertex to a face and of two edges in space.
#pragma once

#include <shell_origami/base/geometry.h>

#include <array>

namespace shell_origami {

/// The two kinds of primitive pairs in which triangles touch. Points are in the order
///   kVertexFace: the vertex, then the three corners of the face
///   kEdgeEdge:   the ends of one edge, then those of the other one
enum class PairKind { kVertexFace, kEdgeEdge };

using PairPoints = std::array<Vector3, 4>;

/// Number of points that belong to the first primitive of a pair.
constexpr int firstSize(PairKind kind) { return kind == PairKind::kVertexFace ? 1 : 2; }

/// The closest points of two primitives. Their difference, from the second one to the first, is the
/// sum of weights[i] * x[i]: the weights are the points' barycentric coordinates, of the second
/// primitive negative.
struct ClosestPoints {
  std::array<double, 4> weights;
  Vector3 difference;  ///< [m]
  double distance;     ///< its length [m]

  /// From the second primitive to the first; no finite number where they touch.
  Vector3 direction() const { return difference / distance; }
};

/// Ericson, Real-Time Collision Detection (2005), sections 5.1.5 and 5.1.9. The derivative of the
/// distance by x[i] is weights[i] * direction(), wherever the closest points are unique.
ClosestPoints closestPoints(PairKind kind, const PairPoints& x);

/// d^2 distance / dx^2 with the closest points free to move along the faces and edges that they lie
/// on. \pre the distance is not 0
Eigen::Matrix<double, 12, 12> distanceHessian(const PairPoints& x, PairKind kind,
                                              const ClosestPoints& closest);

}  // namespace shell_origami
