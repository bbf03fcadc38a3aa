/// \file
/// Paper that nothing moves comes to rest.
#include <shell_origami/origami/recipe.h>

#include <gtest/gtest.h>

namespace shell_origami {
namespace {

/// Two creases, the second across the first.
Recipe twoFolds(const std::string& first, const std::string& second) {
  RecipeText text;
  text.text = "sheet: {size: [0.15, 0.15]}\nsteps:\n  - fold: [{" + first + "}]\n  - fold: [{" +
              second + "}]\n";
  return readRecipe(text);
}

/// Newmark's scheme fed the motion of a corner of the paper, to and fro within four steps.
TEST(Settling, ACornerThatSnapsComesToRest) {
  const Recipe recipe = twoFolds("line: [[0.055, 0.15], [0.15, 0.079]], angle_deg: 60.5",
                                 "line: [[0, 0.053], [0.066, 0.15]], angle_deg: 148.2");
  RecipeRunner runner(recipe);
  Simulation simulation = makeSimulation(recipe.sheet, recipe.config);
  while (runner.update(simulation)) ASSERT_TRUE(simulation.step().converged);
  const double folded = simulation.time();
  while (!simulation.settled() && simulation.time() < folded + 5) {
    ASSERT_TRUE(simulation.step().converged);
  }
  EXPECT_TRUE(simulation.settled());
  // It is not stepped any more soon after.
  while (simulation.step().newton_iterations > 0 && simulation.time() < folded + 5) {
  }
  EXPECT_EQ(simulation.step().newton_iterations, 0);
  EXPECT_EQ(simulation.energies().kinetic, 0);
}

}  // namespace
}  // namespace shell_origami
