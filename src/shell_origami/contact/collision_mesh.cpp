#include <shell_origami/contact/collision_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// Distance on the flat sheet, as a part of its size, within which two things are in one place, as
/// in crossingSegments(). Where a side of a slit was split, that is by rounding off the other side.
constexpr double kCoincident = 1e-9;

/// Sine of the angle below which two faces of a body lie in one plane.
constexpr double kFlat = 1e-9;

bool hasCorner(const Triangle& corners, int v) {
  return corners[0] == v || corners[1] == v || corners[2] == v;
}

}  // namespace

CollisionMesh::CollisionMesh(const Sheet& sheet, const std::vector<Body>& bodies)
    : coincident_(kCoincident * sheet.size()) {
  for (const Vector2& p : sheet.flatPositions()) rest_.emplace_back(p.x(), p.y(), 0);
  for (const Edge& edge : sheet.edges()) {
    edges_.push_back(edge.vertices);
    opposite_.push_back(edge.opposite);
  }
  std::vector<bool> vertex_owned(rest_.size(), false), edge_owned(edges_.size(), false);
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
  first_faces_ = {0, static_cast<int>(faces_.size())};
  for (const Body& body : bodies) {
    addBody(*body.surface);
    friction_.push_back(body.friction);
    first_faces_.push_back(static_cast<int>(faces_.size()));
  }
}

/// Adds the faces of a body with the vertices and edges at which its surface bends. Paper that
/// passes an edge between faces in one plane passes their corners or their borders as well.
void CollisionMesh::addBody(const Surface& surface) {
  const int first_vertex = static_cast<int>(rest_.size());
  for (int v = 0; v < surface.vertices.cols(); ++v) rest_.push_back(surface.vertices.col(v));
  const auto normal = [&](const Triangle& t) {
    const auto at = [&](int k) { return Vector3(surface.vertices.col(t[k])); };
    return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  };
  struct Side {
    int face, place;
  };
  std::map<std::pair<int, int>, std::vector<Side>> sides;
  for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f) {
    const Triangle& t = surface.faces[f];
    Face face{t, {-1, -1, -1}, {-1, -1, -1}};
    for (int& v : face.vertices) v += first_vertex;
    faces_.push_back(face);
    sides_.push_back({-1, -1, -1});
    for (int k = 0; k < 3; ++k) sides[std::minmax(t[k], t[(k + 1) % 3])].push_back({f, k});
  }
  if (surface.half_space) return;
  const int first_face = static_cast<int>(faces_.size() - surface.faces.size());
  std::vector<bool> owned(rest_.size(), false);
  for (const auto& [ends, around] : sides) {
    const bool flat =
        around.size() == 2 &&
        normal(surface.faces[around[0].face]).cross(normal(surface.faces[around[1].face])).norm() <
            kFlat;
    if (flat) continue;
    Face& face = faces_[first_face + around[0].face];
    face.owned_edges[around[0].place] = static_cast<int>(edges_.size());
    edges_.push_back({first_vertex + ends.first, first_vertex + ends.second});
    opposite_.push_back({-1, -1});
    for (int k = 0; k < 3; ++k) {
      const int v = face.vertices[k];
      if ((v != edges_.back()[0] && v != edges_.back()[1]) || owned[v]) continue;
      owned[v] = true;
      face.owned_vertices[k] = v;
    }
  }
}

double CollisionMesh::bodyFriction(const TrianglePair& faces) const {
  const auto after = std::upper_bound(first_faces_.begin(), first_faces_.end(), faces[1]);
  return friction_[after - first_faces_.begin() - 2];
}

void CollisionMesh::leaveOut(const std::vector<TrianglePair>& crossing) {
  left_out_.clear();
  if (crossing.empty()) return;
  std::vector<std::vector<int>> around(rest_.size());
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
  if (hasCorner(faces_[face].vertices, vertex)) return true;
  return face < sheetFaceCount() &&
         std::any_of(sides_[face].begin(), sides_[face].end(), [&](int edge) {
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
  if (hasBodies()) return std::numeric_limits<double>::infinity();
  PairPoints x;
  for (int i = 0; i < 4; ++i) x[i] = rest_[points[i]];
  const double distance = closestPoints(kind, x).distance;
  return distance > coincident_ ? distance : 0;
}

double CollisionMesh::squaredProduct(const std::array<int, 4>& points) const {
  return (rest_[points[1]] - rest_[points[0]]).squaredNorm() *
         (rest_[points[3]] - rest_[points[2]]).squaredNorm();
}

}  // namespace shell_origami
