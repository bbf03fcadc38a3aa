#include <shell_origami/mesh/material_mesh.h>
#include <shell_origami/mesh/mesh_refine.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace shell_origami {
namespace {

/// Triangles whose smallest angle is below this are worth work.
constexpr double kGoodAngle = 30 * M_PI / 180;
constexpr int kPasses = 6;
/// Angles below this, that the creases do not force, are refined away [rad].
constexpr double kLeastAngle = 16 * M_PI / 180;
/// No edge shorter than this part of the sheet's mean edge is made: where lines pass each other
/// closer, they force their slivers.
constexpr double kFinest = 0.05;
/// Tangent of the angle [60 degrees] below which two creases or a border make a narrow corner.
constexpr double kNarrow = 1.7320508;
/// Splits in one edit. Where the paper is bent edges are not flipped, and splitting alone does not
/// enlarge an angle.
constexpr int kMostSplits = 1000;

std::vector<int> sortedUnique(std::vector<int> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Positive when the edge's two triangles would have a larger smallest angle after a flip.
bool flipHelps(const MaterialMesh& mesh, Triangulation::Side side) {
  const auto [a, b] = mesh.flat().ends(side);
  const int c = mesh.flat().apex(side), d = mesh.flat().apex(mesh.flat().opposite(side));
  const Vector2 &pa = mesh.point(a), &pb = mesh.point(b), &pc = mesh.point(c), &pd = mesh.point(d);
  const double now = std::min(smallestAngle(pa, pb, pc), smallestAngle(pb, pa, pd));
  const double then = std::min(smallestAngle(pa, pd, pc), smallestAngle(pd, pb, pc));
  return then > now + 1e-9;
}

/// Flips, from the given vertices outwards, every edge whose flip enlarges the smallest angle.
/// Each flip does, so it ends.
void flipAround(MaterialMesh& mesh, const std::vector<int>& vertices) {
  std::deque<int> queue(vertices.begin(), vertices.end());
  while (!queue.empty()) {
    const int v = queue.front();
    queue.pop_front();
    for (int t : mesh.flat().around(v)) {
      const Triangulation::Side side{t, mesh.flat().cornerOf(t, v)};
      const Triangulation::Side spoke{t, (side.edge + 1) % 3};
      bool flipped = false;
      for (const Triangulation::Side candidate : {side, spoke}) {
        if (!mesh.mayFlip(candidate) || !flipHelps(mesh, candidate)) continue;
        const auto [a, b] = mesh.flat().ends(candidate);
        const int far = mesh.flat().apex(mesh.flat().opposite(candidate));
        const int near = mesh.flat().apex(candidate);
        mesh.flip(candidate);
        queue.insert(queue.end(), {v, a, b, near, far});
        flipped = true;
        break;
      }
      if (flipped) break;
    }
  }
}

/// The place towards which shifting v would even out its surroundings.
Vector2 evenPlace(const MaterialMesh& mesh, int v, const MaterialMesh::Freedom& freedom) {
  Vector2 sum = Vector2::Zero();
  int count = 0;
  for (int t : mesh.flat().around(v)) {
    for (int w : mesh.flat().triangles()[t]) {
      if (w == v) continue;
      sum += mesh.point(w);
      ++count;
    }
  }
  const Vector2 centroid = sum / count;
  if (freedom.kind == MaterialMesh::Freedom::kFree) return centroid;
  // Near the centroid's foot on the rail, but off its ends.
  const Vector2 &a = mesh.point(freedom.rail[0]), &b = mesh.point(freedom.rail[1]);
  const double s = (centroid - a).dot(b - a) / (b - a).squaredNorm();
  return a + std::clamp(s, 0.2, 0.8) * (b - a);
}

/// Shifts v if that enlarges the smallest angle around it.
bool smooth(MaterialMesh& mesh, int v) {
  const double now = mesh.smallestAngle(v, mesh.point(v));
  if (now >= kGoodAngle) return false;
  const MaterialMesh::Freedom freedom = mesh.freedom(v);
  if (freedom.kind == MaterialMesh::Freedom::kFixed || !mesh.nearlyFlatAround(v)) return false;
  const Vector2 goal = evenPlace(mesh, v, freedom), start = mesh.point(v);
  for (const double step : {1.0, 0.5, 0.25, 0.1}) {
    const Vector2 p = start + step * (goal - start);
    if (mesh.smallestAngle(v, p) <= now + 1e-3) continue;
    mesh.shift(v, p);
    return true;
  }
  return false;
}

/// Whether another crease or the border leaves v close to the direction of the edge v, w.
bool inNarrowCorner(const MaterialMesh& mesh, int v, int w) {
  const Vector2 along = mesh.point(w) - mesh.point(v);
  for (int t : mesh.flat().around(v)) {
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = mesh.flat().ends({t, k});
      const int far = a == v ? b : a;
      if ((a != v && b != v) || far == w || !isFixed(mesh.flat(), {t, k})) continue;
      const Vector2 other = mesh.point(far) - mesh.point(v);
      if (std::abs(cross(along, other)) < along.dot(other) * kNarrow) return true;
    }
  }
  return false;
}

/// Returns the point at which to split an edge: its middle, or for an edge in a narrow corner a
/// point on a circle around the corner whose radius is a power of two. All edges of the corner are
/// then split at equal distances; splits at their middles would cause ever shorter splits of each
/// other (Ruppert 1995, concentric shells).
Vector2 splitPoint(const MaterialMesh& mesh, Triangulation::Side side) {
  auto [a, b] = mesh.flat().ends(side);
  if (isFixed(mesh.flat(), side)) {
    if (!inNarrowCorner(mesh, a, b)) std::swap(a, b);
    if (inNarrowCorner(mesh, a, b)) {
      const Vector2 along = mesh.point(b) - mesh.point(a);
      const double power = std::round(std::log2(along.norm() / 2 / mesh.size()));
      const double part = mesh.size() * std::exp2(power) / along.norm();
      return mesh.point(a) + part * along;
    }
  }
  return (mesh.point(a) + mesh.point(b)) / 2;
}

double meanEdge(const Triangulation& mesh) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) sum += longestEdge(mesh, t);
  return sum / static_cast<double>(mesh.triangles().size());
}

/// Splits edges until no triangle at the vertices is a sliver that the creases do not force.
void refineAround(MaterialMesh& mesh, const std::vector<int>& vertices) {
  const double finest = kFinest * meanEdge(mesh.flat());
  std::deque<int> queue(vertices.begin(), vertices.end());
  for (int splits = 0; !queue.empty() && splits < kMostSplits;) {
    const int v = queue.front();
    queue.pop_front();
    for (int t : mesh.flat().around(v)) {
      if (!isSliver(mesh.flat(), t, kLeastAngle)) continue;
      const Triangulation::Side side = terminalEdge(mesh.flat(), t);
      const auto [a, b] = mesh.flat().ends(side);
      if ((mesh.point(a) - mesh.point(b)).norm() < 2 * finest) continue;
      const int added = mesh.splitEdge(side, splitPoint(mesh, side));
      flipAround(mesh, {added});
      queue.insert(queue.end(), {v, added});
      ++splits;
      break;
    }
  }
}

/// The vertices and their neighbours.
std::vector<int> grown(const MaterialMesh& mesh, const std::vector<int>& region) {
  std::vector<int> ring = region;
  for (int v : region) {
    for (int t : mesh.flat().around(v)) {
      const Triangle& c = mesh.flat().triangles()[t];
      ring.insert(ring.end(), c.begin(), c.end());
    }
  }
  return sortedUnique(std::move(ring));
}

void flipAndSmooth(MaterialMesh& mesh) {
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<int> region = sortedUnique(mesh.touched());
    flipAround(mesh, region);
    bool moved = false;
    for (int v : grown(mesh, region)) moved |= smooth(mesh, v);
    if (!moved) break;
  }
}

}  // namespace

void improve(MaterialMesh& mesh) {
  // Without flips and shifts, splitting slivers makes more slivers.
  if (mesh.exact()) return;
  flipAndSmooth(mesh);
  refineAround(mesh, sortedUnique(mesh.touched()));
  flipAndSmooth(mesh);
  refineAround(mesh, sortedUnique(mesh.touched()));
}

}  // namespace shell_origami
