/// Item 17: paper bent beyond yield keeps a part of the bend.
#include <shell_origami/energy/rest_shape.h>
#include <shell_origami/mesh/triangulate.h>
#include "verify/cylinder.h"
#include "verify/pressed_bend.h"
#include "verify/topics.h"

#include <cmath>
#include <cstdio>

namespace shell_origami {
namespace {

const std::string kItem = "17 Creases pressed into paper";

/// Of a sheet bent to `curvature` [1/m] along `direction` [rad]: the energy that it has after it
/// has yielded, over that of an elastic plate that is bent as far as the sheet still is from rest.
double energyOfYielded(const Material& material, double curvature, double direction,
                       double max_edge) {
  const Sheet sheet(triangulateRectangle(0.1, 0.1, max_edge));
  const Shell shell(sheet, material);
  const Positions x = onCylinder(sheet, curvature, direction);
  RestState rest = shell.restState();
  RestShape({}, sheet).yield(material, CurvatureFit(sheet), x, shell, rest);
  const double yield = material.yield_curvature, hardening = material.hardening;
  const double elastic = yield + hardening / (1 + hardening) * (curvature - yield);
  return shell.bendingEnergy(x, rest) /
         (material.bendingStiffness() / 2 * elastic * elastic * sheet.area());
}

void verifyEveryDirection(VerificationReport& report) {
  const double edge = report.fast() ? 0.002 : 0.001, curvature = 30;
  Material material = materialOf(PaperKind::kCopyPaper);
  material.yield_curvature = 10;
  for (int degrees = 0; degrees < 180; degrees += 30) {
    report.add({kItem,
                "energy of paper that yielded over B/2 (kappa - kept)^2 A, direction " +
                    std::to_string(degrees),
                1, energyOfYielded(material, curvature, degrees * M_PI / 180, edge), edge / 0.1,
                "border edges are not hinges, as in item 5"});
  }
}

void verifyPressedBend(VerificationReport& report) {
  FigureData figure = report.figure("pressed_crease", {"gap", "hardening", "kept", "simulated"});
  const double edge = 0.0012;
  const std::vector<double> gaps =
      report.fast() ? std::vector<double>{0.003} : std::vector<double>{0.0015, 0.002, 0.003, 0.004};
  for (const double hardening : {0.4, 1.0}) {
    for (const double gap : gaps) {
      Material material = materialOf(PaperKind::kCopyPaper);
      material.hardening = hardening;
      const double expected = keptOfPressedBend(gap, material) * 180 / M_PI;
      const double measured = simulatedPressedBend(gap, material, edge) * 180 / M_PI;
      figure.row({gap, hardening, expected, measured});
      char quantity[100];
      std::snprintf(quantity, sizeof quantity,
                    "angle kept by a fold pressed to %g mm, hardening %g [degrees]", 1000 * gap,
                    hardening);
      report.add({kItem, quantity, expected, measured, 0.1 * expected,
                  "the formula takes the elastica's shape, which yielding changes: paper that has "
                  "yielded is softer and bends more where it is bent most"});
    }
    if (report.fast()) break;
  }
}

}  // namespace

void verifyPressedCrease(VerificationReport& report) {
  verifyEveryDirection(report);
  verifyPressedBend(report);
}

}  // namespace shell_origami
