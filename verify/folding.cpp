#include "verify/folding.h"

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/recipe.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shell_origami {

Sheet vertexSheet(const std::vector<double>& directions, const std::vector<double>& signs,
                  double radius, double max_edge) {
  PlanarGraph graph;
  graph.points = {Vector2::Zero()};
  for (std::size_t k = 0; k < directions.size(); ++k) {
    graph.segments.push_back({0, static_cast<int>(graph.points.size())});
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
  const GraphMesh mesh = meshGraph(graph, max_edge);
  std::vector<Crease> creases;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    creases.push_back({static_cast<std::uint32_t>(k), "rho" + std::to_string(k), mesh.chains[k],
                       signs[k] * M_PI});
  }
  return Sheet(mesh.triangulation, creases);
}

SimulationConfig quasiStatic() {
  SimulationConfig config;
  config.solver.tolerance = 1e-5;
  return config;
}

FoldEdit foldCrease(const std::string& name, double angle, double duration) {
  FoldEdit request;
  request.where = CreaseName{name};
  request.angle = angle;
  request.duration = duration;
  return request;
}

Simulation fromRecipe(const std::string& name) {
  const Recipe recipe = loadRecipe(std::string(RECIPE_FOLDER) + "/" + name + ".yaml", {}, {},
                                   {{"sheet/max_edge", "0.025"}});
  SimulationConfig config = recipe.config;
  config.solver.tolerance = quasiStatic().solver.tolerance;
  return makeSimulation(recipe.sheet, config);
}

void stepUntil(Simulation& simulation, double time) {
  while (simulation.time() < time) {
    const StepReport report = simulation.step();
    if (!report.converged) throw std::runtime_error(report.failure);
  }
}

void foldAndRest(Simulation& simulation, const std::vector<std::pair<std::string, double>>& creases,
                 double angle) {
  for (const auto& [name, sign] : creases) {
    simulation.fold(foldCrease(name, sign * angle, 1.5));
  }
  stepUntil(simulation, simulation.time() + 3.5);
}

}  // namespace shell_origami
