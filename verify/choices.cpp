/// \file
/// Items 13 and 14: the membranes and the crease laws compared, on which the defaults are based.
#include <shell_origami/energy/shell.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>
#include "verify/topics.h"

#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.1;

/// Energy of a uniaxial stretch that contracts across by Poisson's ratio, over E t / 2 e^2 A.
double stretchEnergy(const Sheet& sheet, MembraneKind kind, double direction) {
  Material material;
  material.membrane = kind;
  const Shell shell(sheet, material);
  const double e = 1e-6;
  const Vector2 along(std::cos(direction), std::sin(direction)), across(-along.y(), along.x());
  const Eigen::Matrix2d stretch = (1 + e) * along * along.transpose() +
                                  (1 - material.poisson_ratio * e) * across * across.transpose();
  Positions x = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v)
    x.col(v).head<2>() = stretch * sheet.flatPositions()[v];
  const double expected = material.youngs_modulus * material.thickness / 2 * e * e * sheet.area();
  return shell.membraneEnergy(x, shell.restState()) / expected;
}

/// A sheet with a crease along y = side / 2 and perhaps another one millimetre beside it, whose
/// triangles are narrow.
Sheet creased(double max_edge, bool neighbour) {
  Sheet sheet(triangulateRectangle(kSide, kSide, max_edge));
  makeFoldLine(sheet, {Vector2(0, kSide / 2), Vector2(kSide, kSide / 2)}, "crease");
  if (neighbour) {
    makeFoldLine(sheet, {Vector2(0, kSide / 2 + 1e-3), Vector2(kSide, kSide / 2 + 1e-3)}, "beside");
  }
  return sheet;
}

/// Energy of the crease folded by theta with stiff flaps, over c / 2 phi(theta)^2 of its length.
double creaseEnergy(const Sheet& sheet, bool height_term) {
  Material material;
  material.crease_height_term = height_term;
  const Shell shell(sheet, material);
  RestState rest = shell.restState();
  for (int i = 0; i < static_cast<int>(sheet.creases().size()); ++i) {
    shell.setCrease(i, 0, material.crease_stiffness, rest);
  }
  const double theta = 1;
  Positions x = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    const double out = std::max(0.0, p.y() - kSide / 2);
    x.col(v) << p.x(), p.y() - out + out * std::cos(theta), out * std::sin(theta);
  }
  const double phi = 2 * std::tan(theta / 2);
  return shell.bendingEnergy(x, rest) / (material.crease_stiffness / 2 * phi * phi * kSide);
}

void compareMembranes(VerificationReport& report) {
  const char* item = "13 Membranes";
  const Sheet sheet(triangulateRectangle(kSide, kSide, 0.01));
  FigureData table = report.figure("membranes", {"name", "0", "30", "60", "90", "120", "150"});
  for (const auto& [name, kind] : membraneNames()) {
    std::vector<double> stiffness;
    for (int k = 0; k < 6; ++k) stiffness.push_back(stretchEnergy(sheet, kind, k * M_PI / 6));
    table.row(name,
              {stiffness[0], stiffness[1], stiffness[2], stiffness[3], stiffness[4], stiffness[5]});
    if (kind != MembraneKind::kStVenantKirchhoff) continue;
    double worst = 1;
    for (double s : stiffness) worst = std::abs(s - 1) > std::abs(worst - 1) ? s : worst;
    report.add(
        {item,
         "St. Venant-Kirchhoff: energy of a stretch over E t / 2 e^2 A, worst of six directions", 1,
         worst, 2e-6, "the Green strain exceeds the stretch, 1e-6, by half its square"});
  }
}

void compareCreaseLaws(VerificationReport& report) {
  const char* item = "14 The height term of creases";
  FigureData table = report.figure("crease_laws", {"name", "without", "with"});
  const auto compare = [&](const std::string& name, const Sheet& sheet) {
    const double without = creaseEnergy(sheet, false);
    table.row(name, {without, creaseEnergy(sheet, true)});
    report.add(
        {item, "without it: energy over c / 2 phi^2 L, " + name, 1, without, 1e-12, "rounding"});
  };
  compare("edges of 15 mm", creased(0.015, false));
  compare("edges of 5 mm", creased(0.005, false));
  compare("edges of 15 mm and another crease 1 mm beside it", creased(0.015, true));
}

}  // namespace

void verifyChoices(VerificationReport& report) {
  compareMembranes(report);
  compareCreaseLaws(report);
}

}  // namespace shell_origami
