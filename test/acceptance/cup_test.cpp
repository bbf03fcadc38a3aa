/// A model told as people fold it, through layers (recipes/cup.yaml), coarse.
#include "test/acceptance/simulated_layers.h"

#include <shell_origami/origami/recipe.h>

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;

// Seven creases of five folds, none of which is given by its place.
TEST(Cup, IsFoldedThroughItsLayersWithoutACrossing) {
  const Recipe recipe = loadRecipe("../recipes/cup.yaml", {}, {}, {{"sheet/max_edge", "0.015"}});
  Simulation paper = makeSimulation(recipe.sheet, recipe.config);
  RecipeRunner runner(recipe);
  while (runner.update(paper)) {
    const StepReport report = paper.step();
    ASSERT_TRUE(report.converged) << report.failure;
    if (paper.counters().steps % 20 == 0) {
      ASSERT_TRUE(paper.crossings().empty()) << paper.time();
    }
  }
  int valleys = 0, mountains = 0;
  for (const CreaseStatus& crease : paper.creases()) {
    // Those around other layers stay open by some degrees.
    EXPECT_NEAR(crease.angle / kDegree, crease.target_angle / kDegree, 12) << crease.name;
    (crease.angle > 0 ? valleys : mountains) += 1;
  }
  EXPECT_EQ(valleys, 3);
  EXPECT_EQ(mountains, 4);
  for (const std::string& fault : layerFaults(paper)) ADD_FAILURE() << fault;
}

}  // namespace
}  // namespace shell_origami
