/// Item 4: a clamped sheet under its own weight against the heavy elastica.
#include "verify/clamped_sheet.h"
#include "verify/elastica.h"
#include "verify/hanging.h"
#include "verify/topics.h"

#include <cmath>
#include <cstdio>
#include <map>

namespace shell_origami {
namespace {

constexpr double kLength = 0.1;  // [m]
/// Breadths over the length. What the free sides change goes as one over the breadth.
constexpr double kNarrow = 1.5, kWide = 3;
/// The extrapolation to infinite breadth is not more exact than this part of the length.
constexpr double kFloor = 5e-4;
const std::string kItem = "4 Cantilever under its own weight";
const std::string kWhyTip =
    "the mesh is off by up to 1.5 (row / length)^2, and the free sides, which curl, add 0.03 % of "
    "the length";
const std::string kWhyOrder =
    "hinges in rows make a chain of second order; terms of fourth order change the order between "
    "two meshes by up to 0.15. Extrapolated to infinite breadth from breadths 1.5 and 3, which "
    "removes the sides' curl; between the two finest meshes of which the coarser is off by at "
    "least 0.05 % of the length";
const std::string kWhySmall = "1.5 (row / length)^2; extrapolated to infinite breadth";

/// Where a clamped sheet comes to rest, in units of its length.
struct Hanging {
  double row = 0;  ///< height of a row of triangles
  double triangles = 0;
  std::vector<Vector2> shape;  ///< mean of each row of vertices, from the clamp
  double drop() const { return -shape.back().y(); }
  double reach() const { return shape.back().x(); }
};

std::vector<Vector2> meanShape(const ClampedSheet& sheet, const Positions& x) {
  std::map<long, std::pair<Vector2, int>> rows;  // by flat x [nm]
  for (int v = 0; v < sheet.sheet.vertexCount(); ++v) {
    auto& [sum, count] = rows[std::lround(sheet.sheet.flatPositions()[v].x() * 1e9)];
    if (count++ == 0) sum.setZero();
    sum += Vector2(x(0, v) - sheet.clamp, x(2, v)) / sheet.length;
  }
  std::vector<Vector2> shape;
  for (const auto& [at, row] : rows) shape.push_back(row.first / row.second);
  return shape;
}

Hanging hang(double gamma, int rows, double aspect) {
  const ClampedSheet sheet = clampedSheet(kLength, aspect, rows);
  Simulation simulation(sheet.sheet, hangingConfig(gamma, sheet.length, sheet.length));
  simulation.pin(sheet.held);
  comeToRest(simulation);
  return {2 * sheet.clamp / sheet.length, static_cast<double>(sheet.sheet.triangles().size()),
          meanShape(sheet, simulation.positions())};
}

/// A tip's drop and reach on one mesh, of the wide sheet and extrapolated to infinite breadth.
struct Tip {
  Hanging wide;
  double drop, reach;

  Tip(double gamma, int rows) : wide(hang(gamma, rows, kWide)) {
    const Hanging narrow = hang(gamma, rows, kNarrow);
    const double part = kNarrow / (kWide - kNarrow);
    drop = wide.drop() + part * (wide.drop() - narrow.drop());
    reach = wide.reach() + part * (wide.reach() - narrow.reach());
  }
};

/// The order between the two finest meshes of which the coarser one's error is above kFloor.
double observedOrder(const std::vector<Tip>& meshes, double exact_drop) {
  double order = 0;
  for (std::size_t i = 1; i < meshes.size(); ++i) {
    const double before = std::abs(meshes[i - 1].drop - exact_drop);
    const double after = std::abs(meshes[i].drop - exact_drop);
    if (i > 1 && before < kFloor) break;
    order = std::log(before / after) / std::log(meshes[i - 1].wide.row / meshes[i].wide.row);
  }
  return order;
}

/// Bound on the error of a tip's place, and of a small drop relative to itself: a row of hinges
/// puts the curvature of a row's height into one line.
double meshError(const Hanging& mesh) { return 1.5 * mesh.row * mesh.row; }

std::string at(double gamma) {
  char text[32];
  std::snprintf(text, sizeof text, ", Gamma = %g", gamma);
  return text;
}

}  // namespace

void verifyCantilever(VerificationReport& report) {
  const std::vector<int> levels =
      report.fast() ? std::vector{4, 8, 16} : std::vector{6, 12, 24, 48};
  FigureData shapes = report.figure("cantilever_shape", {"gamma", "kind", "x", "z"});
  FigureData convergence = report.figure(
      "cantilever_convergence",
      {"gamma", "row", "triangles", "drop_error", "reach_error", "endless_drop_error"});
  for (const double gamma : {1.0, 5.0, 10.0, 20.0}) {
    const std::vector<Vector2> elastica = heavyElastica(gamma);
    const double drop = -elastica.back().y(), reach = elastica.back().x();
    std::vector<Tip> meshes;
    for (int rows : levels) {
      meshes.emplace_back(gamma, rows);
      const Tip& tip = meshes.back();
      convergence.row({gamma, tip.wide.row, tip.wide.triangles, tip.wide.drop() - drop,
                       tip.wide.reach() - reach, tip.drop - drop});
    }
    const Hanging& finest = meshes.back().wide;
    for (const Vector2& p : elastica) shapes.row({gamma, 0, p.x(), p.y()});
    for (const Vector2& p : finest.shape) shapes.row({gamma, 1, p.x(), p.y()});
    const double tolerance = meshError(finest) + 3e-4;
    report.add({kItem, "tip drop / L" + at(gamma), drop, finest.drop(), tolerance, kWhyTip});
    report.add({kItem, "tip reach / L" + at(gamma), reach, finest.reach(), tolerance, kWhyTip});
    report.add({kItem, "order of the tip drop in the mesh" + at(gamma), 2,
                observedOrder(meshes, drop), 0.15, kWhyOrder});
  }
  constexpr double kSmall = 0.01;
  const Tip tip(kSmall, levels[levels.size() - 2]);
  report.add({kItem, "tip drop / L over Gamma / 8" + at(kSmall), 1, tip.drop / (kSmall / 8),
              meshError(tip.wide), kWhySmall});
}

}  // namespace shell_origami
