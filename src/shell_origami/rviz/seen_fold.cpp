#include <shell_origami/rviz/seen_fold.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace shell_origami {
namespace {

/// What passes the fold's plane by less does not reach beyond it, relative to the sheet's size.
constexpr double kNearPlane = 1e-6;
/// A pointer nearer to the fold does not say which side moves, relative to the sheet's size.
constexpr double kNoSide = 0.02;

/// The part of a triangle beyond the plane, with three corners, four, or none.
std::vector<Vector3> partBeyond(const std::array<Vector3, 3>& corners, const SeenFold& fold) {
  std::vector<Vector3> part;
  for (int k = 0; k < 3; ++k) {
    const Vector3 &a = corners[k], &b = corners[(k + 1) % 3];
    const double from = fold.distance(a), to = fold.distance(b);
    if (from >= 0) part.push_back(a);
    if ((from < 0) != (to < 0)) part.push_back(a + from / (from - to) * (b - a));
  }
  return part;
}

class Beyond {
 public:
  Beyond(const SeenFold& fold, const ShownPaper& paper) : paper_(paper) {
    const Positions& positions = paper.positions();
    const double near = kNearPlane * paper.sheet().size();
    for (int v = 0; v < positions.cols(); ++v) {
      reaches_.push_back(fold.distance(positions.col(v)) > near);
      passes_.push_back(fold.distance(positions.col(v)) < near);
    }
  }

  bool hasPart(int triangle) const { return any(reaches_, triangle); }
  /// Whether the plane touches or cuts the triangle's part beyond it.
  bool isAtPlane(int triangle) const { return hasPart(triangle) && any(passes_, triangle); }
  /// Adds the triangles that are joined to one beyond the plane, itself included.
  void join(int triangle, std::vector<bool>& joined) const {
    std::vector<int> waiting{triangle};
    while (!waiting.empty()) {
      const int t = waiting.back();
      waiting.pop_back();
      if (joined[t]) continue;
      joined[t] = true;
      for (int k = 0; k < 3; ++k) {
        const Triangulation& mesh = paper_.sheet().triangulation();
        const auto ends = mesh.ends({t, k});
        const int next = mesh.neighbour({t, k});
        if (next >= 0 && !joined[next] && (reaches_[ends[0]] || reaches_[ends[1]])) {
          waiting.push_back(next);
        }
      }
    }
  }

 private:
  bool any(const std::vector<bool>& of_vertex, int triangle) const {
    const Triangle& corners = paper_.sheet().triangles()[triangle];
    return std::any_of(corners.begin(), corners.end(), [&](int v) { return of_vertex[v]; });
  }

  const ShownPaper& paper_;
  std::vector<bool> reaches_, passes_;  ///< of each vertex
};

/// Sets which side moves: that of the point, or the smaller one, and its farthest vertex.
void chooseSide(const std::optional<Vector2>& wanted, const ShownPaper& paper, SeenFold& fold) {
  const Sheet& sheet = paper.sheet();
  const PaperPlace place = wanted ? paper.place(*wanted) : PaperPlace{};
  if (place.triangle >= 0) {
    const double distance = fold.distance(paper.point(place));
    if (std::abs(distance) > kNoSide * sheet.size()) {
      if (distance < 0) fold.normal = -fold.normal;
      fold.moving = *wanted;
      return;
    }
  }
  double balance = 0;
  for (const auto& [a, b, c] : sheet.triangles()) {
    const Vector3 middle =
        (paper.positions().col(a) + paper.positions().col(b) + paper.positions().col(c)) / 3;
    const auto& flat = sheet.flatPositions();
    balance += std::copysign(doubleArea(flat[a], flat[b], flat[c]), fold.distance(middle));
  }
  if (balance > 0) fold.normal = -fold.normal;
  int farthest = 0;
  for (int v = 1; v < sheet.vertexCount(); ++v) {
    if (fold.distance(paper.positions().col(v)) > fold.distance(paper.positions().col(farthest))) {
      farthest = v;
    }
  }
  fold.moving = sheet.flatPositions()[farthest];
}

}  // namespace

bool showsFront(const ShownPaper& paper, int triangle, const Vector3& eye) {
  const Vector3 corner = paper.positions().col(paper.sheet().triangles()[triangle][0]);
  return paper.normal(triangle).dot(eye - corner) > 0;
}

std::optional<SeenFold> seenFold(const LaidFold& fold, const ShownPaper& paper,
                                 const Vector3& eye) {
  const int triangle = fold.first.place.triangle;
  const Vector3 p = paper.point(fold.first.place), q = paper.point(fold.second.place);
  SeenFold seen;
  seen.viewer = (showsFront(paper, triangle, eye) ? 1 : -1) * paper.normal(triangle);
  const Vector3 way = (q - p) - seen.viewer.dot(q - p) * seen.viewer;
  if (way.norm() < kNearPlane * paper.sheet().size()) return std::nullopt;
  if (fold.bring) {
    seen.point = (p + q) / 2;
    seen.normal = -way.normalized();
    seen.moving = fold.first.flat;
  } else {
    seen.point = p;
    seen.normal = seen.viewer.cross(way).normalized();
    chooseSide(fold.moving, paper, seen);
  }
  seen.axis = seen.normal.cross(seen.viewer);
  return seen;
}

std::vector<Vector3> ghostOf(const SeenFold& fold, const ShownPaper& paper,
                             const std::vector<std::uint32_t>& panels, double angle) {
  const auto& triangles = paper.sheet().triangles();
  const std::set<int> creased(panels.begin(), panels.end());
  const Beyond beyond(fold, paper);
  std::vector<bool> moves(triangles.size(), false);
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    if (creased.count(paper.panel(t)) > 0 && beyond.isAtPlane(t)) beyond.join(t, moves);
  }
  const Eigen::AngleAxisd turn(angle, fold.axis);
  std::vector<Vector3> ghost;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!moves[t]) continue;
    const auto& [a, b, c] = triangles[t];
    const Positions& p = paper.positions();
    std::vector<Vector3> part = partBeyond({p.col(a), p.col(b), p.col(c)}, fold);
    for (Vector3& corner : part) corner = fold.point + turn * (corner - fold.point);
    for (std::size_t k = 2; k < part.size(); ++k) {
      ghost.insert(ghost.end(), {part[0], part[k - 1], part[k]});
    }
  }
  return ghost;
}

}  // namespace shell_origami
