/// The order of layers of paper that the simulation has folded flat is one of those that an exact
/// solver finds. That of the cup is tested where it is folded (cup_test.cpp).
#include "test/acceptance/layer_solver.h"
#include "test/acceptance/simulated_layers.h"

#include <shell_origami/origami/recipe.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <variant>

namespace shell_origami {
namespace {

Simulation carryOut(const Recipe& recipe) {
  Simulation paper = makeSimulation(recipe.sheet, recipe.config);
  RecipeRunner runner(recipe);
  while (runner.update(paper)) {
    const StepReport report = paper.step();
    EXPECT_TRUE(report.converged) << report.failure;
    if (!report.converged) break;
  }
  return paper;
}

/// Folds a recipe, coarse, until the first step that leaves layers open.
Simulation foldWhatIsFlat(const std::string& name) {
  Recipe recipe = loadRecipe("../recipes/" + name + ".yaml", {}, {}, {{"sheet/max_edge", "0.015"}});
  const auto opens = [](const RecipeStep& step) {
    const auto* through = std::get_if<FoldThroughStep>(&step);
    return through != nullptr && through->fold->angle < kShutAngle;
  };
  recipe.steps.erase(std::find_if(recipe.steps.begin(), recipe.steps.end(), opens),
                     recipe.steps.end());
  return carryOut(recipe);
}

class LayerOrderTest : public testing::TestWithParam<const char*> {};

TEST_P(LayerOrderTest, IsOneThatTheSolverFinds) {
  const Simulation paper = foldWhatIsFlat(GetParam());
  for (const std::string& fault : layerFaults(paper)) ADD_FAILURE() << fault;
  const FlatFold fold = foldFlat(paper);
  const LayerConditions conditions = layerConditions(fold);
  const SimulatedLayers layers =
      simulatedLayers(paper.sheet(), paper.positions(), fold, conditions);
  const std::vector<Stacking> found = stackings(conditions, 1000);
  EXPECT_EQ(std::count(found.begin(), found.end(), layers.stacking), 1);
  std::printf(
      "%zu panels, %zu pairs, %d taco-taco, %d taco-tortilla, %d transitivity: %zu orders\n",
      fold.panels.size(), conditions.pairs.size(), conditions.count(ConditionKind::kTacoTaco),
      conditions.count(ConditionKind::kTacoTortilla),
      conditions.count(ConditionKind::kTransitivity), found.size());
}

std::string nameOf(const testing::TestParamInfo<const char*>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Recipes, LayerOrderTest,
                         testing::Values("dart", "fox", "house_squash", "map", "windmill"), nameOf);
// Minutes: run with --gtest_also_run_disabled_tests.
INSTANTIATE_TEST_SUITE_P(DISABLED_LongRecipes, LayerOrderTest, testing::Values("crane", "kabuto"),
                         nameOf);

/// A strip of three panels: the first crease is a valley, and the second one has this angle.
Simulation foldStrip(const std::string& angle_deg) {
  RecipeText text;
  text.text = R"(
sheet: {size: [0.09, 0.03], max_edge: 0.015}
contact: {distance: 2.0e-5}
steps:
  - fold: [{line: [[0.03, 0], [0.03, 0.03]], angle_deg: 178}]
  - fold: [{line: [[0.06, 0], [0.06, 0.03]], angle_deg: )" +
              angle_deg + R"(}]
  - settle: {timeout: 1}
)";
  return carryOut(readRecipe(text));
}

class PleatTest : public testing::Test {
 protected:
  SimulatedLayers layersAt(const Positions& positions) const {
    return simulatedLayers(paper_.sheet(), positions, fold_, conditions_);
  }

  Simulation paper_ = foldStrip("-178");
  FlatFold fold_ = foldFlat(paper_);
  LayerConditions conditions_ = layerConditions(fold_);
};

TEST_F(PleatTest, HasOneOrder) {
  EXPECT_EQ(stackings(conditions_, 10).size(), 1u);
  EXPECT_TRUE(layerFaults(paper_).empty());
}

TEST_F(PleatTest, LayersThatChangedPlacesAreFound) {
  Positions upside_down = paper_.positions();
  upside_down.row(2) *= -1;
  const SimulatedLayers layers = layersAt(upside_down);
  EXPECT_TRUE(layers.faults.empty());
  EXPECT_EQ(broken(conditions_, layers.stacking).size(), 2u) << "one for each crease";
}

TEST_F(PleatTest, ALayerThatPassesThroughAnotherIsFound) {
  // The middle one, lifted at the center of the stack alone.
  Positions pushed = paper_.positions();
  const auto& flat = paper_.sheet().flatPositions();
  const auto fromMiddle = [&](int v) { return (flat[v] - Vector2(0.045, 0.015)).norm(); };
  int nearest = 0;
  for (int v = 0; v < paper_.sheet().vertexCount(); ++v) {
    if (fromMiddle(v) < fromMiddle(nearest)) nearest = v;
  }
  pushed(2, nearest) += 0.005;
  const SimulatedLayers layers = layersAt(pushed);
  ASSERT_EQ(layers.faults.size(), 1u);
  EXPECT_EQ(layers.faults[0].find("panels 1 and 2 pass each other between ("), 0u)
      << layers.faults[0];
}

TEST(LayerOrder, APaperWithAnOpenCreaseHasNone) {
  EXPECT_THROW(foldFlat(foldStrip("90")), std::invalid_argument);
}

}  // namespace
}  // namespace shell_origami
