/// Item 8: Miura-ori, folded by its zigzags.
#include "verify/rigid_origami.h"
#include "verify/topics.h"

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr int kPanels = 6;
constexpr double kPanel = 0.025, kAcute = 60 * kDegree;  // [m], of recipes/miura.yaml
const std::string kItem = "8 Miura-ori";
/// The zigzags are driven and the straight creases follow: rigid folding, so that an error is what
/// is left of the motion to equilibrium.
constexpr double kTolerance = 7e-6;
const std::string kWhyForm =
    "Newton's method stops at 1e-5 m/s: a vertex then moves by less than 1.7e-7 m in a step, 7e-6 "
    "of a panel's side";

double distance(const Simulation& simulation, const Vector2& a, const Vector2& b) {
  const Sheet& sheet = simulation.sheet();
  return (simulation.positions().col(sheet.nearestVertex(a)) -
          simulation.positions().col(sheet.nearestVertex(b)))
      .norm();
}

/// Largest relative error of a fold angle.
double angleError(const Simulation& simulation, const Miura& exact) {
  double error = 0;
  for (const CreaseStatus& crease : simulation.creases()) {
    const bool zigzag = crease.name.rfind("zigzag", 0) == 0;
    const double expected = zigzag ? exact.zigzagAngle() : exact.otherAngle();
    error = std::max(error, std::abs(std::abs(crease.angle) / expected - 1));
  }
  return error;
}

}  // namespace

void verifyMiura(VerificationReport& report) {
  FigureData figure = report.figure("miura", {"angle", "length", "width"});
  double angles = 0, lengths = 0, widths = 0;
  Simulation simulation = fromRecipe("miura");
  const double across = kPanels * kPanel * std::sin(kAcute);
  for (double degrees = report.fast() ? 45 : 15; degrees <= 150;
       degrees += report.fast() ? 45 : 15) {
    foldAndRest(simulation, {{"zigzag_valley", 1}, {"zigzag_mountain", -1}}, degrees * kDegree);
    const Miura exact{kPanel, kPanel, kAcute, degrees * kDegree / 2};
    const double length = distance(simulation, {0, 0}, {kPanels * kPanel, 0}) / kPanels;
    const double width = distance(simulation, {0, 0}, {0, across}) / kPanels;
    figure.row({degrees, length / kPanel, width / kPanel});
    angles = std::max(angles, angleError(simulation, exact));
    lengths = std::max(lengths, std::abs(length / exact.length() - 1));
    widths = std::max(widths, std::abs(width / exact.width() - 1));
  }
  const std::string states = report.fast() ? " at 3 states" : " at 10 states";
  const std::string error = "largest relative error of ";
  report.add({kItem, error + "a fold angle" + states, 0, angles, kTolerance, kWhyForm});
  report.add({kItem, error + "the length" + states, 0, lengths, kTolerance, kWhyForm});
  report.add({kItem, error + "the width" + states, 0, widths, kTolerance, kWhyForm});
}

}  // namespace shell_origami
