/// Manoeuvres, unfolding, loosening and lines drawn first, as steps of recipes.
#include <shell_origami/origami/precreases.h>
#include <shell_origami/origami/recipe.h>
#include "test/origami/manoeuvres.h"

#include <fstream>
#include <optional>

namespace shell_origami {
namespace {

/// Runs a recipe's text to its end.
Simulation run(const std::string& text) {
  RecipeRunner runner(readRecipe({"test", "", text}));
  Simulation paper = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  while (runner.update(paper)) {
    const StepReport report = paper.step();
    if (!report.converged) throw std::runtime_error(report.failure);
  }
  return paper;
}

double angleOf(const Simulation& paper, const std::string& name) {
  for (const CreaseStatus& crease : paper.creases()) {
    if (crease.name == name) return crease.angle / kDegree;
  }
  throw std::runtime_error("no crease is called " + name);
}

TEST(RecipeSteps, UnfoldTakesTheLastFoldBack) {
  const Simulation paper =
      run("sheet: {size: [0.1, 0.1], max_edge: 0.03}\n"
          "steps:\n"
          "  - fold: [{line: [[0, 0.02], [0.1, 0.02]], angle_deg: 60, name: first}]\n"
          "  - fold_through: {bring: [0, 0.1], to: [0, 0.06], angle_deg: 90, name: second}\n"
          "  - unfold: {step: last}\n"
          "  - settle: {timeout: 3}\n");
  EXPECT_NEAR(angleOf(paper, "first"), 60, 0.5);
  EXPECT_NEAR(angleOf(paper, "second"), 0, 0.5);
}

TEST(RecipeSteps, UnfoldTakesCreasesThatWereNamedBackEachToItsAngle) {
  const Simulation paper =
      run("sheet: {size: [0.1, 0.1], max_edge: 0.03}\n"
          "steps:\n"
          "  - fold: [{line: [[0, 0.02], [0.1, 0.02]], angle_deg: 60, name: pair},\n"
          "           {line: [[0, 0.06], [0.1, 0.06]], angle_deg: -40, name: pair}]\n"
          "  - fold: [{crease: pair, angle_deg: 20}]\n"
          "  - unfold: {step: last}\n"
          "  - settle: {timeout: 3}\n");
  ASSERT_EQ(paper.creases().size(), 2u);
  EXPECT_NEAR(paper.creases()[0].angle / kDegree, 60, 0.5);
  EXPECT_NEAR(paper.creases()[1].angle / kDegree, -40, 0.5);
}

TEST(RecipeSteps, UnfoldTakesAGroupOfAPatternBack) {
  const std::string pattern = testing::TempDir() + "unfold_a_group.cp";
  std::ofstream(pattern) << "1 0 0 4 0\n1 4 0 4 2\n1 4 2 0 2\n1 0 2 0 0\n2 2 0 2 2\n";
  const Simulation paper = run("sheet: {pattern: " + pattern +
                               ", width: 0.1, max_edge: 0.03}\n"
                               "steps:\n"
                               "  - fold: [{crease: mountains, angle_deg: 50}]\n"
                               "  - unfold: {step: last}\n"
                               "  - settle: {timeout: 3}\n");
  ASSERT_EQ(paper.creases().size(), 1u);
  EXPECT_NEAR(paper.creases()[0].angle / kDegree, 0, 0.5);
}

TEST(RecipeSteps, LoosenChangesAStiffnessAndNoAngle) {
  const std::string sheet =
      "sheet: {size: [0.1, 0.1], max_edge: 0.03}\n"
      "steps:\n"
      "  - fold: [{line: [[0, 0.05], [0.1, 0.05]], angle_deg: 60, name: middle}]\n"
      "  - settle: {timeout: 3}\n";
  for (const char* which : {"middle", "[[0, 0.05], [0.1, 0.05]]"}) {
    const Simulation paper =
        run(sheet + "  - loosen: {creases: [" + which + "], stiffness: 1.0e-4}\n");
    EXPECT_NEAR(angleOf(paper, "middle"), 60, 0.5);
    const Snapshot snapshot = paper.snapshot();
    ASSERT_EQ(snapshot.creases.ramps().size(), 1u);
    EXPECT_EQ(snapshot.creases.ramps()[0].stiffness, 1e-4);
  }
  EXPECT_THROW(run(sheet + "  - loosen: {creases: [none], stiffness: 1}\n"), std::invalid_argument);
  EXPECT_THROW(run(sheet + "  - loosen: {creases: [[[0, 0], [0.1, 0]]], stiffness: 1}\n"),
               std::invalid_argument);
}

TEST(RecipeSteps, AManoeuvreThatFailsIsTakenBackAndTriedAgainSlower) {
  // Nothing can turn the tip inside out: it is held.
  RecipeRunner runner(readRecipe(
      {"test", "",
       "sheet: {size: [0.1, 0.1], max_edge: 0.02}\n"
       "contact: {enabled: false}\n"
       "steps:\n"
       "  - fold: [{line: [[0, 0], [0.1, 0.1]], angle_deg: -178}]\n"
       "  - settle: {timeout: 1}\n"
       "  - pin: {points: [[0.1, 0.1], [0.08, 0.1], [0.1, 0.08], [0.02, 0], [0, 0.02]]}\n"
       "  - reverse: {flap: [0.1, 0.1], through: [[0.06, 0.06], [0.1, 0.08]]}\n"
       "    duration: 1\n"}));
  Simulation paper = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  std::optional<std::pair<Snapshot, RecipePlace>> before;
  const auto apply = [&](const std::vector<Edit>& edits) {
    if (!runner.place().started) before.emplace(paper.snapshot(), runner.place());
    paper.apply(edits);
    return true;
  };
  std::vector<double> tries;  // how long each took [s]
  for (bool again = true; again;) {
    try {
      while (runner.update(paper, apply)) ASSERT_TRUE(paper.step().converged);
      FAIL() << "it was done after " << tries.size() << " failures";
    } catch (const StepFailed& failed) {
      EXPECT_EQ(std::string(failed.what()).find("step 4, reverse, failed: crease"), 0u)
          << failed.what();
      tries.push_back(paper.time() - before->first.time);
      paper = Simulation(before->first);
      again = runner.tryAgain(failed, before->second);
    }
  }
  ASSERT_EQ(tries.size(), 2u);
  EXPECT_GT(tries[1], 1.9 * tries[0]);
  EXPECT_EQ(runner.place().step, 3);
  EXPECT_FALSE(runner.place().started);
  const std::vector<std::string> warnings = runner.takeWarnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("tried again"), std::string::npos);
}

double worstError(const Simulation& paper) {
  double worst = 0;
  for (const CreaseStatus& crease : paper.creases()) {
    worst = std::max(worst, std::abs(crease.angle - crease.target_angle) / kDegree);
  }
  return worst;
}

TEST(RecipeSteps, TwoRabbitEarsMakeAFishBase) {
  const Simulation paper =
      run("sheet: {size: [0.1, 0.1], max_edge: 0.012}\n"
          "compliance: {factor: 300}\n"
          "contact: {distance: 2.0e-5}\n"
          "names: {a: {corner: [0, 0]}, b: {corner: [0.1, 0]}, c: {corner: [0.1, 0.1]},\n"
          "        d: {corner: [0, 0.1]}}\n"
          "steps:\n"
          "  - rabbit_ear: {flap: b, base: [a, c]}\n"
          "  - settle: {timeout: 2}\n"
          "  - rabbit_ear: {flap: d, base: [a, c]}\n"
          "  - settle: {timeout: 2}\n");
  EXPECT_EQ(paper.creases().size(), 8u);
  EXPECT_LT(worstError(paper), 2);
  EXPECT_TRUE(crossings(paper.sheet(), paper.positions()).empty());
  // Both ears point to the same corner, near which they lie.
  const Vector3 to = pointInSpace(Vector2(0.1, 0.1), paper.sheet(), paper.positions());
  for (const Vector2& tip : {Vector2(0.1, 0), Vector2(0, 0.1)}) {
    const Vector3 there = pointInSpace(tip, paper.sheet(), paper.positions());
    EXPECT_NEAR((there - to).norm(), 0.1 * (std::sqrt(2.0) - 1), 2e-3);
  }
}

TEST(RecipeSteps, APleatOfAStripMovesItsEndAlong) {
  const Simulation paper =
      run("sheet: {size: [0.1, 0.05], max_edge: 0.01}\n"
          "steps:\n"
          "  - pleat: {through: [[0.05, 0], [0.05, 0.05]], move: [0.1, 0.02],\n"
          "            back: [[0.06, 0], [0.06, 0.05]]}\n"
          "  - settle: {timeout: 2}\n");
  EXPECT_LT(worstError(paper), 0.5);
  EXPECT_TRUE(crossings(paper.sheet(), paper.positions()).empty());
  const Vector3 start = pointInSpace(Vector2(0, 0), paper.sheet(), paper.positions());
  const Vector3 end = pointInSpace(Vector2(0.1, 0), paper.sheet(), paper.positions());
  EXPECT_NEAR((end - start).norm(), 0.1 - 2 * 0.01, 1e-4);
}

TEST(RecipeSteps, AManoeuvreWithoutAWordIsRejectedWithItsLine) {
  const std::pair<const char*, const char*> rejected[] = {
      {"petal: {}", "petal needs flap"},
      {"pleat: {through: [[0, 0], [1, 1]], move: [1, 0]}", "pleat needs back"},
      {"pleat: {back: [[0, 0], [1, 1]]}", "pleat takes one of bring"},
      {"pleat: {bring: [0, 0], to: [1, 1], back: [[0, 0]]}", "back"},
      {"pleat: {bring: [0, 0], to: [1, 1], back: [[0, 0], [1, 0]], flap: [0, 0], layers: {top: 1}}",
       "one of layers and flap"},
      {"rabbit_ear: {flap: [0, 0]}", "rabbit_ear needs base"},
      {"rabbit_ear: {base: [[0, 0], [1, 1]]}", "rabbit_ear needs flap"},
      {"rabbit_ear: {flap: [0, 0], base: [[0, 0], [1, 1]], way: up}", "way is 'up'"},
      {"rabbit_ear: {flap: [0, 0], base: [[0, 0], [1, 1]], angle_deg: 180}", "angle_deg 180"},
      {"squash: {flap: [0, 0], bring: [1, 0]}", "squash needs to"},
      {"reverse: {flap: [0, 0]}", "reverse takes one of bring"}};
  for (const auto& [step, words] : rejected) {
    try {
      readRecipe({"test", "", std::string("steps:\n  - ") + step + "\n"});
      ADD_FAILURE() << step;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
    }
  }
}

TEST(Precreases, AreTheLinesOfAllFoldsOfTheCrane) {
  const Recipe recipe = loadRecipe("../recipes/crane.yaml");
  const std::vector<FoldEdit> lines = precreasesOf(recipe);
  for (const FoldEdit& fold : lines) EXPECT_EQ(fold.angle, 0);
  const double side = recipe.sheet.width;
  // Of the neck, as folding in coordinates gives them (H and the four layers of its W0 half).
  const double expected[4][4] = {{0.646446610, 0.353553390, 0.592253422, 0.272447553},
                                 {0.592253422, 0.272447553, 0.538060234, 0.191341716},
                                 {0.538060234, 0.191341716, 0.519030117, 0.095670858},
                                 {0.519030117, 0.095670858, 0.5, 0}};
  for (const auto& e : expected) {
    const Vector2 a(e[0] * side, e[1] * side), b(e[2] * side, e[3] * side);
    const bool there = std::any_of(lines.begin(), lines.end(), [&](const FoldEdit& fold) {
      const Segment made = std::get<Segment>(fold.where);
      return std::min((made[0] - a).norm() + (made[1] - b).norm(),
                      (made[1] - a).norm() + (made[0] - b).norm()) < 1e-7;
    });
    EXPECT_TRUE(there) << e[0] << ", " << e[1];
  }
}

TEST(Precreases, RefuseToCountLayers) {
  try {
    precreasesOf(
        readRecipe({"test", "",
                    "sheet: {size: [0.1, 0.1], max_edge: 0.05}\nprecrease: true\nsteps:\n"
                    "  - fold_through: {bring: [0, 0], to: [0.1, 0.1]}\n"
                    "  - fold_through: {bring: [0.1, 0], to: [0, 0.1], layers: {top: 1}}\n"}));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "precrease, step 2: which layers are at the top is not known before the paper is "
                 "folded: use flap");
  }
}

}  // namespace
}  // namespace shell_origami
