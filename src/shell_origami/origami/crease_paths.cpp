#include <shell_origami/origami/crease_paths.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// A vertex is on a line that is nearer than this part of the sheet's size: lines end at what is
/// near.
constexpr double kOnLine = 1e-3;
/// A line that turns by less at a vertex goes straight on [rad].
constexpr double kStraight = 5 * M_PI / 180;

}  // namespace

bool goesStraight(const Sheet& sheet, int from, int at, int to) {
  const auto& flat = sheet.flatPositions();
  const Vector2 in = flat[at] - flat[from], out = flat[to] - flat[at];
  return std::abs(std::atan2(cross(in, out), in.dot(out))) < kStraight;
}

FoldedCreases::FoldedCreases(const Sheet& sheet, std::vector<bool> folded)
    : sheet_(sheet), folded_(std::move(folded)) {}

std::vector<int> FoldedCreases::at(int vertex) const {
  std::vector<int> ends;
  const auto& flat = sheet_.flatPositions();
  for (int t : sheet_.triangulation().around(vertex)) {
    for (int k = 0; k < 3; ++k) {
      const Edge& edge = sheet_.edges()[sheet_.edgeIndex({t, k})];
      const auto [a, b] = edge.vertices;
      if (edge.crease >= 0 && folded_[edge.crease] && (a == vertex || b == vertex))
        ends.push_back(a == vertex ? b : a);
    }
  }
  const auto angle = [&](int v) {
    const Vector2 way = flat[v] - flat[vertex];
    return std::atan2(way.y(), way.x());
  };
  std::sort(ends.begin(), ends.end(), [&](int v, int w) { return angle(v) < angle(w); });
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

std::vector<int> FoldedCreases::along(int from, int to) const {
  std::vector<int> path{from, to};
  while (!sheet_.triangulation().onBorder(path.back())) {
    const std::vector<int> ends = at(path.back());
    if (ends.size() != 2) break;
    const int next = ends[0] == path[path.size() - 2] ? ends[1] : ends[0];
    if (!goesStraight(sheet_, path[path.size() - 2], path.back(), next)) break;
    path.push_back(next);
  }
  return path;
}

std::array<int, 2> FoldedCreases::nextOnOutline(int vertex) const {
  const auto next = [&](int v, bool forward) {
    for (const Edge& edge : sheet_.edges()) {
      // The paper lies left of a border edge.
      if (edge.onBorder() && edge.vertices[forward ? 0 : 1] == v) {
        return edge.vertices[forward ? 1 : 0];
      }
    }
    return vertex;
  };
  std::array<int, 2> found{};
  for (int side = 0; side < 2; ++side) {
    int v = next(vertex, side == 0);
    while (v != vertex && at(v).empty()) v = next(v, side == 0);
    found[side] = v;
  }
  return found;
}

int creaseBetween(const Sheet& sheet, int a, int b) {
  const auto side = sheet.triangulation().findSide(a, b);
  return side ? sheet.edges()[sheet.edgeIndex(*side)].crease : -1;
}

Segment lineOf(int crease, const Sheet& sheet) {
  const std::vector<int>& path = sheet.creases()[crease].vertices;
  return {sheet.flatPositions()[path.front()], sheet.flatPositions()[path.back()]};
}

std::vector<int> creasesAlong(const Sheet& sheet, const Segment& line) {
  const Vector2 way = line[1] - line[0];
  const double length = way.norm(), near = kOnLine * sheet.size();
  const auto on_line = [&](int v) {
    const Vector2 p = sheet.flatPositions()[v] - line[0];
    const double along = way.dot(p) / length;
    return std::abs(cross(way, p)) / length < near && along > -near && along < length + near;
  };
  std::vector<int> found;
  for (std::size_t i = 0; i < sheet.creases().size(); ++i) {
    const std::vector<int>& path = sheet.creases()[i].vertices;
    if (on_line(path.front()) && on_line(path.back())) found.push_back(static_cast<int>(i));
  }
  return found;
}

Vector2 meetingOf(const Segment& first, const Segment& second) {
  const Vector2 u = first[1] - first[0], v = second[1] - second[0];
  const double turn = cross(u, v);
  if (!(std::abs(turn) > 1e-9 * u.norm() * v.norm())) {
    reject("the lines through (", first[0].x(), ", ", first[0].y(), ") and through (",
           second[0].x(), ", ", second[0].y(), ") do not meet: they are parallel");
  }
  return first[0] + cross(second[0] - first[0], v) / turn * u;
}

Vector2 mirrored(const Vector2& point, const Segment& line) {
  const Vector2 along = (line[1] - line[0]).normalized();
  const Vector2 way = point - line[0];
  return line[0] + 2 * along.dot(way) * along - way;
}

}  // namespace shell_origami
