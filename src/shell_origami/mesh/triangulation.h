/// \file
/// A plane triangulation with neighbours and labelled edges, and the local changes of it.
#pragma once

#include <shell_origami/base/geometry.h>

#include <optional>
#include <vector>

namespace shell_origami {

/// Triangles that cover a part of the plane without overlap. Edge k of a triangle lies opposite
/// its corner k:
///
///            corner k
///            /      \            .
///      edge k+2    edge k+1
///          /          \          .
///   corner k+1 -edge k- corner k+2
///
/// An edge may carry a label (a crease's index): such an edge is never flipped, and a split hands
/// its label to both halves. All operations are local and keep every triangle counter-clockwise.
class Triangulation {
 public:
  static constexpr int kNone = -1;

  /// A side of a triangle.
  struct Side {
    int triangle = kNone;
    int edge = kNone;
  };
  /// A place inside or on the border of a triangle, with its barycentric coordinates.
  struct Location {
    int triangle = kNone;
    Vector3 weights = Vector3::Zero();
  };

  Triangulation() = default;
  /// \throws std::invalid_argument naming the place, for an index out of range, a clockwise or
  ///         flat triangle, an edge with more than two triangles, or a vertex in no triangle.
  Triangulation(std::vector<Vector2> points, std::vector<Triangle> triangles);

  const std::vector<Vector2>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// The triangle across the edge, or kNone on the border.
  int neighbour(Side side) const { return neighbours_[side.triangle][side.edge]; }
  /// The same edge seen from the other triangle. \pre not on the border
  Side opposite(Side side) const;
  int label(Side side) const { return labels_[side.triangle][side.edge]; }
  /// Labels the edge, on both of its sides.
  void setLabel(Side side, int label);
  /// The two ends of the edge, counter-clockwise around the triangle.
  std::array<int, 2> ends(Side side) const;
  /// The far corner of the edge's triangle.
  int apex(Side side) const { return triangles_[side.triangle][side.edge]; }
  /// The side whose ends are a and b, in either direction, if they share an edge.
  std::optional<Side> findSide(int a, int b) const;
  /// The corner of the triangle that is vertex v. \pre v is one of its corners
  int cornerOf(int triangle, int v) const;
  Vector2 centroid(int triangle) const;
  /// Triangles around v, counter-clockwise; on the border starting at the border.
  std::vector<int> around(int v) const;
  bool onBorder(int v) const;

  /// The triangle that p lies in; where several do, as on an edge or a slit, the first found. None
  /// off the triangulation (farther from it than `tolerance` [m]).
  std::optional<Location> locate(const Vector2& p, double tolerance) const;
  /// The place of p in a triangle that reaches from p towards `direction`. Where sides of a slit
  /// lie on each other this tells them apart. None where no paper lies that way.
  std::optional<Location> locateAhead(const Vector2& p, const Vector2& direction,
                                      double tolerance) const;
  /// The same as locate(), faster where p lies in or not far from the triangle `near`.
  std::optional<Location> locateNear(const Vector2& p, double tolerance, int near) const;

  /// Puts a vertex at p, which lies on the edge, and cuts both triangles in two. Returns it.
  int splitEdge(Side side, const Vector2& p);
  /// Puts a vertex at p, which lies inside the triangle, and cuts it in three. Returns it.
  int splitTriangle(int triangle, const Vector2& p);
  /// Whether the edge is inside, unlabelled, and the diagonal of a strictly convex quadrilateral.
  bool canFlip(Side side) const;
  /// Exchanges the edge for the other diagonal. \pre canFlip(side)
  void flip(Side side);
  /// Smallest double area that the triangles around v would have with v at p.
  double smallestAreaWithVertexAt(int v, const Vector2& p) const;
  /// Shifts v to p. \pre smallestAreaWithVertexAt(v, p) > 0
  void moveVertex(int v, const Vector2& p);
  /// Leaves nothing but points, triangles and labels to tell it from one that was made of them:
  /// around() starts the same way.
  void forgetHistory();

 private:
  Vector3 weightsAt(const Vector2& p, int triangle) const;
  double inwardness(int triangle, const Vector2& p, const Vector2& ahead, double tolerance) const;
  int addPoint(const Vector2& p);
  int addTriangle();
  void setTriangle(int t, const Triangle& corners, const std::array<int, 3>& neighbours,
                   const std::array<int, 3>& labels);
  void replaceNeighbour(int triangle, int from, int to);

  std::vector<Vector2> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<int, 3>> neighbours_;
  std::vector<std::array<int, 3>> labels_;
  std::vector<int> incident_;  ///< a triangle of each vertex
};

}  // namespace shell_origami
