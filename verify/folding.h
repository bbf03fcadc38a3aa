/// \file
/// Sheets with creases for the tests against closed forms of rigid folding.
#pragma once

#include "origami/simulation.h"
#include "sheet/triangulate.h"

#include <cmath>
#include <string>
#include <vector>

namespace shell_origami {

constexpr double kDegree = M_PI / 180;

/// A straight line of a pattern between two points of its graph.
struct PatternLine {
  int from, to;
  double angle;  ///< sign: mountain or valley
  std::string name;
};

/// Meshes an outline with creases that meet only in the graph's points.
inline Sheet creasedSheet(PlanarGraph graph, const std::vector<PatternLine>& lines,
                          double max_edge) {
  const std::size_t first = graph.segments.size();
  for (const PatternLine& line : lines) graph.segments.push_back({line.from, line.to});
  const GraphMesh mesh = meshGraph(graph, max_edge);
  std::vector<Crease> creases;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    creases.push_back({static_cast<std::uint32_t>(i), lines[i].name, mesh.chains[first + i],
                       lines[i].angle});
  }
  return Sheet(mesh.triangulation, creases);
}

/// A disc whose creases run from its center to its border, at these angles and each with the sign
/// of its assignment. They are called rho0, rho1, ...
inline Sheet vertexSheet(const std::vector<double>& directions, const std::vector<double>& signs,
                         double radius, double max_edge) {
  PlanarGraph graph;
  graph.points = {Vector2::Zero()};
  std::vector<PatternLine> lines;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const int here = static_cast<int>(graph.points.size());
    lines.push_back({0, here, signs[k] * M_PI, "rho" + std::to_string(k)});
    const double end = k + 1 < directions.size() ? directions[k + 1] : directions[0] + 2 * M_PI;
    const double sector = end - directions[k];
    const int parts = std::max(1, static_cast<int>(std::ceil(radius * sector / max_edge)));
    for (int i = 0; i < parts; ++i) {
      const double t = directions[k] + sector * i / parts;
      graph.points.push_back(radius * Vector2(std::cos(t), std::sin(t)));
    }
  }
  const int ring = static_cast<int>(graph.points.size()) - 1;
  for (int i = 0; i < ring; ++i) graph.segments.push_back({1 + i, 1 + (i + 1) % ring});
  return creasedSheet(graph, lines, max_edge);
}

/// Slow enough to be quasi-static: Newton's velocities below a hundredth of what is seen.
inline SimulationConfig quasiStatic() {
  SimulationConfig config;
  config.solver.tolerance = 1e-5;
  return config;
}

inline FoldRequest foldCrease(const std::string& name, double angle, double duration) {
  FoldRequest request;
  request.where = CreaseName{name};
  request.angle = angle;
  request.duration = duration;
  return request;
}

}  // namespace shell_origami
