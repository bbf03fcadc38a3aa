#include "test/sheet/random_sheets.h"

#include <shell_origami/mesh/cuts.h>
#include <shell_origami/mesh/mesh_refine.h>

#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

using Loop = std::vector<Vector2>;

PlanarGraph outlineOf(const std::vector<Loop>& loops, const std::vector<Vector2>& holes = {}) {
  PlanarGraph graph;
  for (const Loop& loop : loops) {
    const int first = static_cast<int>(graph.points.size()), count = static_cast<int>(loop.size());
    graph.points.insert(graph.points.end(), loop.begin(), loop.end());
    for (int i = 0; i < count; ++i) {
      graph.segments.push_back({first + i, first + (i + 1) % count});
    }
  }
  graph.holes = holes;
  return graph;
}

PlanarGraph star() {
  Loop loop;
  for (int i = 0; i < 10; ++i) {
    const double radius = i % 2 ? 0.04 : 0.09, angle = M_PI * i / 5;
    loop.emplace_back(0.1 + radius * std::cos(angle), 0.1 + radius * std::sin(angle));
  }
  return outlineOf({loop});
}

double shortestEdge(const Sheet& sheet, const Triangle& t) {
  const auto& p = sheet.flatPositions();
  return std::min(
      {(p[t[0]] - p[t[1]]).norm(), (p[t[1]] - p[t[2]]).norm(), (p[t[2]] - p[t[0]]).norm()});
}

}  // namespace

PlanarGraph ell() {
  return outlineOf({{{0, 0}, {.15, 0}, {.15, .06}, {.06, .06}, {.06, .15}, {0, .15}}});
}

PlanarGraph ring() {
  return outlineOf(
      {{{0, 0}, {.15, 0}, {.15, .15}, {0, .15}}, {{.05, .05}, {.05, .1}, {.1, .1}, {.1, .05}}},
      {{.075, .075}});
}

Triangulation slits(double max_edge) {
  PlanarGraph graph;
  graph.points = {{0, 0},     {.15, 0},  {.15, .15}, {0, .15},  {.06, 0},  {.07, .05}, {.02, .03},
                  {.03, .12}, {.07, .1}, {.1, .1},   {.13, .1}, {.1, .07}, {.1, .13}};
  graph.segments = {{0, 4}, {4, 1}, {1, 2},  {2, 3},  {3, 0}, {4, 5},
                    {6, 7}, {8, 9}, {9, 10}, {11, 9}, {9, 12}};
  GraphMesh mesh = meshGraph(graph, max_edge);
  openCuts(mesh, {5, 6, 7, 8, 9, 10});
  return mesh.triangulation;
}

double RandomSheets::unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }

PlanarGraph RandomSheets::outline() {
  const double width = between(0.05, 0.25), height = between(0.05, 0.25);
  switch (below(4)) {
    case 0: return ell();
    case 1: return ring();
    case 2: return star();
    default: return outlineOf({{{0, 0}, {width, 0}, {width, height}, {0, height}}});
  }
}

Triangulation RandomSheets::mesh(double max_edge) {
  return unit() < 0.2 ? slits(max_edge) : triangulate(outline(), max_edge);
}

Vector2 RandomSheets::point(const Sheet& sheet) {
  if (unit() < 0.3) return sheet.flatPositions()[below(sheet.vertexCount())];
  Eigen::AlignedBox2d box;
  for (const Vector2& p : sheet.flatPositions()) box.extend(p);
  for (;;) {
    const Vector2 p = box.min() + Vector2(unit(), unit()).cwiseProduct(box.sizes());
    if (sheet.triangulation().locate(p, 0)) return p;
  }
}

Segment RandomSheets::line(const Sheet& sheet) {
  for (;;) {
    const Segment line{point(sheet), point(sheet)};
    if ((line[0] - line[1]).norm() > 1e-6) return line;
  }
}

double borderLength(const Sheet& sheet) {
  double length = 0;
  for (const Edge& edge : sheet.edges()) {
    if (!edge.onBorder()) continue;
    const auto [a, b] = edge.vertices;
    length += (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm();
  }
  return length;
}

int unforcedSlivers(const Sheet& sheet, double max_edge) {
  int count = 0;
  for (int t = 0; t < static_cast<int>(sheet.triangles().size()); ++t) {
    count += isSliver(sheet.triangulation(), t, 15 * M_PI / 180) &&
             shortestEdge(sheet, sheet.triangles()[t]) > 0.1 * max_edge;
  }
  return count;
}

}  // namespace shell_origami
