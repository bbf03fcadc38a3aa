/// Item 5: a sheet rolled to a cylinder stores B/2 kappa^2 per area.
#include "verify/cylinder.h"
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>
#include "verify/topics.h"

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.1, kCurvature = 5;  // [m], [1/m]
const std::string kItem = "5 Energy of a cylinder";
const std::string kWhyEnergy =
    "border edges are not hinges: half a row at either side of the sheet stores no energy, in all "
    "one edge over the side";

/// Bending energy over that of the plate.
double energyRatio(const Sheet& sheet, double direction) {
  const Material material;
  const Shell shell(sheet, material);
  const double plate = material.bendingStiffness() / 2 * kCurvature * kCurvature * sheet.area();
  return shell.bendingEnergy(onCylinder(sheet, kCurvature, direction), shell.restState()) / plate;
}

}  // namespace

Positions onCylinder(const Sheet& sheet, double curvature, double direction) {
  const Vector2 along(std::cos(direction), std::sin(direction)), across(-along.y(), along.x());
  Positions x(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const double turn = curvature * along.dot(sheet.flatPositions()[v]);
    const Vector2 at =
        std::sin(turn) / curvature * along + across.dot(sheet.flatPositions()[v]) * across;
    x.col(v) = Vector3(at.x(), at.y(), (1 - std::cos(turn)) / curvature);
  }
  return x;
}

void verifyCylinder(VerificationReport& report) {
  std::vector<double> edges{0.008, 0.004, 0.002};
  if (!report.fast()) edges.insert(edges.end(), {0.001, 0.0005});
  FigureData figure = report.figure("cylinder", {"max_edge", "direction", "ratio"});
  std::vector<double> worst;  // error on each mesh
  for (const double edge : edges) {
    const Sheet sheet(triangulateRectangle(kSide, kSide, edge));
    worst.push_back(0);
    for (int degrees = 0; degrees < 180; degrees += 30) {
      const double ratio = energyRatio(sheet, degrees * M_PI / 180);
      figure.row({edge, static_cast<double>(degrees), ratio});
      worst.back() = std::max(worst.back(), std::abs(ratio - 1));
      if (edge != edges.back()) continue;
      report.add({kItem, "energy over B/2 kappa^2 A, direction " + std::to_string(degrees), 1,
                  ratio, edge / kSide, kWhyEnergy});
    }
  }
  const double order = std::log2(worst[worst.size() - 2] / worst.back());
  report.add({kItem, "order of the worst direction's error in the mesh", 1, order, 0.05,
              "first order, from the border; 0.05 because rows do not halve exactly"});
}

}  // namespace shell_origami
