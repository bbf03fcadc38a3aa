#include <shell_origami/contact/collision_mesh.h>

#include <algorithm>

namespace shell_origami {
namespace {

/// Distance on the flat sheet, as a part of its size, within which two things are in one place, as
/// in crossingSegments(). Where a side of a slit was split, that is by rounding off the other side.
constexpr double kCoincident = 1e-9;

bool contains(const Triangle& corners, int v) {
  return corners[0] == v || corners[1] == v || corners[2] == v;
}

}  // namespace

CollisionMesh::CollisionMesh(const Sheet& sheet)
    : flat_(sheet.flatPositions()), coincident_(kCoincident * sheet.size()) {
  for (const Edge& edge : sheet.edges()) {
    edges_.push_back(edge.vertices);
    opposite_.push_back(edge.opposite);
  }
  std::vector<bool> vertex_owned(flat_.size(), false), edge_owned(edges_.size(), false);
  const auto claim = [](std::vector<bool>& owned, int i) {
    const bool first = !owned[i];
    owned[i] = true;
    return first ? i : -1;
  };
  for (int f = 0; f < static_cast<int>(sheet.triangles().size()); ++f) {
    Face face{sheet.triangles()[f], {}, {}};
    std::array<int, 3> sides{};
    for (int k = 0; k < 3; ++k) {
      sides[k] = sheet.edgeIndex({f, k});
      face.owned_vertices[k] = claim(vertex_owned, face.vertices[k]);
      face.owned_edges[k] = claim(edge_owned, sides[k]);
    }
    faces_.push_back(face);
    sides_.push_back(sides);
  }
}

void CollisionMesh::leaveOut(const std::vector<TrianglePair>& crossing) {
  left_out_.clear();
  if (crossing.empty()) return;
  std::vector<std::vector<int>> around(flat_.size());
  for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
    for (int v : faces_[f].vertices) around[v].push_back(f);
  }
  for (const auto& [f, g] : crossing) {
    for (int v : faces_[f].vertices) {
      for (int w : faces_[g].vertices) {
        for (int near_f : around[v]) {
          for (int near_g : around[w]) {
            left_out_.insert({std::min(near_f, near_g), std::max(near_f, near_g)});
          }
        }
      }
    }
  }
}

bool CollisionMesh::incident(int vertex, int face) const {
  if (contains(faces_[face].vertices, vertex)) return true;
  return std::any_of(sides_[face].begin(), sides_[face].end(), [&](int edge) {
    return opposite_[edge][0] == vertex || opposite_[edge][1] == vertex;
  });
}

bool CollisionMesh::incidentEdges(int a, int b) const {
  const auto [a0, a1] = edges_[a];
  const auto [b0, b1] = edges_[b];
  if (a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1) return true;
  // Two sides of a hinge: an end of one lies across the other's face, over an edge that joins them.
  const auto opposes = [this](int edge, int v) {
    return opposite_[edge][0] == v || opposite_[edge][1] == v;
  };
  return (opposes(a, b0) || opposes(a, b1)) && (opposes(b, a0) || opposes(b, a1));
}

double CollisionMesh::flatDistance(PairKind kind, const std::array<int, 4>& points) const {
  PairPoints x;
  for (int i = 0; i < 4; ++i) x[i] << flat_[points[i]], 0;
  const double distance = closestPoints(kind, x).distance;
  return distance > coincident_ ? distance : 0;
}

double CollisionMesh::squaredProduct(const std::array<int, 4>& points) const {
  return (flat_[points[1]] - flat_[points[0]]).squaredNorm() *
         (flat_[points[3]] - flat_[points[2]]).squaredNorm();
}

}  // namespace shell_origami
