/// \file
/// The sheet as contact sees it: vertices, edges and faces, and how far apart they are on it.
#pragma once

#include <shell_origami/contact/crossings.h>
#include <shell_origami/contact/distance.h>
#include <shell_origami/sheet/sheet.h>

#include <algorithm>
#include <set>
#include <vector>

namespace shell_origami {

/// The primitives of a sheet that can touch each other. Every vertex and every edge belongs to one
/// face, so that a pair of faces stands for pairs of primitives that no other pair of faces stands
/// for (representative triangles: Curtis, Tamstorf and Manocha, Fast Collision Detection for
/// Deformable Models, 2008).
class CollisionMesh {
 public:
  explicit CollisionMesh(const Sheet& sheet);

  struct Face {
    Triangle vertices;
    std::array<int, 3> owned_vertices;  ///< -1 in place of those of another face
    std::array<int, 3> owned_edges;
  };

  int vertexCount() const { return static_cast<int>(flat_.size()); }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<std::array<int, 2>>& edges() const { return edges_; }
  const std::vector<Vector2>& flatPositions() const { return flat_; }

  /// Leaves out of contact what crosses already, with the faces around it, so that it can part.
  void leaveOut(const std::vector<TrianglePair>& crossing);
  bool leftOut(int f, int g) const {
    return !left_out_.empty() && left_out_.count({std::min(f, g), std::max(f, g)}) > 0;
  }

  /// Whether contact has nothing to do with the pair: its primitives share a vertex, or all four
  /// points are those of one hinge, whose energy keeps it open.
  bool incident(int vertex, int face) const;
  bool incidentEdges(int a, int b) const;

  /// Distance on the flat sheet [m]; 0 of the two sides of a slit.
  double flatDistance(PairKind kind, const std::array<int, 4>& points) const;
  /// Squared product of the flat lengths of two edges [m^4].
  double squaredProduct(const std::array<int, 4>& points) const;

 private:
  std::vector<Vector2> flat_;
  double coincident_;  ///< distance on the flat sheet that is none [m]
  std::vector<Face> faces_;
  std::vector<std::array<int, 2>> edges_;
  std::vector<std::array<int, 2>> opposite_;  ///< of each edge
  std::vector<std::array<int, 3>> sides_;     ///< of each face: its edges
  std::set<TrianglePair> left_out_;
};

}  // namespace shell_origami
