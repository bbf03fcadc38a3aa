/// Item 16: obstacles. A sheet rests on a table and slides down a slope, strips slip out of jaws,
/// hang from them, and hang over a table's edge.
#include "verify/elastica.h"
#include "verify/obstacle_scenes.h"
#include "verify/topics.h"

#include <cmath>
#include <cstdio>

namespace shell_origami {
namespace {

const std::string kItem = "16 Obstacles";
constexpr double kGravity = 9.81;  // [m/s^2]
constexpr double kFriction = 0.4;
/// Below this slip friction is less than its bound [m/s].
constexpr double kSlowest = 1e-4;
/// To which steps are solved [m/s].
constexpr double kSolved = 1e-8;
/// What free sides, which curl, add to a drop, over the length.
constexpr double kCurl = 3e-4;
const std::string kWhyTip =
    "hinges in rows make a chain, off by up to (row / length)^2, and the free sides, which curl, "
    "add 0.03 % of the length";

void verifyWeight(VerificationReport& report, double max_edge) {
  const Simulation simulation = droppedSheet(max_edge);
  const double weight = kGravity * simulation.shell().shell().masses().sum();
  report.add({kItem, "force on a table under a dropped sheet, over the sheet's weight", 1,
              -simulation.obstacleWrenches().at("table").force.z() / weight,
              kSolved / (kGravity * simulation.config().solver.time_step),
              "steps are solved to 1e-8 m/s, weights therefore to 1e-8 / (g dt)"});
}

void verifySlope(VerificationReport& report, double max_edge) {
  const auto at = [](double part) { return std::atan(part * kFriction); };
  report.add({kItem, "speed [m/s] on a slope of 0.98 of the friction", 0,
              slideDown(at(0.98), kFriction, max_edge).speed, kSlowest,
              "friction is below its bound for slips slower than 1e-4 m/s"});
  for (const double part : {1.02, 1.5}) {
    const double slope = at(part);
    const double expected = kGravity * (std::sin(slope) - kFriction * std::cos(slope));
    report.add({kItem,
                "acceleration [m/s^2] on a slope of " + std::to_string(part).substr(0, 4) +
                    " of the friction, g (sin - mu cos)",
                expected, slideDown(slope, kFriction, max_edge).acceleration, 2 * kSolved,
                "speeds, a second apart, are known to 1e-8 m/s"});
  }
}

void verifySlip(VerificationReport& report, double max_edge) {
  const Pull pull = pullOutOfJaws(kFriction, max_edge);
  report.add(
      {kItem, "force at which a strip slips out of two jaws, over mu times theirs", 1,
       pull.force / (kFriction * pull.pressed), 1e-5,
       "edges that are nearly parallel to a jaw's have no common normal with it, and bear a 1e-5 "
       "part of the force or less, without friction"});
}

std::string of(double gamma) {
  char text[32];
  std::snprintf(text, sizeof text, ", Gamma = %g", gamma);
  return text;
}

void verifyJaws(VerificationReport& report, double gamma, int rows) {
  const Vector2 tip = heavyElastica(gamma).back();
  const HangingStrip strip = hangFromJaws(gamma, rows);
  const double tolerance = strip.row * strip.row + kCurl;
  report.add(
      {kItem, "tip drop / L from two jaws" + of(gamma), -tip.y(), strip.drop, tolerance, kWhyTip});
  report.add(
      {kItem, "tip reach / L from two jaws" + of(gamma), tip.x(), strip.reach, tolerance, kWhyTip});
}

void verifyEdge(VerificationReport& report, double gamma, int rows) {
  const EdgeElastica elastica = elasticaOverEdge(gamma);
  const Vector2 tip = elastica.hanging.back();
  const HangingStrip strip = hangOverEdge(gamma, rows);
  const double squared = strip.row * strip.row;
  report.add({kItem, "tip drop / L over a table's edge" + of(gamma), -tip.y(), strip.drop,
              squared + kCurl, kWhyTip});
  report.add({kItem, "tip reach / L over a table's edge" + of(gamma), tip.x(), strip.reach,
              squared + kCurl, kWhyTip});
  report.add({kItem, "height / L to which it lifts off behind the edge" + of(gamma), elastica.bulge,
              strip.bulge, gamma / 8 * squared + 5e-5,
              "the chain touches the edge within a chord, up to curvature / 8 (row / length)^2 "
              "inside of the curve, at either end of the part that lifts off; the curvature is at "
              "most Gamma / 2. Layers lie within a tenth of the distance within which they push"});
}

}  // namespace

void verifyObstacles(VerificationReport& report) {
  const double max_edge = report.fast() ? 0.025 : 0.0125;
  verifyWeight(report, max_edge);
  verifySlope(report, max_edge);
  verifySlip(report, report.fast() ? 0.02 : 0.01);
  const int rows = report.fast() ? 12 : 24;
  for (const double gamma : {1.0, 5.0}) verifyJaws(report, gamma, rows);
  for (const double gamma : {1.0, 5.0}) verifyEdge(report, gamma, rows);
}

}  // namespace shell_origami
