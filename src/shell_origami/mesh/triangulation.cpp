#include <shell_origami/mesh/triangulation.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// Triangles that locateNear() looks at before it asks them all.
constexpr std::size_t kNearby = 60;
/// A barycentric coordinate as negative as this counts as zero: p lies on the edge.
constexpr double kRounding = 1e-12;
/// A direction within this angle of a side leads along it [rad].
constexpr double kAlongSide = 1e-7;

int next(int k) { return k == 2 ? 0 : k + 1; }
int previous(int k) { return k == 0 ? 2 : k - 1; }

void checkTriangle(const std::vector<Vector2>& points, const Triangle& triangle, std::size_t t) {
  for (int v : triangle) {
    if (v < 0 || v >= static_cast<int>(points.size())) {
      reject("triangle ", t, " names vertex ", v, ", but there are ", points.size());
    }
  }
  const double area2 = doubleArea(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
  if (!(area2 > 0)) reject("triangle ", t, " is clockwise or flat");
}

}  // namespace

Triangulation::Triangulation(std::vector<Vector2> points, std::vector<Triangle> triangles)
    : points_(std::move(points)),
      triangles_(std::move(triangles)),
      neighbours_(triangles_.size(), {kNone, kNone, kNone}),
      labels_(triangles_.size(), {kNone, kNone, kNone}),
      incident_(points_.size(), kNone) {
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (!points_[v].allFinite()) reject("vertex ", v, " is not finite");
  }
  std::map<std::pair<int, int>, Side> sides;
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    checkTriangle(points_, triangles_[t], t);
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = ends({t, k});
      if (!sides.emplace(std::make_pair(a, b), Side{t, k}).second) {
        reject("the edge from vertex ", a, " to ", b, " has two triangles on one side");
      }
      const auto other = sides.find({b, a});
      if (other == sides.end()) continue;
      neighbours_[t][k] = other->second.triangle;
      neighbours_[other->second.triangle][other->second.edge] = t;
    }
  }
  forgetHistory();
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (incident_[v] == kNone) reject("vertex ", v, " is in no triangle");
  }
}

void Triangulation::forgetHistory() {
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    for (int v : triangles_[t]) incident_[v] = t;
  }
}

Triangulation::Side Triangulation::opposite(Side side) const {
  const int other = neighbour(side);
  return {other, next(cornerOf(other, ends(side)[0]))};
}

void Triangulation::setLabel(Side side, int label) {
  labels_[side.triangle][side.edge] = label;
  if (neighbour(side) == kNone) return;
  const Side other = opposite(side);
  labels_[other.triangle][other.edge] = label;
}

std::array<int, 2> Triangulation::ends(Side side) const {
  const Triangle& corners = triangles_[side.triangle];
  return {corners[next(side.edge)], corners[previous(side.edge)]};
}

std::optional<Triangulation::Side> Triangulation::findSide(int a, int b) const {
  for (int t : around(a)) {
    const int k = cornerOf(t, a);
    if (triangles_[t][next(k)] == b) return Side{t, previous(k)};
    if (triangles_[t][previous(k)] == b) return Side{t, next(k)};
  }
  return std::nullopt;
}

int Triangulation::cornerOf(int triangle, int v) const {
  const Triangle& corners = triangles_[triangle];
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

Vector2 Triangulation::centroid(int triangle) const {
  const auto [a, b, c] = triangles_[triangle];
  return (points_[a] + points_[b] + points_[c]) / 3;
}

std::vector<int> Triangulation::around(int v) const {
  // Clockwise to the border or once around, then counter-clockwise from there.
  int first = incident_[v];
  for (int t = first;;) {
    t = neighbours_[t][previous(cornerOf(t, v))];
    if (t == kNone || t == incident_[v]) break;
    first = t;
  }
  std::vector<int> result{first};
  for (int t = first;;) {
    t = neighbours_[t][next(cornerOf(t, v))];
    if (t == kNone || t == first) break;
    result.push_back(t);
  }
  return result;
}

bool Triangulation::onBorder(int v) const {
  const int first = around(v).front();
  return neighbours_[first][previous(cornerOf(first, v))] == kNone;
}

/// Barycentric coordinates.
Vector3 Triangulation::weightsAt(const Vector2& p, int triangle) const {
  const auto [i, j, k] = triangles_[triangle];
  const Vector2 &a = points_[i], &b = points_[j], &c = points_[k];
  return Vector3(doubleArea(p, b, c), doubleArea(a, p, c), doubleArea(a, b, p)) /
         doubleArea(a, b, c);
}

std::optional<Triangulation::Location> Triangulation::locate(const Vector2& p,
                                                             double tolerance) const {
  // Over every triangle: outlines may be concave, where a walk can get stuck.
  Location best;
  double best_distance = tolerance;
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    const Vector2 &a = points_[triangles_[t][0]], &b = points_[triangles_[t][1]],
                  &c = points_[triangles_[t][2]];
    const Vector3 weights = weightsAt(p, t);
    if (weights.minCoeff() >= 0) return Location{t, weights};
    const double distance = std::min(
        {distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
    if (distance <= best_distance) {
      best_distance = distance;
      best = {t, weights};
    }
  }
  if (best.triangle == kNone) return std::nullopt;
  return best;
}

/// The least sine of the angle by which `ahead` (of length 1) leads into the triangle from the
/// sides that p lies on; 1 inside, -1 off the triangle.
double Triangulation::inwardness(int triangle, const Vector2& p, const Vector2& ahead,
                                 double tolerance) const {
  double least = 1;
  for (int k = 0; k < 3; ++k) {
    const auto [a, b] = ends({triangle, k});
    const Vector2 along = (points_[b] - points_[a]).normalized();
    const double inside = cross(along, p - points_[a]);
    if (inside < -tolerance) return -1;
    if (inside <= tolerance) least = std::min(least, cross(along, ahead));
  }
  return least;
}

std::optional<Triangulation::Location> Triangulation::locateAhead(const Vector2& p,
                                                                  const Vector2& direction,
                                                                  double tolerance) const {
  const Vector2 ahead = direction.normalized();
  int best = kNone;
  double deepest = -kAlongSide;
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) {
    const double inward = inwardness(t, p, ahead, tolerance);
    if (inward <= deepest) continue;
    deepest = inward;
    best = t;
  }
  if (best == kNone) return std::nullopt;
  return Location{best, weightsAt(p, best)};
}

std::optional<Triangulation::Location> Triangulation::locateNear(const Vector2& p, double tolerance,
                                                                 int near) const {
  std::vector<int> queue{near};
  for (std::size_t i = 0; i < queue.size() && i < kNearby; ++i) {
    const Vector3 weights = weightsAt(p, queue[i]);
    if (weights.minCoeff() >= -kRounding) return Location{queue[i], weights};
    for (int t : neighbours_[queue[i]]) {
      if (t != kNone && !std::count(queue.begin(), queue.end(), t)) queue.push_back(t);
    }
  }
  return locate(p, tolerance);
}

void Triangulation::setTriangle(int t, const Triangle& corners,
                                const std::array<int, 3>& neighbours,
                                const std::array<int, 3>& labels) {
  triangles_[t] = corners;
  neighbours_[t] = neighbours;
  labels_[t] = labels;
  for (int v : corners) incident_[v] = t;
}

void Triangulation::replaceNeighbour(int triangle, int from, int to) {
  if (triangle == kNone) return;
  std::replace(neighbours_[triangle].begin(), neighbours_[triangle].end(), from, to);
}

int Triangulation::addTriangle() {
  triangles_.emplace_back();
  neighbours_.push_back({kNone, kNone, kNone});
  labels_.push_back({kNone, kNone, kNone});
  return static_cast<int>(triangles_.size()) - 1;
}

int Triangulation::addPoint(const Vector2& p) {
  points_.push_back(p);
  incident_.push_back(kNone);
  return static_cast<int>(points_.size()) - 1;
}

//        c                 c
//      /   \             / | \           .
//     a --- b    ->     a--m--b     the side is (a, b) with apex c, its opposite has apex d
//      \   /             \ | /           .
//        d                 d
int Triangulation::splitEdge(Side side, const Vector2& p) {
  const auto [a, b] = ends(side);
  const int label_ab = label(side), t = side.triangle, u = neighbour(side);
  const Side far = u == kNone ? Side{} : opposite(side);
  const int m = addPoint(p), t2 = addTriangle(), u2 = u == kNone ? kNone : addTriangle();

  const int c = apex(side), k = side.edge;
  const int n_bc = neighbours_[t][next(k)], n_ca = neighbours_[t][previous(k)];
  const int l_bc = labels_[t][next(k)], l_ca = labels_[t][previous(k)];
  setTriangle(t2, {m, b, c}, {n_bc, t, u}, {l_bc, kNone, label_ab});
  setTriangle(t, {a, m, c}, {t2, n_ca, u2}, {kNone, l_ca, label_ab});
  replaceNeighbour(n_bc, t, t2);
  if (u == kNone) return m;

  const int d = apex(far), j = far.edge;
  const int n_ad = neighbours_[u][next(j)], n_db = neighbours_[u][previous(j)];
  const int l_ad = labels_[u][next(j)], l_db = labels_[u][previous(j)];
  setTriangle(u2, {m, a, d}, {n_ad, u, t}, {l_ad, kNone, label_ab});
  setTriangle(u, {b, m, d}, {u2, n_db, t2}, {kNone, l_db, label_ab});
  replaceNeighbour(n_ad, u, u2);
  return m;
}

int Triangulation::splitTriangle(int t, const Vector2& p) {
  const Triangle corners = triangles_[t];
  const std::array<int, 3> n = neighbours_[t], l = labels_[t];
  const int m = addPoint(p), t1 = addTriangle(), t2 = addTriangle();
  setTriangle(t, {m, corners[1], corners[2]}, {n[0], t1, t2}, {l[0], kNone, kNone});
  setTriangle(t1, {m, corners[2], corners[0]}, {n[1], t2, t}, {l[1], kNone, kNone});
  setTriangle(t2, {m, corners[0], corners[1]}, {n[2], t, t1}, {l[2], kNone, kNone});
  replaceNeighbour(n[1], t, t1);
  replaceNeighbour(n[2], t, t2);
  return m;
}

bool Triangulation::canFlip(Side side) const {
  if (neighbour(side) == kNone || label(side) != kNone) return false;
  const auto [a, b] = ends(side);
  const int c = apex(side), d = apex(opposite(side));
  return doubleArea(points_[a], points_[d], points_[c]) > 0 &&
         doubleArea(points_[d], points_[b], points_[c]) > 0;
}

//        c                 c
//      /   \             / | \           .
//     a --- b    ->     a  |  b
//      \   /             \ | /           .
//        d                 d
void Triangulation::flip(Side side) {
  const auto [a, b] = ends(side);
  const Side far = opposite(side);
  const int t = side.triangle, u = far.triangle, c = apex(side), d = apex(far);
  const int k = side.edge, j = far.edge;
  const int n_bc = neighbours_[t][next(k)], n_ca = neighbours_[t][previous(k)];
  const int n_ad = neighbours_[u][next(j)], n_db = neighbours_[u][previous(j)];
  const int l_bc = labels_[t][next(k)], l_ca = labels_[t][previous(k)];
  const int l_ad = labels_[u][next(j)], l_db = labels_[u][previous(j)];
  setTriangle(t, {a, d, c}, {u, n_ca, n_ad}, {kNone, l_ca, l_ad});
  setTriangle(u, {d, b, c}, {n_bc, t, n_db}, {l_bc, kNone, l_db});
  replaceNeighbour(n_ad, u, t);
  replaceNeighbour(n_bc, t, u);
}

double Triangulation::smallestAreaWithVertexAt(int v, const Vector2& p) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (int t : around(v)) {
    const int k = cornerOf(t, v);
    smallest = std::min(smallest, doubleArea(p, points_[triangles_[t][next(k)]],
                                             points_[triangles_[t][previous(k)]]));
  }
  return smallest;
}

void Triangulation::moveVertex(int v, const Vector2& p) { points_[v] = p; }

}  // namespace shell_origami
