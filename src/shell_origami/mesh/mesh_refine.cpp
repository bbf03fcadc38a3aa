#include <shell_origami/mesh/mesh_refine.h>

#include <shell_origami/base/error.h>
#include <shell_origami/base/memory.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace shell_origami {
namespace {

using Side = Triangulation::Side;

/// The smallest angle of a triangle that is left alone [rad]: CGAL's default, sin^2 of which is
/// 1/8.
constexpr double kShapeBound = 0.3614;
/// A sliver whose edges are all shorter than this part of the longest edge allowed is left alone:
/// features finer than that are the pattern's own.
constexpr double kShapeSize = 0.4;
constexpr int kRelaxPasses = 20;

double length(const Triangulation& mesh, Side side) {
  const auto [a, b] = mesh.ends(side);
  return (mesh.points()[a] - mesh.points()[b]).norm();
}

Side longestSide(const Triangulation& mesh, int triangle) {
  Side best{triangle, 0};
  for (int k = 1; k < 3; ++k) {
    // Among equal lengths the vertices decide, so that both neighbors choose the same edge.
    const double now = length(mesh, {triangle, k}), before = length(mesh, best);
    if (now > before * (1 + 1e-12)) best = {triangle, k};
  }
  return best;
}

/// The angle at corner k [rad].
double angleAt(const Triangulation& mesh, int triangle, int k) {
  const Triangle& t = mesh.triangles()[triangle];
  const Vector2 &p = mesh.points()[t[k]], &q = mesh.points()[t[(k + 1) % 3]],
                &r = mesh.points()[t[(k + 2) % 3]];
  return std::atan2(doubleArea(p, q, r), (q - p).dot(r - p));
}

}  // namespace

bool isFixed(const Triangulation& mesh, Side side) {
  return mesh.neighbour(side) == Triangulation::kNone || mesh.label(side) != Triangulation::kNone;
}

bool isSliver(const Triangulation& mesh, int triangle, double least) {
  int sharpest = 0;
  double smallest = M_PI;
  for (int k = 0; k < 3; ++k) {
    const double angle = angleAt(mesh, triangle, k);
    if (angle >= smallest) continue;
    smallest = angle;
    sharpest = k;
  }
  const Side left{triangle, (sharpest + 1) % 3}, right{triangle, (sharpest + 2) % 3};
  return smallest < least && !(isFixed(mesh, left) && isFixed(mesh, right));
}

Side terminalEdge(const Triangulation& mesh, int triangle) {
  Side side = longestSide(mesh, triangle);
  while (!isFixed(mesh, side)) {
    const Side next = longestSide(mesh, mesh.neighbour(side));
    if (!(length(mesh, next) > length(mesh, side) * (1 + 1e-12))) break;
    side = next;
  }
  return side;
}

double longestEdge(const Triangulation& mesh, int triangle) {
  return length(mesh, longestSide(mesh, triangle));
}

namespace {

bool bad(const Triangulation& mesh, int triangle, double longest) {
  const double edge = longestEdge(mesh, triangle);
  if (edge > longest * (1 + 1e-12)) return true;
  return edge > kShapeSize * longest && isSliver(mesh, triangle, kShapeBound);
}

/// Whether the other diagonal is Delaunay: the angles opposite the edge sum to more than pi.
bool shouldFlip(const Triangulation& mesh, Side side) {
  if (!mesh.canFlip(side)) return false;
  const auto [a, b] = mesh.ends(side);
  const auto& p = mesh.points();
  const Vector2 &c = p[mesh.apex(side)], &d = p[mesh.apex(mesh.opposite(side))];
  const double sine_c = doubleArea(c, p[a], p[b]), cosine_c = (p[a] - c).dot(p[b] - c);
  const double sine_d = doubleArea(d, p[b], p[a]), cosine_d = (p[a] - d).dot(p[b] - d);
  const double scale = std::hypot(sine_c, cosine_c) * std::hypot(sine_d, cosine_d);
  return sine_c * cosine_d + cosine_c * sine_d < -1e-10 * scale;
}

bool hasCorner(const Triangulation& mesh, int triangle, int v) {
  const Triangle& t = mesh.triangles()[triangle];
  return std::find(t.begin(), t.end(), v) != t.end();
}

/// Flips around a new vertex until everything is Delaunay again.
void flipAround(Triangulation& mesh, int v) {
  std::vector<int> stack = mesh.around(v);
  while (!stack.empty()) {
    const int t = stack.back();
    stack.pop_back();
    if (!hasCorner(mesh, t, v)) continue;
    const Side side{t, mesh.cornerOf(t, v)};
    if (!shouldFlip(mesh, side)) continue;
    stack.push_back(mesh.neighbour(side));
    stack.push_back(t);
    mesh.flip(side);
  }
}

}  // namespace

void checkMaxEdge(double max_edge) {
  if (!(max_edge > 0) || !std::isfinite(max_edge)) {
    reject("max_edge is ", max_edge, ", but must be positive and finite");
  }
}

void checkCount(double triangles, double max_edge) {
  if (triangles <= kMostTriangles) return;
  reject("max_edge ", max_edge, " would give about ", triangles,
         " triangles, but a million are the most");
}

void checkPlan(double triangles, double max_edge) {
  checkCount(triangles, max_edge);
  try {
    checkMemory(triangles);
  } catch (const std::invalid_argument& error) {
    reject("max_edge ", max_edge, " is too small: ", error.what());
  }
}

void checkMemory(double triangles) {
  constexpr double kMega = 1e6;
  const double needed = kTriangleMemory * triangles, available = availableMemory();
  if (needed <= available) return;
  reject("about ", triangles, " triangles need ", std::ceil(needed / kMega), " MB of memory, but ",
         std::floor(available / kMega), " MB are available");
}

void refineMesh(Triangulation& mesh, double longest) {
  std::vector<int> queue(mesh.triangles().size());
  for (std::size_t t = 0; t < queue.size(); ++t) queue[t] = static_cast<int>(t);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    while (bad(mesh, queue[head], longest)) {
      const Side side = terminalEdge(mesh, queue[head]);
      const auto [a, b] = mesh.ends(side);
      const int v = mesh.splitEdge(side, (mesh.points()[a] + mesh.points()[b]) / 2);
      flipAround(mesh, v);
      const std::vector<int> fan = mesh.around(v);
      queue.insert(queue.end(), fan.begin(), fan.end());
      checkCount(static_cast<double>(mesh.triangles().size()), longest);
    }
  }
}

namespace {

/// 1 for an equilateral triangle, 0 for a flat one.
double quality(const Vector2& a, const Vector2& b, const Vector2& c) {
  return 2 * std::sqrt(3.0) * doubleArea(a, b, c) /
         ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
}

bool loose(const Triangulation& mesh, int v) {
  for (int t : mesh.around(v)) {
    const int k = mesh.cornerOf(t, v);
    if (isFixed(mesh, {t, (k + 1) % 3}) || isFixed(mesh, {t, (k + 2) % 3})) return false;
  }
  return true;
}

struct Star {
  double worst = 1;    ///< quality
  double longest = 0;  ///< edge at the centre
};

/// Returns the shape of the triangles around v if v were at p.
Star starAt(const Triangulation& mesh, const std::vector<int>& fan, int v, const Vector2& p) {
  Star star;
  for (int t : fan) {
    const int k = mesh.cornerOf(t, v);
    const Vector2 &q = mesh.points()[mesh.triangles()[t][(k + 1) % 3]],
                  &r = mesh.points()[mesh.triangles()[t][(k + 2) % 3]];
    star.worst = std::min(star.worst, quality(p, q, r));
    star.longest = std::max(star.longest, (q - p).norm());
  }
  return star;
}

bool shift(Triangulation& mesh, int v, double longest) {
  const std::vector<int> fan = mesh.around(v);
  Vector2 middle = Vector2::Zero();
  for (int t : fan) middle += mesh.points()[mesh.triangles()[t][(mesh.cornerOf(t, v) + 1) % 3]];
  middle /= static_cast<double>(fan.size());
  const Vector2 from = mesh.points()[v];
  const Star now = starAt(mesh, fan, v, from);
  for (const double step : {1.0, 0.5, 0.25}) {
    const Vector2 to = from + step * (middle - from);
    const Star then = starAt(mesh, fan, v, to);
    if (then.worst < now.worst + 1e-4 || then.longest > std::max(longest, now.longest)) continue;
    mesh.moveVertex(v, to);
    return true;
  }
  return false;
}

bool flipAll(Triangulation& mesh, double longest) {
  bool flipped = false;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Side side{t, k};
      if (!shouldFlip(mesh, side)) continue;
      const Vector2 diagonal =
          mesh.points()[mesh.apex(side)] - mesh.points()[mesh.apex(mesh.opposite(side))];
      if (diagonal.norm() > std::max(longest, length(mesh, side))) continue;
      mesh.flip(side);
      flipped = true;
    }
  }
  return flipped;
}

}  // namespace

void relaxMesh(Triangulation& mesh, double longest) {
  std::vector<bool> may_shift(mesh.points().size());
  for (std::size_t v = 0; v < may_shift.size(); ++v) {
    may_shift[v] = loose(mesh, static_cast<int>(v));
  }
  for (int pass = 0; pass < kRelaxPasses; ++pass) {
    bool changed = false;
    for (std::size_t v = 0; v < may_shift.size(); ++v) {
      if (may_shift[v]) changed |= shift(mesh, static_cast<int>(v), longest);
    }
    changed |= flipAll(mesh, longest);
    if (!changed) break;
  }
}

}  // namespace shell_origami
