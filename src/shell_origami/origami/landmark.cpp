#include <shell_origami/origami/landmark.h>

#include <shell_origami/base/error.h>
#include <shell_origami/contact/distance.h>
#include <shell_origami/origami/crease_paths.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace shell_origami {
namespace {

/// A point this far off the paper is taken to be on it, relative to the sheet's size: people round.
constexpr double kOffPaper = 1e-6;

/// The neighbors of each vertex along some edges.
using Neighbors = std::map<int, std::vector<int>>;

template <class Wanted>
Neighbors neighborsAlong(const Sheet& sheet, Wanted wanted) {
  Neighbors neighbors;
  for (const Edge& edge : sheet.edges()) {
    if (!wanted(edge)) continue;
    const auto [a, b] = edge.vertices;
    neighbors[a].push_back(b);
    neighbors[b].push_back(a);
  }
  return neighbors;
}

Neighbors alongBorder(const Sheet& sheet) {
  return neighborsAlong(sheet, [](const Edge& edge) { return edge.onBorder(); });
}

/// Whether a line goes straight on at a vertex.
bool goesOn(const Sheet& sheet, int v, const std::vector<int>& neighbors) {
  return neighbors.size() == 2 && goesStraight(sheet, neighbors[0], v, neighbors[1]);
}

struct Resolve {
  const Sheet& sheet;

  Vector2 operator()(const Vector2& point) const { return point; }
  Vector2 operator()(const CornerNear& corner) const;
  Vector2 operator()(const PartOfWay& way) const {
    return (1 - way.part) * of(way.ends[0]) + way.part * of(way.ends[1]);
  }
  Vector2 operator()(const LinesMeet& lines) const;

  Vector2 of(const Landmark& landmark) const { return std::visit(*this, landmark.place); }
};

Vector2 Resolve::operator()(const CornerNear& corner) const {
  const std::vector<int> corners = cornersOf(sheet);
  if (corners.empty()) reject("the paper's outline has no corner");
  const auto distance = [&](int v) { return (sheet.flatPositions()[v] - corner.point).norm(); };
  return sheet.flatPositions()[*std::min_element(
      corners.begin(), corners.end(), [&](int v, int w) { return distance(v) < distance(w); })];
}

Vector2 Resolve::operator()(const LinesMeet& lines) const {
  return meetingOf({of(lines.ends[0]), of(lines.ends[1])}, {of(lines.ends[2]), of(lines.ends[3])});
}

}  // namespace

std::vector<int> cornersOf(const Sheet& sheet) {
  std::vector<int> corners;
  for (const auto& [v, neighbors] : alongBorder(sheet)) {
    if (!goesOn(sheet, v, neighbors)) corners.push_back(v);
  }
  return corners;
}

std::vector<int> featuresOf(const Sheet& sheet) {
  const Neighbors border = alongBorder(sheet);
  const std::vector<int> corners = cornersOf(sheet);
  std::set<int> features(corners.begin(), corners.end());
  const auto is_crease = [](const Edge& edge) { return edge.crease >= 0; };
  for (const auto& [v, neighbors] : neighborsAlong(sheet, is_crease)) {
    if (border.count(v) > 0 || !goesOn(sheet, v, neighbors)) features.insert(v);
  }
  return {features.begin(), features.end()};
}

Vector2 flatPoint(const Landmark& landmark, const Sheet& sheet) {
  const Vector2 point = Resolve{sheet}.of(landmark);
  if (!point.allFinite() || !sheet.triangulation().locate(point, kOffPaper * sheet.size())) {
    reject("the point (", point.x(), ", ", point.y(), ") is off the paper");
  }
  return point;
}

Vector3 pointInSpace(const Vector2& flat, const Sheet& sheet, const Positions& positions) {
  const auto place = sheet.triangulation().locate(flat, kOffPaper * sheet.size());
  const Triangle& corners = sheet.triangles()[place->triangle];
  Vector3 point = Vector3::Zero();
  for (int k = 0; k < 3; ++k) point += place->weights[k] * positions.col(corners[k]);
  return point;
}

Vector2 nearestFlatPoint(const Vector3& point, const Sheet& sheet, const Positions& positions) {
  Vector2 nearest = Vector2::Zero();
  double least = HUGE_VAL;
  for (const auto& [a, b, c] : sheet.triangles()) {
    const ClosestPoints closest = closestPoints(
        PairKind::kVertexFace, {point, positions.col(a), positions.col(b), positions.col(c)});
    if (closest.distance >= least) continue;
    least = closest.distance;
    const auto& flat = sheet.flatPositions();
    nearest =
        -closest.weights[1] * flat[a] - closest.weights[2] * flat[b] - closest.weights[3] * flat[c];
  }
  if (std::isinf(least)) {
    reject("the point (", point.x(), ", ", point.y(), ", ", point.z(), ") is too far away");
  }
  return nearest;
}

}  // namespace shell_origami
