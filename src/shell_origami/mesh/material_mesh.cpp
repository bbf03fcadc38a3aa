#include <shell_origami/mesh/material_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// The paper counts as flat across an edge bent less than this. A point of the paper then moves
/// by at most a quarter of the edge times this when the edge is flipped.
constexpr double kNearlyFlat = 0.02;  // [rad]

}  // namespace

MaterialMesh::MaterialMesh(const Triangulation& mesh, const Positions* positions,
                           std::set<int> held, bool exact)
    : mesh_(mesh), held_(std::move(held)), exact_(exact) {
  if (positions) {
    for (Eigen::Index v = 0; v < positions->cols(); ++v) space_.push_back(positions->col(v));
  }
  Eigen::AlignedBox2d box;
  for (const Vector2& p : mesh_.points()) box.extend(p);
  size_ = box.sizes().maxCoeff();
}

void MaterialMesh::touch(int v) { touched_.push_back(v); }

int MaterialMesh::splitEdge(Triangulation::Side side, const Vector2& p) {
  const auto [a, b] = mesh_.ends(side);
  if (!space_.empty()) {
    const double s = (p - point(a)).norm() / (point(b) - point(a)).norm();
    space_.push_back((1 - s) * space_[a] + s * space_[b]);
  }
  const int v = mesh_.splitEdge(side, p);
  touch(v);
  return v;
}

int MaterialMesh::splitTriangle(int triangle, const Vector2& p) {
  if (!space_.empty()) {
    const Triangle& t = mesh_.triangles()[triangle];
    const Vector3 w(doubleArea(p, point(t[1]), point(t[2])),
                    doubleArea(point(t[0]), p, point(t[2])),
                    doubleArea(point(t[0]), point(t[1]), p));
    space_.push_back((w[0] * space_[t[0]] + w[1] * space_[t[1]] + w[2] * space_[t[2]]) / w.sum());
  }
  const int v = mesh_.splitTriangle(triangle, p);
  touch(v);
  return v;
}

void MaterialMesh::flip(Triangulation::Side side) {
  for (int v : mesh_.ends(side)) touch(v);
  mesh_.flip(side);
}

void MaterialMesh::shift(int v, const Vector2& p) {
  if (!space_.empty()) {
    // The triangle of the fan that holds p, or the one p is least outside of.
    double best = -1e300;
    Vector3 place = space_[v];
    for (int t : mesh_.around(v)) {
      const Triangle& c = mesh_.triangles()[t];
      const Vector3 w =
          Vector3(doubleArea(p, point(c[1]), point(c[2])), doubleArea(point(c[0]), p, point(c[2])),
                  doubleArea(point(c[0]), point(c[1]), p)) /
          doubleArea(point(c[0]), point(c[1]), point(c[2]));
      if (w.minCoeff() <= best) continue;
      best = w.minCoeff();
      place = w[0] * space_[c[0]] + w[1] * space_[c[1]] + w[2] * space_[c[2]];
    }
    space_[v] = place;
  }
  mesh_.moveVertex(v, p);
  touch(v);
}

MaterialMesh::Freedom MaterialMesh::freedom(int v) const {
  if (held_.count(v)) return {};
  // The edges at v that must keep their line: creases and border.
  std::vector<std::pair<int, int>> rails;  // far vertex, label
  for (int t : mesh_.around(v)) {
    const int k = mesh_.cornerOf(t, v);
    const Triangulation::Side left{t, (k + 1) % 3}, right{t, (k + 2) % 3};
    const Triangle& c = mesh_.triangles()[t];
    const auto bound = [&](Triangulation::Side side) {
      return mesh_.label(side) != Triangulation::kNone ||
             mesh_.neighbour(side) == Triangulation::kNone;
    };
    // Each edge once: the right side of every triangle, and the left one at the border's end.
    if (bound(right)) rails.emplace_back(c[(k + 1) % 3], mesh_.label(right));
    if (mesh_.neighbour(left) == Triangulation::kNone)
      rails.emplace_back(c[(k + 2) % 3], mesh_.label(left));
  }
  if (rails.empty()) return {Freedom::kFree, {-1, -1}};
  if (rails.size() != 2 || rails[0].second != rails[1].second) return {};
  const Vector2 &a = point(rails[0].first), &b = point(rails[1].first);
  const bool straight = std::abs(doubleArea(a, point(v), b)) <= 1e-12 * size_ * (b - a).norm() &&
                        (point(v) - a).dot(b - point(v)) > 0;
  if (!straight) return {};
  return {Freedom::kSlides, {rails[0].first, rails[1].first}};
}

bool MaterialMesh::nearlyFlatAcross(Triangulation::Side side) const {
  if (space_.empty() || mesh_.neighbour(side) == Triangulation::kNone) return true;
  if (exact_) return false;
  const auto normal = [this](int t) {
    const Triangle& c = mesh_.triangles()[t];
    return Vector3((space_[c[1]] - space_[c[0]]).cross(space_[c[2]] - space_[c[0]]));
  };
  const Vector3 n1 = normal(side.triangle), n2 = normal(mesh_.neighbour(side));
  return std::atan2(n1.cross(n2).norm(), n1.dot(n2)) < kNearlyFlat;
}

bool MaterialMesh::mayFlip(Triangulation::Side side) const {
  return mesh_.canFlip(side) && nearlyFlatAcross(side);
}

bool MaterialMesh::nearlyFlatAround(int v) const {
  const MaterialMesh::Freedom free = freedom(v);
  const std::vector<int> fan = mesh_.around(v);
  return std::all_of(fan.begin(), fan.end(), [&](int t) {
    const int k = mesh_.cornerOf(t, v);
    const Triangulation::Side side{t, (k + 2) % 3};
    // Along its own crease a vertex may slide however far that is bent.
    const int far = mesh_.triangles()[t][(k + 1) % 3];
    if (free.kind == Freedom::kSlides && (far == free.rail[0] || far == free.rail[1])) return true;
    return nearlyFlatAcross(side);
  });
}

double smallestAngle(const Vector2& a, const Vector2& b, const Vector2& c) {
  const auto angle = [](const Vector2& at, const Vector2& p, const Vector2& q) {
    return std::atan2(cross(p - at, q - at), (p - at).dot(q - at));
  };
  return std::min({angle(a, b, c), angle(b, c, a), angle(c, a, b)});
}

double MaterialMesh::smallestAngle(int v, const Vector2& p) const {
  double smallest = M_PI;
  for (int t : mesh_.around(v)) {
    const int k = mesh_.cornerOf(t, v);
    const Triangle& c = mesh_.triangles()[t];
    smallest = std::min(
        smallest, shell_origami::smallestAngle(p, point(c[(k + 1) % 3]), point(c[(k + 2) % 3])));
  }
  return smallest;
}

}  // namespace shell_origami
