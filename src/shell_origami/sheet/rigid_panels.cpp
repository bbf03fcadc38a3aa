#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <utility>

namespace shell_origami {
namespace {

/// The turn of the paper across an edge, seen from the triangle on its side `from` (0 or 1). The
/// second triangle lies right of the edge and rises at a valley.
Eigen::AngleAxisd turnAcross(const Sheet& sheet, const Edge& edge, int from,
                             const std::vector<double>& crease_angles) {
  const auto [a, b] = edge.vertices;
  const Vector2 along = (sheet.flatPositions()[b] - sheet.flatPositions()[a]).normalized();
  const double angle = edge.crease < 0 ? 0 : crease_angles[edge.crease];
  return {from == 0 ? -angle : angle, Vector3(along.x(), along.y(), 0)};
}

/// The edge of a triangle that lies counter-clockwise around its corner at `vertex`.
const Edge& edgeAfter(const Sheet& sheet, int triangle, int vertex) {
  const int corner = sheet.triangulation().cornerOf(triangle, vertex);
  return sheet.edges()[sheet.edgeIndex({triangle, (corner + 1) % 3})];
}

std::vector<const Edge*> creaseEdgesAt(const Sheet& sheet, int vertex) {
  std::vector<const Edge*> edges;
  for (int t : sheet.triangulation().around(vertex)) {
    const Edge& edge = edgeAfter(sheet, t, vertex);
    if (edge.crease >= 0) edges.push_back(&edge);
  }
  return edges;
}

Vector3 inSpace(const Vector2& p) { return {p.x(), p.y(), 0}; }

}  // namespace

Positions foldRigidly(const Sheet& sheet, const std::vector<double>& crease_angles) {
  const auto& flat = sheet.flatPositions();
  Positions folded = Positions::Zero(3, sheet.vertexCount());
  std::vector<bool> reached(sheet.triangles().size(), false);
  std::queue<std::pair<int, Eigen::Isometry3d>> next;
  next.push({0, Eigen::Isometry3d::Identity()});
  reached[0] = true;
  while (!next.empty()) {
    const auto [t, motion] = next.front();
    next.pop();
    for (int v : sheet.triangles()[t]) folded.col(v) = motion * inSpace(flat[v]);
    for (int k = 0; k < 3; ++k) {
      const Edge& edge = sheet.edges()[sheet.edgeIndex({t, k})];
      if (edge.onBorder()) continue;
      const int from = edge.triangles[0] == t ? 0 : 1;
      const int other = edge.triangles[1 - from];
      if (reached[other]) continue;
      reached[other] = true;
      const Vector3 hinge = inSpace(flat[edge.vertices[0]]);
      next.push({other, motion * Eigen::Translation3d(hinge) *
                            turnAcross(sheet, edge, from, crease_angles) *
                            Eigen::Translation3d(-hinge)});
    }
  }
  return folded;
}

double closingError(const Sheet& sheet, int vertex, const std::vector<double>& crease_angles) {
  const Triangulation& triangulation = sheet.triangulation();
  if (triangulation.onBorder(vertex)) return 0;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (int t : triangulation.around(vertex)) {
    const Edge& edge = edgeAfter(sheet, t, vertex);
    turn = turn * turnAcross(sheet, edge, edge.triangles[0] == t ? 0 : 1, crease_angles);
  }
  return turn.angularDistance(Eigen::Quaterniond::Identity());
}

double kawasakiError(const Sheet& sheet, int vertex) {
  std::vector<double> directions;
  for (const Edge* edge : creaseEdgesAt(sheet, vertex)) {
    const int other = edge->vertices[edge->vertices[0] == vertex ? 1 : 0];
    const Vector2 along = sheet.flatPositions()[other] - sheet.flatPositions()[vertex];
    directions.push_back(std::atan2(along.y(), along.x()));
  }
  if (directions.size() % 2 == 1) return std::nan("");
  std::sort(directions.begin(), directions.end());
  double sum = 0;
  for (std::size_t i = 0; i + 1 < directions.size(); i += 2)
    sum += directions[i + 1] - directions[i];
  return std::abs(sum - M_PI);
}

std::vector<double> anglesAround(const Sheet& sheet, int vertex,
                                 const std::vector<double>& crease_angles) {
  std::vector<double> angles;
  for (const Edge* edge : creaseEdgesAt(sheet, vertex)) {
    angles.push_back(crease_angles[edge->crease]);
  }
  return angles;
}

std::vector<int> innerCreaseVertices(const Sheet& sheet) {
  std::set<int> found;
  for (const Crease& crease : sheet.creases()) {
    for (int v : crease.vertices) {
      if (!sheet.triangulation().onBorder(v)) found.insert(v);
    }
  }
  return {found.begin(), found.end()};
}

std::vector<int> connectedTriangles(const Sheet& sheet,
                                    const std::function<bool(const Edge&)>& joins) {
  std::vector<std::vector<int>> neighbors(sheet.triangles().size());
  for (const Edge& edge : sheet.edges()) {
    if (edge.onBorder() || !joins(edge)) continue;
    neighbors[edge.triangles[0]].push_back(edge.triangles[1]);
    neighbors[edge.triangles[1]].push_back(edge.triangles[0]);
  }
  std::vector<int> parts(sheet.triangles().size(), -1);
  int count = 0;
  for (std::size_t first = 0; first < parts.size(); ++first) {
    if (parts[first] >= 0) continue;
    std::vector<int> open = {static_cast<int>(first)};
    parts[first] = count;
    while (!open.empty()) {
      const int triangle = open.back();
      open.pop_back();
      for (const int neighbor : neighbors[triangle]) {
        if (parts[neighbor] >= 0) continue;
        parts[neighbor] = count;
        open.push_back(neighbor);
      }
    }
    ++count;
  }
  return parts;
}

std::vector<int> panelOfTriangle(const Sheet& sheet) {
  return connectedTriangles(sheet, [](const Edge& edge) { return edge.crease < 0; });
}

}  // namespace shell_origami
