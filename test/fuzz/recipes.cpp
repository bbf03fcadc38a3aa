#include <shell_origami/origami/recipe.h>
#include "test/fuzz/fuzz.h"
#include "test/fuzz/whole.h"
#include "test/sheet/random_sheets.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;

/// A number whose logarithm is uniform.
double logBetween(RandomSheets& random, double low, double high) {
  return std::exp(random.between(std::log(low), std::log(high)));
}

SimulationConfig randomConfig(RandomSheets& random) {
  SimulationConfig config;
  Material& material = config.material;
  material.youngs_modulus = logBetween(random, 6e7, 6e10);
  material.thickness = logBetween(random, 1e-5, 1e-3);
  material.density = logBetween(random, 80, 8000);
  material.crease_stiffness = logBetween(random, 1e-4, 1e-1);
  material.air_damping = random.between(0, 10);
  if (random.below(4) == 0) material.membrane = MembraneKind::kDiscreteShells;
  if (random.below(4) == 0) material.yield_curvature = random.between(20, 200);
  if (random.below(4) == 0) config.rest.curvature = random.between(-50, 50);
  if (random.below(4) == 0) config.solver.integrator = IntegratorKind::kBackwardEuler;
  if (random.below(2) == 0) {
    for (int i = 0; i < 3; ++i) config.gravity[i] = random.between(-9.81, 9.81);
  }
  return config;
}

FoldStep randomFolds(RandomSheets& random, const SheetSource& sheet) {
  FoldStep step;
  step.duration = std::max(0.0, random.between(-0.3, 1));  // in a quarter of the folds 0
  for (int i = 1 + random.below(2); i > 0; --i) {
    FoldEdit fold;
    const auto point = [&] {
      return Vector2(random.between(0, sheet.width), random.between(0, sheet.height));
    };
    fold.where = Segment{point(), point()};
    fold.angle = random.between(-175, 175) * kDegree;
    step.folds.push_back(fold);
  }
  return step;
}

Recipe randomRecipe(RandomSheets& random) {
  Recipe recipe;
  recipe.config = randomConfig(random);
  SheetSource& sheet = recipe.sheet;
  sheet.width = random.between(0.05, 0.2);
  sheet.height = random.between(0.05, 0.2);
  sheet.max_edge = random.between(0.015, 0.03);
  for (int i = 1 + random.below(4); i > 0; --i) {
    if (random.below(3) == 0) {
      recipe.steps.push_back(PinStep{
          std::vector<Vector2>{{random.between(0, sheet.width), random.between(0, sheet.height)}}});
    }
    recipe.steps.push_back(randomFolds(random, sheet));
    recipe.steps.push_back(SettleStep{random.between(0, 0.3)});
    if (random.below(4) == 0) recipe.steps.push_back(UnpinStep{});
  }
  return recipe;
}

/// Within this time [s] paper must come to rest.
constexpr double kSettles = 25;

/// Whether nothing moves the paper once it is folded: what it does by then, the air damps.
bool mustSettle(const SimulationConfig& config) {
  return config.gravity.isZero() && config.material.air_damping >= 1;
}

/// Folds the recipe to its end. Returns the error message of a step that did not converge; empty:
/// all did. \throws std::logic_error when the paper does not settle
std::string fold(const Recipe& recipe) {
  RecipeRunner runner(recipe);
  Simulation simulation = makeSimulation(recipe.sheet, recipe.config);
  while (runner.update(simulation)) {
    const StepReport report = simulation.step();
    checkWhole(simulation);
    checkApart(simulation);
    if (!report.converged) return report.failure;
  }
  const double end = simulation.time();
  while (mustSettle(recipe.config) && !simulation.settled()) {
    if (simulation.time() > end + kSettles) throw std::logic_error("it never settles");
    const StepReport report = simulation.step();
    if (!report.converged) return report.failure;
  }
  simulation.sheet().validate();
  return "";
}

}  // namespace

bool fuzzRecipes(int recipes, unsigned seed) {
  RandomSheets random(seed);
  int done = 0, paused = 0, rejected = 0;
  for (int i = 0; i < recipes; ++i) {
    const Recipe recipe = randomRecipe(random);
    try {
      const std::string pause = fold(recipe);
      if (pause.empty()) {
        ++done;
      } else {
        ++paused;
        std::printf("recipe %d pauses: %s\n", i, pause.c_str());
      }
    } catch (const std::invalid_argument& reason) {
      ++rejected;  // a line that would leave an edge too short, say
      std::printf("recipe %d is rejected: %s\n", i, reason.what());
    } catch (const std::exception& broken) {
      std::printf("recipe %d is broken: %s\n", i, broken.what());
      return false;
    }
  }
  std::printf("%d recipes to their end, %d paused and %d rejected with a reason\n", done, paused,
              rejected);
  return rejected <= recipes / 50;
}

}  // namespace shell_origami
