/// \file
/// The sheet and the bodies around it as contact sees them: vertices, edges and faces.
#pragma once

#include <shell_origami/contact/crossings.h>
#include <shell_origami/contact/distance.h>
#include <shell_origami/contact/surface.h>
#include <shell_origami/sheet/sheet.h>

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

namespace shell_origami {

/// A rigid body that paper touches.
struct Body {
  std::shared_ptr<const Surface> surface;
  double friction = 0;  ///< Coulomb's coefficient, paper on it
};

/// The primitives that can touch each other: those of a sheet, or a sheet's and those of bodies.
/// Vertices and faces of bodies have the numbers after those of the sheet. Every vertex and every
/// edge belongs to one face, so that a pair of faces stands for pairs of primitives that no other
/// pair of faces stands for (representative triangles: Curtis, Tamstorf and Manocha, Fast Collision
/// Detection for Deformable Models, 2008).
class CollisionMesh {
 public:
  explicit CollisionMesh(const Sheet& sheet) : CollisionMesh(sheet, {}) {}
  /// With bodies the parts of the sheet do not touch each other, but the bodies alone.
  CollisionMesh(const Sheet& sheet, const std::vector<Body>& bodies);

  struct Face {
    Triangle vertices;
    std::array<int, 3> owned_vertices;  ///< -1 in place of those of another face
    std::array<int, 3> owned_edges;
  };

  int vertexCount() const { return static_cast<int>(rest_.size()); }
  const std::vector<Face>& faces() const { return faces_; }
  /// The first face of the sheet, of each body, and the number of faces.
  const std::vector<int>& firstFaces() const { return first_faces_; }
  int sheetFaceCount() const { return first_faces_[1]; }
  bool hasBodies() const { return !friction_.empty(); }
  const std::vector<std::array<int, 2>>& edges() const { return edges_; }
  /// Where vertices are on the flat sheet, in the plane z = 0, or in the frames of bodies [m].
  const std::vector<Vector3>& restPositions() const { return rest_; }
  /// Coulomb's coefficient of the body that the second of two faces belongs to.
  double bodyFriction(const TrianglePair& faces) const;

  /// Leaves out of contact what crosses already, with the faces around it, so that it can part.
  void leaveOut(const std::vector<TrianglePair>& crossing);
  bool leftOut(int f, int g) const {
    return !left_out_.empty() && left_out_.count({std::min(f, g), std::max(f, g)}) > 0;
  }

  /// Whether contact has nothing to do with the pair: its primitives share a vertex, or all four
  /// points are those of one hinge, whose energy keeps it open.
  bool incident(int vertex, int face) const;
  bool incidentEdges(int a, int b) const;

  /// Distance on the flat sheet [m]; 0 of the two sides of a slit, infinite to a body.
  double flatDistance(PairKind kind, const std::array<int, 4>& points) const;
  /// Squared product of the rest lengths of two edges [m^4].
  double squaredProduct(const std::array<int, 4>& points) const;

 private:
  void addBody(const Surface& surface);

  std::vector<Vector3> rest_;
  std::vector<int> first_faces_;
  std::vector<double> friction_;  ///< of each body
  double coincident_;             ///< distance on the flat sheet that is none [m]
  std::vector<Face> faces_;
  std::vector<std::array<int, 2>> edges_;
  std::vector<std::array<int, 2>> opposite_;  ///< of each edge
  std::vector<std::array<int, 3>> sides_;     ///< of each face: its edges
  std::set<TrianglePair> left_out_;
};

}  // namespace shell_origami
