#include <shell_origami/contact/candidates.h>

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace shell_origami {
namespace {

/// Reach of two primitives as a part of their distance on the flat sheet: beside a crease leaves
/// come as close as its angle makes them, which is above this up to 179.4 degrees.
constexpr double kReachPerDistance = 0.005;

/// Rows: the axes of a frame in which a stack of layers is flat, of the faces' normals weighted by
/// area. In boxes along other axes each layer of a tilted stack would meet all others.
Eigen::Matrix3d frameOfLayers(const CollisionMesh& mesh, const Positions& x) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const CollisionMesh::Face& face : mesh.faces()) {
    const auto& [a, b, c] = face.vertices;
    const Vector3 normal = (x.col(b) - x.col(a)).cross(x.col(c) - x.col(a));
    const double length = normal.norm();
    if (length > 0) moments += normal * normal.transpose() / length;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().transpose();
}

}  // namespace

Candidates::Candidates(const CollisionMesh& mesh, const BoundingTree& tree, const Positions& from,
                       const Positions& to, double reach, double margin, std::size_t most)
    : reach_(reach), most_(most), turn_(frameOfLayers(mesh, from)), rooms_(mesh.vertexCount()) {
  const Vector3 around = Vector3::Constant(margin);
  const Vector3 near = Vector3::Constant(kNear * reach / 2);
  std::vector<Eigen::AlignedBox3d> inflated(rooms_.size());
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    Eigen::AlignedBox3d box(turn_ * from.col(v));
    box.extend(Vector3(turn_ * to.col(v)));
    rooms_[v] = {box.min() - around, box.max() + around};
    inflated[v] = {rooms_[v].min() - near, rooms_[v].max() + near};
  }
  tree.forEachPair(mesh, inflated, [&](int f, int g) {
    if (mesh.leftOut(f, g)) return;
    addPairs(mesh, inflated, f, g);
    addPairs(mesh, inflated, g, f);
  });
}

/// Adds the pairs of what f owns with g, and of its edges with those of g (once: f before g).
void Candidates::addPairs(const CollisionMesh& mesh, const std::vector<Eigen::AlignedBox3d>& rooms,
                          int f, int g) {
  const CollisionMesh::Face &own = mesh.faces()[f], &other = mesh.faces()[g];
  const auto& [a, b, c] = other.vertices;
  const TrianglePair faces{std::min(f, g), std::max(f, g)};
  const Eigen::AlignedBox3d box = rooms[a].merged(rooms[b]).merged(rooms[c]);
  for (int v : own.owned_vertices) {
    if (v < 0 || !rooms[v].intersects(box) || mesh.incident(v, g)) continue;
    add(mesh, PairKind::kVertexFace, {v, a, b, c}, faces);
  }
  if (f > g) return;
  for (int e : own.owned_edges) {
    if (e < 0) continue;
    const auto [a0, a1] = mesh.edges()[e];
    const Eigen::AlignedBox3d edge_box = rooms[a0].merged(rooms[a1]);
    if (!edge_box.intersects(box)) continue;
    for (int h : other.owned_edges) {
      if (h < 0) continue;
      const auto [b0, b1] = mesh.edges()[h];
      if (!edge_box.intersects(rooms[b0].merged(rooms[b1])) || mesh.incidentEdges(e, h)) continue;
      add(mesh, PairKind::kEdgeEdge, {a0, a1, b0, b1}, faces);
    }
  }
}

void Candidates::add(const CollisionMesh& mesh, PairKind kind, const std::array<int, 4>& vertices,
                     const TrianglePair& faces) {
  const double reach = kReachPerDistance * mesh.flatDistance(kind, vertices);
  // The sides of a slit coincide.
  if (reach == 0) return;
  complete_ = pairs_.size() < most_;
  if (complete_) pairs_.push_back({kind, vertices, std::min(reach, reach_), faces});
}

bool Candidates::cover(const Positions& x) const {
  for (std::size_t v = 0; v < rooms_.size(); ++v) {
    if (!rooms_[v].contains(Vector3(turn_ * x.col(v)))) return false;
  }
  return true;
}

}  // namespace shell_origami
