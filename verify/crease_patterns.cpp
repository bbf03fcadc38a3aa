#include "verify/crease_patterns.h"

#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kPart = 178.0 / 180;    ///< of the angles that a pattern asks for
constexpr double kRightDistance = 0.02;  ///< [widths]
/// Around a vertex that closes at 180 degrees only, panels are open by up to some 4 degrees where
/// creases fold to 178: creases off by less than this are no failure of folding.
constexpr double kRightAngle = 5 * M_PI / 180;
constexpr double kTimeout = 5;  ///< to settle [s]

Recipe recipeOf(const std::string& path, double compliance) {
  std::ostringstream steps, factor;
  steps.precision(17);
  steps << "[{fold: [{crease: all, part: " << kPart << "}]}, {settle: {timeout: " << kTimeout
        << "}}]";
  factor << compliance;
  SheetSource sheet;
  sheet.width = kPatternWidth;
  return loadRecipe(
      path, {}, sheet,
      {{"steps", steps.str()}, {"compliance/factor", factor.str()}, {"contact/enabled", "false"}});
}

double distance(const Positions& shape, const Positions& target) {
  const Eigen::Affine3d fit(Eigen::umeyama(shape, target, false));
  return std::sqrt((fit * shape - target).squaredNorm() / static_cast<double>(shape.cols())) /
         kPatternWidth;
}

/// Ascending [rad].
std::vector<double> creaseErrors(const Simulation& simulation) {
  std::vector<double> errors;
  for (const CreaseStatus& crease : simulation.creases()) {
    if (crease.driven) errors.push_back(std::abs(crease.angle - crease.target_angle));
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

}  // namespace

std::optional<Positions> rigidState(const Sheet& sheet) {
  std::vector<double> angles;
  for (const Crease& crease : sheet.creases()) {
    angles.push_back(std::isnan(crease.pattern_angle) ? 0 : crease.pattern_angle);
  }
  for (int v : innerCreaseVertices(sheet)) {
    if (closingError(sheet, v, angles) > kClosingTolerance) return std::nullopt;
  }
  return foldRigidly(sheet, angles);
}

bool PatternOutcome::isOff() const { return distance > kRightDistance || worst > kRightAngle; }

PatternOutcome foldPattern(const std::string& path, double compliance) {
  RecipeRunner runner(recipeOf(path, compliance));
  Simulation simulation = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  PatternOutcome outcome;
  const std::clock_t start = std::clock();
  while (outcome.said.empty() && runner.update(simulation))
    outcome.said = simulation.step().failure;
  outcome.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / simulation.time();
  if (outcome.said.empty()) outcome.said = missedSentence(missedCreases(simulation));
  if (outcome.said.empty() && !simulation.settled()) outcome.said = "it has not settled";
  const std::vector<double> errors = creaseErrors(simulation);
  if (errors.empty()) throw std::invalid_argument(path + " asks for no fold");
  outcome.worst = errors.back();
  outcome.median = errors[errors.size() / 2];
  outcome.strain = simulation.maxStrain();
  outcome.triangles = simulation.sheet().triangles().size();
  const auto exact = rigidState(simulation.sheet());
  outcome.distance = exact ? distance(simulation.positions(), *exact) : std::nan("");
  return outcome;
}

}  // namespace shell_origami
