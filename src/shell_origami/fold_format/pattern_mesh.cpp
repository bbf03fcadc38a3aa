#include <shell_origami/fold_format/pattern_mesh.h>

#include <shell_origami/base/error.h>
#include <shell_origami/mesh/cuts.h>
#include <shell_origami/mesh/delaunay.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// A polygon's triangles. \throws std::invalid_argument when its sides cross
std::vector<Triangle> cutFace(const std::vector<int>& face, const std::vector<Vector2>& points) {
  if (face.size() == 3) return {{face[0], face[1], face[2]}};
  PlanarGraph polygon;
  const int count = static_cast<int>(face.size());
  for (int k = 0; k < count; ++k) {
    polygon.points.push_back(points[face[k]]);
    polygon.segments.push_back({k, (k + 1) % count});
  }
  std::vector<Triangle> triangles = constrainedDelaunay(polygon);
  for (Triangle& triangle : triangles) {
    for (int& v : triangle) v = face[v];
  }
  return triangles;
}

/// The file's own faces. \throws std::invalid_argument when they overlap or leave gaps
GraphMesh keepFaces(const CreasePattern& pattern, const Outline& outline) {
  std::vector<Triangle> triangles;
  double area = 0;
  for (const auto& face : pattern.faces) {
    for (const auto& [a, b, c] : cutFace(face, pattern.points)) {
      triangles.push_back({a, b, c});
      area += doubleArea(pattern.points[a], pattern.points[b], pattern.points[c]) / 2;
    }
  }
  // Counter-clockwise triangles inside a simple outline cover it once exactly when areas agree.
  if (!(std::abs(area - outline.area()) <= 1e-6 * area)) {
    reject("faces overlap: together they have ", area / outline.area(),
           " times the area inside the outline");
  }
  GraphMesh result{Triangulation(pattern.points, triangles), {}};
  for (const PatternEdge& edge : pattern.edges) {
    result.chains.push_back({edge.vertices[0], edge.vertices[1]});
  }
  return result;
}

GraphMesh meshLines(const CreasePattern& pattern, const Outline& outline, double max_edge) {
  checkEdges(pattern, outline);
  PlanarGraph graph;
  graph.points = pattern.points;
  for (const PatternEdge& edge : pattern.edges) graph.segments.push_back(edge.vertices);
  for (const auto& hole : outline.holes) graph.holes.push_back(pointInside(hole));
  return meshGraph(graph, max_edge);
}

/// The creases as polylines of the mesh's vertices.
std::vector<Crease> meshCreases(const CreasePattern& pattern, const GraphMesh& mesh) {
  std::map<std::pair<int, int>, std::size_t> edge_at;
  for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
    const auto [a, b] = pattern.edges[i].vertices;
    edge_at[{a, b}] = edge_at[{b, a}] = i;
  }
  std::vector<Crease> creases;
  for (const PatternCrease& line : gatherCreases(pattern)) {
    Crease crease{line.id, line.name, {}, line.angle};
    for (std::size_t k = 1; k < line.vertices.size(); ++k) {
      const std::size_t edge = edge_at.at({line.vertices[k - 1], line.vertices[k]});
      std::vector<int> chain = mesh.chains[edge];
      if (pattern.edges[edge].vertices[1] == line.vertices[k - 1]) {
        std::reverse(chain.begin(), chain.end());
      }
      if (k > 1 && crease.vertices.back() != chain.front()) {
        reject("crease ", line.name, " runs across a cut at ",
               pattern.vertexName(line.vertices[k - 1]));
      }
      crease.vertices.insert(crease.vertices.end(), chain.begin() + (k > 1), chain.end());
    }
    creases.push_back(std::move(crease));
  }
  return creases;
}

}  // namespace

PatternSheet makeSheet(const CreasePattern& pattern, double max_edge) {
  const CreasePattern closed = closeSlits(pattern, max_edge == 0);
  const Outline outline = traceOutline(closed);
  const bool has_open_slits = closed.cuts().size() > pattern.cuts().size();
  const bool keeps_faces =
      max_edge == 0 && (pattern.hasOnlyTriangles() || (!pattern.faces.empty() && has_open_slits));
  const CreasePattern& lines = keeps_faces ? pattern : closed;
  GraphMesh mesh = keeps_faces ? keepFaces(pattern, outline) : meshLines(closed, outline, max_edge);
  std::vector<std::array<int, 2>> sources = openCuts(mesh, lines.cuts());
  PatternSheet made{Sheet(mesh.triangulation, meshCreases(lines, mesh)), {}};
  made.sheet.validate();
  if (max_edge > 0) return made;
  for (const auto& [a, b] : sources) {
    made.file_vertices.push_back({lines.file_vertices[a], lines.file_vertices[b]});
  }
  return made;
}

}  // namespace shell_origami
