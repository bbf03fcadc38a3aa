#include <shell_origami/mesh/triangulate.h>

#include <shell_origami/base/error.h>
#include <shell_origami/mesh/delaunay.h>
#include <shell_origami/mesh/mesh_refine.h>
#include <shell_origami/mesh/planar_graph.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// Spacing of the lattice over the longest edge allowed. Below 1 so that triangles beside the
/// segments, which cannot be equilateral, have room.
constexpr double kSpacing = 0.88;
/// Distance over spacing that lattice points keep from segments.
constexpr double kClearance = 0.6;
constexpr int kRounds = 3;

/// Triangles of edge `spacing` on the paper, or that border on its segments.
double expectedTriangles(const Triangulation& paper, const PlanarGraph& graph, double spacing) {
  double area = 0, pieces = 0;
  for (const auto& [a, b, c] : paper.triangles()) {
    area += doubleArea(paper.points()[a], paper.points()[b], paper.points()[c]) / 2;
  }
  for (const auto& [a, b] : graph.segments) {
    pieces += (graph.points[a] - graph.points[b]).norm() / spacing;
  }
  return std::max(area / (std::sqrt(3.0) / 4 * spacing * spacing), pieces);
}

/// \throws std::invalid_argument naming the first point that is not on the paper
Triangulation buildMesh(const PlanarGraph& graph) {
  const std::vector<Triangle> triangles = constrainedDelaunay(graph);
  std::vector<bool> used(graph.points.size());
  for (const Triangle& t : triangles) {
    for (int v : t) used[v] = true;
  }
  const auto off = std::find(used.begin(), used.end(), false);
  if (off != used.end()) reject("point ", off - used.begin(), " lies off the paper");
  return Triangulation(graph.points, triangles);
}

std::vector<Segment> borderOf(const Triangulation& mesh) {
  std::vector<Segment> border;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.neighbour({t, k}) != Triangulation::kNone) continue;
      const auto [a, b] = mesh.ends({t, k});
      border.push_back({mesh.points()[a], mesh.points()[b]});
    }
  }
  return border;
}

/// Labels the edges along each chain with its number.
void labelChains(Triangulation& mesh, const std::vector<std::vector<int>>& chains) {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (std::size_t k = 1; k < chains[i].size(); ++k) {
      mesh.setLabel(*mesh.findSide(chains[i][k - 1], chains[i][k]), static_cast<int>(i));
    }
  }
}

/// The vertices from `from` to `to` along edges with this label.
std::vector<int> followLabel(const Triangulation& mesh, int label, int from, int to) {
  std::vector<int> chain{from};
  while (chain.back() != to) {
    const int v = chain.back(), before = chain.size() > 1 ? chain[chain.size() - 2] : -1;
    for (int t : mesh.around(v)) {
      const int k = mesh.cornerOf(t, v);
      for (const int j : {(k + 1) % 3, (k + 2) % 3}) {
        if (mesh.label({t, j}) != label || chain.back() != v) continue;
        const auto [a, b] = mesh.ends({t, j});
        const int other = a == v ? b : a;
        if (other != before) chain.push_back(other);
      }
    }
  }
  return chain;
}

Triangulation withoutLabels(const Triangulation& mesh) {
  return Triangulation(mesh.points(), mesh.triangles());
}

}  // namespace

GraphMesh meshGraph(const PlanarGraph& graph, double max_edge) {
  checkGraph(graph);
  const Triangulation paper = buildMesh(graph);
  if (max_edge == 0) {
    GraphMesh result{paper, {}};
    for (const auto& [a, b] : graph.segments) result.chains.push_back({a, b});
    return result;
  }
  checkMaxEdge(max_edge);
  const double spacing = kSpacing * max_edge;
  checkPlan(expectedTriangles(paper, graph, spacing), max_edge);

  PlanarGraph fine = graph;
  const auto chains = subdivide(fine, spacing, max_edge);
  const auto inside = latticePoints(fine, borderOf(paper), spacing, kClearance * spacing);
  fine.points.insert(fine.points.end(), inside.begin(), inside.end());

  Triangulation mesh = buildMesh(fine);
  labelChains(mesh, chains);
  for (int round = 0; round < kRounds; ++round) {
    relaxMesh(mesh, max_edge);
    refineMesh(mesh, max_edge);
  }
  GraphMesh result{withoutLabels(mesh), {}};
  for (std::size_t i = 0; i < graph.segments.size(); ++i) {
    const auto [a, b] = graph.segments[i];
    result.chains.push_back(followLabel(mesh, static_cast<int>(i), a, b));
  }
  return result;
}

Triangulation triangulate(const PlanarGraph& graph, double max_edge) {
  checkMaxEdge(max_edge);
  return meshGraph(graph, max_edge).triangulation;
}

}  // namespace shell_origami
