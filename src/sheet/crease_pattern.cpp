#include "sheet/crease_pattern.h"

#include "sheet/refuse.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace shell_origami {
namespace {

constexpr double kFree = std::numeric_limits<double>::quiet_NaN();

using Ends = std::pair<int, int>;
Ends sorted(int a, int b) { return std::minmax({a, b}); }

/// The vertex that stands for each: the first of those that coincide.
std::vector<int> mergeCoincident(const std::vector<Vector2>& points) {
  Eigen::AlignedBox2d box;
  for (const Vector2& p : points) box.extend(p);
  const double tolerance = 1e-9 * box.sizes().maxCoeff();
  std::vector<int> order(points.size()), stand_in(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(stand_in.begin(), stand_in.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int i, int j) { return points[i].x() < points[j].x(); });
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Vector2& p = points[order[n]];
    for (std::size_t m = n + 1; m < order.size(); ++m) {
      const Vector2& q = points[order[m]];
      if (q.x() > p.x() + tolerance) break;
      if ((q - p).norm() > tolerance) continue;
      const int first = std::min(stand_in[order[n]], stand_in[order[m]]);
      stand_in[order[n]] = stand_in[order[m]] = first;
    }
  }
  return stand_in;
}

/// Kind and angle of an edge where the file leaves them open.
PatternEdge makeEdge(std::array<int, 2> ends, std::size_t number, const std::string& kinds,
                     const std::vector<double>& angles) {
  PatternEdge edge{ends, 'U', kFree, static_cast<int>(number)};
  if (!angles.empty()) edge.angle = angles[number];
  if (kinds.empty()) {
    if (edge.angle < 0) edge.kind = 'M';
    if (edge.angle > 0) edge.kind = 'V';
    if (edge.angle == 0) edge.kind = 'F';
    return edge;
  }
  edge.kind = kinds[number];
  if (angles.empty() && edge.kind == 'M') edge.angle = -M_PI;
  if (angles.empty() && edge.kind == 'V') edge.angle = M_PI;
  if ((edge.kind == 'M' && edge.angle > 0) || (edge.kind == 'V' && edge.angle < 0)) {
    refuse("edges_vertices[", number, "] is assigned ", edge.kind, ", but its fold angle is ",
           edge.angle * 180 / M_PI);
  }
  // FOLD writes 0 for unassigned edges too: that asks for nothing.
  if (edge.kind == 'U' && edge.angle == 0) edge.angle = kFree;
  if (!edge.isCrease()) edge.angle = 0;
  return edge;
}

bool sameFold(const PatternEdge& a, const PatternEdge& b) {
  if (a.kind != b.kind) return false;
  return (std::isnan(a.angle) && std::isnan(b.angle)) || std::abs(a.angle - b.angle) < 1e-9;
}

void addEdge(CreasePattern& pattern, std::map<Ends, std::size_t>& known, const PatternEdge& edge) {
  const auto [a, b] = edge.vertices;
  if (a == b) refuse("edges_vertices[", edge.number, "] has no length");
  const auto [at, is_new] = known.emplace(sorted(a, b), pattern.edges.size());
  if (is_new) {
    pattern.edges.push_back(edge);
  } else if (!sameFold(pattern.edges[at->second], edge)) {
    refuse("edges_vertices[", pattern.edges[at->second].number, "] and edges_vertices[",
           edge.number, "] join the same vertices, but fold differently");
  }
}

double polygonArea(const std::vector<Vector2>& points, const std::vector<int>& polygon) {
  double doubled = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    doubled += doubleArea(points[polygon[0]], points[polygon[i - 1]], points[polygon[i]]);
  }
  return doubled / 2;
}

void readFaces(const FoldDocument& document, const std::vector<int>& stand_in,
               CreasePattern& pattern) {
  pattern.faces = document.faces(pattern.frame, static_cast<int>(pattern.points.size()));
  for (std::size_t f = 0; f < pattern.faces.size(); ++f) {
    std::vector<int>& face = pattern.faces[f];
    for (int& v : face) v = stand_in[v];
    const double area = polygonArea(pattern.points, face);
    if (area == 0) refuse("faces_vertices[", f, "] has no area");
    if (area < 0) std::reverse(face.begin() + 1, face.end());
  }
}

/// How many faces lie on each edge; sides of faces that are no edges become edges.
std::vector<int> countFaces(CreasePattern& pattern, std::map<Ends, std::size_t>& known) {
  std::vector<int> counts(pattern.edges.size());
  for (const std::vector<int>& face : pattern.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      if (a == b) continue;
      const auto [at, is_new] = known.emplace(sorted(a, b), pattern.edges.size());
      if (is_new) {
        pattern.edges.push_back({{a, b}, 'F', 0, -1});
        counts.push_back(0);
      }
      if (++counts[at->second] > 2) {
        refuse(pattern.edgeName(pattern.edges[at->second]), " has more than two faces");
      }
    }
  }
  return counts;
}

void findBorder(CreasePattern& pattern, std::map<Ends, std::size_t>& known) {
  const bool has_faces = !pattern.faces.empty();
  const std::vector<int> counts = countFaces(pattern, known);
  for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
    PatternEdge& edge = pattern.edges[i];
    const bool said = edge.kind == 'B' || edge.kind == 'C';
    if (has_faces && said && counts[i] == 0) refuse(pattern.edgeName(edge), " is on no face");
    if (has_faces && said && counts[i] == 2) {
      refuse(pattern.edgeName(edge), edge.kind == 'C' ? " is a cut" : " is border",
             " (", edge.kind, ") with paper on both sides, and a slit cannot be loaded");
    }
    if (said || counts[i] == 1) {
      edge.kind = 'B';
      edge.angle = 0;
    }
  }
  if (std::none_of(pattern.edges.begin(), pattern.edges.end(),
                   [](const PatternEdge& edge) { return edge.isBorder(); })) {
    refuse("has no outline: no border edges (B) and no faces");
  }
}

}  // namespace

bool CreasePattern::hasOnlyTriangles() const {
  return !faces.empty() && std::all_of(faces.begin(), faces.end(),
                                       [](const auto& face) { return face.size() == 3; });
}

std::string CreasePattern::edgeName(const PatternEdge& edge) const {
  const auto ends = " from vertex " + std::to_string(file_vertices[edge.vertices[0]]) + " to " +
                    std::to_string(file_vertices[edge.vertices[1]]);
  if (edge.number < 0) return "the side" + ends;
  return "edges_vertices[" + std::to_string(edge.number) + "]" + ends;
}

CreasePattern readPattern(const FoldDocument& document) {
  CreasePattern pattern;
  findFlatFrame(document, pattern);
  const int count = static_cast<int>(pattern.points.size());
  pattern.file_vertices.resize(count);
  std::iota(pattern.file_vertices.begin(), pattern.file_vertices.end(), 0);
  const std::vector<int> stand_in = mergeCoincident(pattern.points);

  const auto ends = document.edges(pattern.frame, count);
  const std::string kinds = document.assignments(pattern.frame, ends.size());
  const std::vector<double> angles = document.foldAngles(pattern.frame, ends.size());
  std::map<Ends, std::size_t> known;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::array<int, 2> merged{stand_in[ends[i][0]], stand_in[ends[i][1]]};
    addEdge(pattern, known, makeEdge(merged, i, kinds, angles));
  }
  readFaces(document, stand_in, pattern);
  findBorder(pattern, known);
  pattern.noted = document.notedCreases(pattern.frame, count);
  for (NotedCrease& crease : pattern.noted) {
    for (int& v : crease.vertices) v = stand_in[v];
  }
  return pattern;
}

void dropUnused(CreasePattern& pattern, bool keep_flat_edges) {
  if (!keep_flat_edges) {
    pattern.faces.clear();
    auto& edges = pattern.edges;
    edges.erase(std::remove_if(edges.begin(), edges.end(),
                               [](const PatternEdge& e) { return !e.isCrease() && !e.isBorder(); }),
                edges.end());
  }
  std::vector<int> renumbered(pattern.points.size(), -1);
  for (const PatternEdge& edge : pattern.edges) {
    for (int v : edge.vertices) renumbered[v] = 0;
  }
  std::size_t kept = 0;
  for (std::size_t v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] < 0) continue;
    renumbered[v] = static_cast<int>(kept);
    pattern.points[kept] = pattern.points[v];
    pattern.file_vertices[kept++] = pattern.file_vertices[v];
  }
  pattern.points.resize(kept);
  pattern.file_vertices.resize(kept);
  for (PatternEdge& edge : pattern.edges) {
    for (int& v : edge.vertices) v = renumbered[v];
  }
  for (auto& face : pattern.faces) {
    for (int& v : face) v = renumbered[v];
  }
  for (NotedCrease& crease : pattern.noted) {
    for (int& v : crease.vertices) {
      if (renumbered[v] < 0) refuse("crease ", crease.name, " names vertex ", v, " off its edges");
      v = renumbered[v];
    }
  }
}

}  // namespace shell_origami
