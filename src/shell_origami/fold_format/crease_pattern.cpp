#include <shell_origami/fold_format/crease_pattern.h>

#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/layer_orders.h>
#include <shell_origami/fold_format/planarize.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace shell_origami {
namespace {

constexpr double kFree = std::numeric_limits<double>::quiet_NaN();

using Ends = std::pair<int, int>;
Ends sorted(int a, int b) { return std::minmax({a, b}); }

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
    reject("edges_vertices[", number, "] is assigned ", edge.kind, ", but its fold angle is ",
           edge.angle * 180 / M_PI);
  }
  // FOLD writes 0 for unassigned edges too: that asks for nothing.
  if (edge.kind == 'U' && edge.angle == 0) edge.angle = kFree;
  if (!edge.isCrease()) edge.angle = 0;
  return edge;
}

double polygonArea(const std::vector<Vector2>& points, const std::vector<int>& polygon) {
  double doubled = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    doubled += doubleArea(points[polygon[0]], points[polygon[i - 1]], points[polygon[i]]);
  }
  return doubled / 2;
}

/// Whether the sides with one face are just those edges that the file says are border or cut. Then
/// the faces part where they are meant to, and vertices that coincide there are two.
bool facesPartAtBorder(const std::vector<std::array<int, 2>>& ends, const std::string& kinds,
                       const std::vector<std::vector<int>>& faces) {
  std::map<Ends, int> counts;
  for (const auto& face : faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      ++counts[sorted(face[k], face[(k + 1) % face.size()])];
    }
  }
  std::set<Ends> said;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] != 'B' && kinds[i] != 'C') continue;
    const auto side = counts.find(sorted(ends[i][0], ends[i][1]));
    if (side == counts.end() || (kinds[i] == 'B' && side->second > 1)) return false;
    if (side->second == 1) said.insert(side->first);
  }
  const auto single = std::count_if(counts.begin(), counts.end(),
                                    [](const auto& side) { return side.second == 1; });
  return single == static_cast<std::ptrdiff_t>(said.size());
}

void addFaces(std::vector<std::vector<int>> faces, const std::vector<int>& stand_in,
              CreasePattern& pattern) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<int>& face = faces[f];
    for (int& v : face) v = stand_in[v];
    const double area = polygonArea(pattern.points, face);
    if (area == 0) reject("faces_vertices[", f, "] has no area");
    if (area < 0) std::reverse(face.begin() + 1, face.end());
  }
  pattern.faces = std::move(faces);
}

/// Returns the number of faces at each edge; sides of faces that are not edges become edges.
std::vector<int> countFaces(CreasePattern& pattern, EdgeCollector& edges) {
  std::vector<int> counts(pattern.edges.size());
  for (const std::vector<int>& face : pattern.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      if (a == b) continue;
      const auto there = edges.find(a, b);
      const std::size_t at = there ? *there : edges.add({{a, b}, 'F', 0, -1});
      counts.resize(pattern.edges.size());
      if (++counts[at] > 2) reject(pattern.edgeName(pattern.edges[at]), " has more than two faces");
    }
  }
  return counts;
}

void findBorder(CreasePattern& pattern, EdgeCollector& edges) {
  const std::vector<int> counts = countFaces(pattern, edges);
  for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
    PatternEdge& edge = pattern.edges[i];
    const bool said = edge.isBorder() || edge.isCut();
    if (said && counts[i] == 0) reject(pattern.edgeName(edge), " is on no face");
    if (edge.isBorder() && counts[i] == 2) {
      reject(pattern.edgeName(edge), " is border (B) with paper on both sides");
    }
    if (counts[i] == 1) {
      edge.kind = 'B';
      edge.angle = 0;
    }
  }
}

/// Reads edges that bound faces.
void readWithFaces(const std::vector<PatternEdge>& file_edges, const std::string& kinds,
                   std::vector<std::vector<int>> faces, CreasePattern& pattern) {
  std::vector<std::array<int, 2>> ends;
  for (const PatternEdge& edge : file_edges) ends.push_back(edge.vertices);
  const std::vector<int> stand_in = facesPartAtBorder(ends, kinds, faces)
                                        ? pattern.file_vertices
                                        : mergeCoincident(pattern.points);
  EdgeCollector edges(pattern);
  for (PatternEdge edge : file_edges) {
    for (int& v : edge.vertices) v = stand_in[v];
    edges.add(edge);
  }
  addFaces(std::move(faces), stand_in, pattern);
  findBorder(pattern, edges);
  for (NotedCrease& crease : pattern.noted) {
    for (int& v : crease.vertices) v = stand_in[v];
  }
}

}  // namespace

bool PatternEdge::foldsLike(const PatternEdge& other) const {
  if (kind != other.kind) return false;
  return (std::isnan(angle) && std::isnan(other.angle)) || std::abs(angle - other.angle) < 1e-9;
}

std::size_t EdgeCollector::add(const PatternEdge& edge) {
  const auto [a, b] = edge.vertices;
  if (a == b) reject("edges_vertices[", edge.number, "] has no length");
  auto& edges = pattern_.edges;
  const auto [at, is_new] = places_.emplace(sorted(a, b), edges.size());
  if (is_new) {
    edges.push_back(edge);
  } else if (!edges[at->second].foldsLike(edge)) {
    reject(pattern_.edgeName(edges[at->second]), " and ", pattern_.edgeName(edge),
           " join the same vertices, but fold differently");
  }
  return at->second;
}

std::optional<std::size_t> EdgeCollector::find(int a, int b) const {
  const auto at = places_.find(sorted(a, b));
  return at == places_.end() ? std::nullopt : std::optional<std::size_t>(at->second);
}

bool CreasePattern::hasOnlyTriangles() const {
  return !faces.empty() &&
         std::all_of(faces.begin(), faces.end(), [](const auto& face) { return face.size() == 3; });
}

std::vector<std::size_t> CreasePattern::cuts() const {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].isCut()) numbers.push_back(i);
  }
  return numbers;
}

std::string CreasePattern::edgeName(const PatternEdge& edge) const {
  if (!places.empty()) return places[edge.number];
  const auto [a, b] = edge.vertices;
  const auto ends = " from " + vertexName(a) + " to " + vertexName(b);
  if (edge.number < 0) return "the side" + ends;
  return "edges_vertices[" + std::to_string(edge.number) + "]" + ends;
}

std::string CreasePattern::vertexName(int vertex) const {
  if (file_vertices[vertex] >= 0) return "vertex " + std::to_string(file_vertices[vertex]);
  const auto has = [vertex](const PatternEdge& edge) {
    return edge.vertices[0] == vertex || edge.vertices[1] == vertex;
  };
  const auto edge = std::find_if(edges.begin(), edges.end(), has);
  if (edge == edges.end()) return "a point";
  if (!places.empty()) return "a point of " + places[edge->number];
  return "a point of edges_vertices[" + std::to_string(edge->number) + "]";
}

CreasePattern readPattern(const FoldDocument& document, bool keep_flat_edges) {
  CreasePattern pattern;
  findFlatFrame(document, pattern);
  const int count = static_cast<int>(pattern.points.size());
  pattern.file_vertices.resize(count);
  std::iota(pattern.file_vertices.begin(), pattern.file_vertices.end(), 0);
  const auto ends = document.edges(pattern.frame, count);
  const std::string kinds = document.assignments(pattern.frame, ends.size());
  const std::vector<double> angles = document.foldAngles(pattern.frame, ends.size());
  std::vector<PatternEdge> edges;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i][0] == ends[i][1]) reject("edges_vertices[", i, "] has no length");
    edges.push_back(makeEdge(ends[i], i, kinds, angles));
  }
  pattern.noted = document.notedCreases(pattern.frame, count);
  auto faces = document.faces(pattern.frame, count);
  if (faces.empty()) {
    pattern.edges = std::move(edges);
    makePlanar(pattern, keep_flat_edges);
  } else {
    readWithFaces(edges, kinds, std::move(faces), pattern);
  }
  pattern.orders = readLayerOrders(document, pattern);
  return pattern;
}

void dropFlatEdges(CreasePattern& pattern) {
  auto& edges = pattern.edges;
  edges.erase(std::remove_if(edges.begin(), edges.end(), std::mem_fn(&PatternEdge::isFlat)),
              edges.end());
}

void dropUnused(CreasePattern& pattern, bool keep_flat_edges) {
  if (!keep_flat_edges) {
    pattern.faces.clear();
    dropFlatEdges(pattern);
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
      if (renumbered[v] < 0) reject("crease ", crease.name, " names vertex ", v, " off its edges");
      v = renumbered[v];
    }
  }
}

}  // namespace shell_origami
