#include <shell_origami/contact/candidates.h>

#include <shell_origami/contact/ccd.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace shell_origami {
namespace {

/// Reach of two primitives as a part of their distance on the flat sheet: beside a crease leaves
/// come as close as its angle makes them, which is above this up to 179.4 degrees.
constexpr double kReachPerDistance = 0.005;

/// Rows: the axes of a frame in which a stack of layers is flat, of the faces' normals weighted by
/// area. In boxes along other axes each layer of a tilted stack would meet all others.
Eigen::Matrix3d frameOfLayers(const CollisionMesh& mesh, const Positions& x) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (int f = 0; f < mesh.sheetFaceCount(); ++f) {
    const auto& [a, b, c] = mesh.faces()[f].vertices;
    const Vector3 normal = (x.col(b) - x.col(a)).cross(x.col(c) - x.col(a));
    const double length = normal.norm();
    if (length > 0) moments += normal * normal.transpose() / length;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().transpose();
}

}  // namespace

Candidates::Candidates(const CollisionMesh& mesh, const BoundingTree& tree, const Positions& from,
                       const Positions& to, double reach, double margin, std::size_t most)
    : reach_(reach),
      margin_(margin),
      turn_(frameOfLayers(mesh, from)),
      places_(turn_.lazyProduct(from.leftCols(mesh.vertexCount()))),
      ways_(turn_.lazyProduct(to.leftCols(mesh.vertexCount())) - places_) {
  Boxes boxes;
  boxes.faces.reserve(mesh.faces().size());
  for (const CollisionMesh::Face& face : mesh.faces()) boxes.faces.push_back(boxOf(face.vertices));
  boxes.edges.reserve(mesh.edges().size());
  for (const auto& edge : mesh.edges()) boxes.edges.push_back(boxOf(edge));
  std::atomic<std::size_t> count{0};
  tree.gatherPairs(
      boxes.faces, pairs_, [this](const MovingBox& a, const MovingBox& b) { return meet(a, b); },
      [&](int f, int g, std::vector<ContactPair>& pairs) {
        if (mesh.leftOut(f, g) || count > most) return;
        const std::size_t before = pairs.size();
        addPairs(mesh, boxes, f, g, pairs);
        addPairs(mesh, boxes, g, f, pairs);
        if (pairs.size() > before) count += pairs.size() - before;
      });
  complete_ = count <= most;
  if (!complete_) pairs_.clear();
}

MovingBox Candidates::boxOf(const std::array<int, 2>& edge) const {
  MovingBox box = boxOf(edge[0]);
  box.extend(boxOf(edge[1]));
  return box;
}

MovingBox Candidates::boxOf(const Triangle& face) const {
  MovingBox box = boxOf(face[0]);
  box.extend(boxOf(face[1]));
  box.extend(boxOf(face[2]));
  return box;
}

/// Adds the pairs of what f owns with g, and of its edges with those of g (once: f before g).
void Candidates::addPairs(const CollisionMesh& mesh, const Boxes& boxes, int f, int g,
                          std::vector<ContactPair>& pairs) const {
  const CollisionMesh::Face &own = mesh.faces()[f], &other = mesh.faces()[g];
  const auto& [a, b, c] = other.vertices;
  const TrianglePair pair{std::min(f, g), std::max(f, g)};
  for (int v : own.owned_vertices) {
    if (v < 0 || !meet(boxOf(v), boxes.faces[g]) || mesh.incident(v, g)) continue;
    add(mesh, PairKind::kVertexFace, {v, a, b, c}, pair, pairs);
  }
  if (f > g) return;
  for (int e : own.owned_edges) {
    if (e < 0) continue;
    if (!meet(boxes.edges[e], boxes.faces[g])) continue;
    for (int h : other.owned_edges) {
      if (h < 0 || mesh.incidentEdges(e, h) || !meet(boxes.edges[e], boxes.edges[h])) continue;
      const auto [a0, a1] = mesh.edges()[e];
      const auto [b0, b1] = mesh.edges()[h];
      add(mesh, PairKind::kEdgeEdge, {a0, a1, b0, b1}, pair, pairs);
    }
  }
}

void Candidates::add(const CollisionMesh& mesh, PairKind kind, const std::array<int, 4>& vertices,
                     const TrianglePair& faces, std::vector<ContactPair>& pairs) const {
  const double reach = kReachPerDistance * mesh.flatDistance(kind, vertices);
  // The sides of a slit coincide.
  if (reach == 0) return;
  // A pair is pushed before the guard stops it.
  pairs.push_back({kind, vertices, std::clamp(reach, 2 * kClosestGap, reach_), faces});
}

/// There is one part of the way from which each coordinate differs by the margin at most.
bool Candidates::cover(const Positions& x) const {
  double first = 0, last = kAhead;
  for (int v = 0; v < places_.cols(); ++v) {
    const Vector3 gone = turn_.lazyProduct(x.col(v)) - places_.col(v);
    for (int k = 0; k < 3; ++k) {
      const double way = ways_(k, v);
      if (way == 0) {
        if (!(std::abs(gone[k]) <= margin_)) return false;
        continue;
      }
      const double a = (gone[k] - margin_) / way, b = (gone[k] + margin_) / way;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
      // Not a number is in no room.
      if (!(first <= last) || std::isnan(a)) return false;
    }
  }
  return true;
}

}  // namespace shell_origami
