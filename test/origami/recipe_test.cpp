#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/snapshot.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace shell_origami {
namespace {

constexpr const char* kGood = R"(
sheet: {size: [0.1, 0.12], max_edge: 0.02}
material: {thickness: 2.0e-4}
gravity: [0, 0, -1]
steps:
  - pin: {points: [[0, 0], [0.1, 0]]}
  - fold: [{line: [[0, 0.06], [0.1, 0.06]], angle_deg: 90, name: middle}]
    duration: 0.5
  - settle: {timeout: 0.2}
  - unpin: all
)";

class RecipeTest : public testing::Test {
 protected:
  std::string write(const std::string& text) {
    const std::string path = testing::TempDir() + "/recipe_test.yaml";
    std::ofstream(path) << text;
    return path;
  }
  std::string refusal(const std::string& text, const Overrides& overrides = {}) {
    try {
      loadRecipe(write(text), {}, {}, overrides);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(RecipeTest, SaysWhatItReads) {
  const Recipe recipe = loadRecipe(write(kGood));
  EXPECT_EQ(recipe.name, "recipe_test");
  EXPECT_DOUBLE_EQ(recipe.sheet.height, 0.12);
  EXPECT_DOUBLE_EQ(recipe.config.material.thickness, 2e-4);
  EXPECT_DOUBLE_EQ(recipe.config.gravity.z(), -1);
  ASSERT_EQ(recipe.steps.size(), 4u);
  const FoldStep& fold = std::get<FoldStep>(recipe.steps[1]);
  EXPECT_DOUBLE_EQ(fold.duration, 0.5);
  EXPECT_NEAR(fold.folds[0].angle, M_PI / 2, 1e-15);
  EXPECT_EQ(fold.folds[0].name, "middle");
}

TEST_F(RecipeTest, APatternIsFoldedToItsOwnAngles) {
  const std::string pattern = testing::TempDir() + "/it's a pattern.cp";
  std::ofstream(pattern) << "1 0 0 4 0\n1 4 0 4 2\n1 4 2 0 2\n1 0 2 0 0\n2 0 0 4 2\n";
  SheetSource sheet;
  sheet.width = 0.2;
  const Recipe recipe = loadRecipe(pattern, {}, sheet, {{"material/thickness", "2e-4"}});
  EXPECT_EQ(recipe.name, "it's a pattern");
  EXPECT_DOUBLE_EQ(recipe.config.material.thickness, 2e-4);
  RecipeRunner runner(recipe);
  Simulation simulation = makeSimulation(recipe.sheet, recipe.config);
  EXPECT_NEAR(simulation.sheet().size(), 0.2, 1e-12);
  ASSERT_TRUE(runner.update(simulation));
  ASSERT_EQ(simulation.creases().size(), 1u);
  EXPECT_LT(simulation.creases()[0].target_angle, -3);
}

TEST_F(RecipeTest, ADrawnPatternHasTheWidthThatIsGiven) {
  const std::string drawing = testing::TempDir() + "/recipe_test.cp";
  std::ofstream(drawing) << "1 0 0 4 0\n1 4 0 4 2\n1 4 2 0 2\n1 0 2 0 0\n2 0 0 4 2\n3 0 2 4 0\n";
  const std::string pattern = "sheet: {pattern: recipe_test.cp, max_edge: 0.05, ";
  const Recipe recipe = loadRecipe(write(pattern + "width: 0.1}"));
  std::vector<std::string> notes;
  const Simulation simulation = makeSimulation(recipe.sheet, recipe.config, &notes);
  EXPECT_NEAR(simulation.sheet().size(), 0.1, 1e-15);
  EXPECT_NEAR(simulation.sheet().area(), 0.1 * 0.05, 1e-15);
  EXPECT_EQ(notes.size(), 1u);
  EXPECT_NE(
      refusal(pattern + "width: 0.1, scale: 1}").find("line 1: sheet has a width and a scale"),
      std::string::npos);
  EXPECT_NE(
      refusal("sheet: {size: [1, 1], width: 0.1}").find("line 1: sheet/width is for a pattern"),
      std::string::npos);
  EXPECT_NE(refusal(pattern + "width: wide}").find("sheet/width must be a finite number"),
            std::string::npos);
  const Recipe negative = loadRecipe(write(pattern + "width: -1}"));
  EXPECT_THROW(makeSimulation(negative.sheet, negative.config), std::invalid_argument);
  std::filesystem::remove(drawing);
}

TEST_F(RecipeTest, FormSaysWhetherAPatternIsLoadedFolded) {
  const std::string pattern = testing::TempDir() + "/recipe_test.fold";
  std::ofstream(pattern) << R"({"frame_classes": ["creasePattern"], "frame_unit": "m",
    "vertices_coords": [[0, 0], [0.1, 0], [0.2, 0], [0.2, 0.1], [0.1, 0.1], [0, 0.1]],
    "faces_vertices": [[0, 1, 4, 5], [1, 2, 3, 4]],
    "edges_vertices": [[1, 4]], "edges_assignment": ["V"],
    "file_frames": [{"frame_inherit": true, "frame_classes": ["foldedForm"], "vertices_coords":
      [[0, 0, 0], [0.1, 0, 0], [0.1, 0, 0.1], [0.1, 0.1, 0.1], [0.1, 0.1, 0], [0, 0.1, 0]]}]})";
  const auto height = [this](const std::string& form) {
    const Recipe recipe = loadRecipe(write("sheet: {pattern: recipe_test.fold" + form + "}"));
    return makeSimulation(recipe.sheet, recipe.config).positions().row(2).maxCoeff();
  };
  EXPECT_NEAR(height(""), 0.1, 1e-12);
  EXPECT_NEAR(height(", form: folded"), 0.1, 1e-12);
  EXPECT_EQ(height(", form: flat"), 0);
  std::filesystem::remove(pattern);
}

TEST_F(RecipeTest, LaysTheSheetWhereThePoseSays) {
  const Recipe recipe =
      loadRecipe(write("sheet: {size: [0.1, 0.1], max_edge: 0.05, pose: {position: [1, 2, 3], "
                       "rpy_deg: [90, 0, 90]}}"));
  const Simulation simulation = makeSimulation(recipe.sheet, recipe.config);
  // NaturalCurvature 90: the sheet's y points up; then yaw 90: its x points along the world's y.
  for (int v = 0; v < simulation.sheet().vertexCount(); ++v) {
    const Vector2 flat = simulation.sheet().flatPositions()[v];
    EXPECT_LT((simulation.positions().col(v) - Vector3(1, 2 + flat.x(), 3 + flat.y())).norm(),
              1e-14);
  }
  EXPECT_NEAR(simulation.maxStrain(), 0, 1e-13);
}

constexpr const char* kThrough = R"(
sheet: {size: [0.1, 0.1], max_edge: 0.05}
names: {tip: {corner: [0, 0]}, top: [0.1, 0.1], middle: {on: [tip, top], at: 0.5}}
steps:
  - fold_through: {bring: tip, to: middle}
  - turn_over: {}
  - fold_through: {edge: [tip, [0.1, 0]], to_edge: [[0, 0.1], top], layers: {top: 2}, way: behind}
    duration: 3
  - fold_through: {across: [tip, top], at: middle, move: top, angle_deg: 90}
  - fold_through: {through: [tip, {meet: [tip, top, [0, 0.1], [0.1, 0]]}], move: top, flap: top}
)";

TEST_F(RecipeTest, ReadsFoldsThroughLayers) {
  const Recipe recipe = loadRecipe(write(kThrough));
  ASSERT_EQ(recipe.steps.size(), 5u);
  const Sheet sheet = makeSimulation(recipe.sheet, recipe.config).sheet();
  const auto& first = std::get<FoldThroughStep>(recipe.steps[0]);
  EXPECT_NEAR(first.fold->angle, 178 * M_PI / 180, 1e-15);
  EXPECT_EQ(first.fold->layers, FoldLayers::kAll);
  const auto& bring = std::get<BringPoint>(first.fold->axiom);
  EXPECT_EQ(flatPoint(bring.from, sheet), Vector2(0, 0));
  EXPECT_LT((flatPoint(bring.to, sheet) - Vector2(0.05, 0.05)).norm(), 1e-15);
  EXPECT_TRUE(std::holds_alternative<TurnOverStep>(recipe.steps[1]));
  const auto& edges = std::get<FoldThroughStep>(recipe.steps[2]);
  EXPECT_TRUE(std::holds_alternative<BringEdge>(edges.fold->axiom));
  EXPECT_EQ(edges.fold->layers, FoldLayers::kTop);
  EXPECT_EQ(edges.fold->count, 2);
  EXPECT_TRUE(edges.fold->behind);
  EXPECT_EQ(edges.duration, 3);
  const auto& along = std::get<FoldThroughStep>(recipe.steps[4]);
  EXPECT_EQ(along.fold->layers, FoldLayers::kFlap);
  const Landmark meeting = std::get<FoldAlong>(along.fold->axiom).points[1];
  EXPECT_LT((flatPoint(meeting, sheet) - Vector2(0.05, 0.05)).norm(), 1e-15);
}

TEST_F(RecipeTest, RefusesFoldsThroughLayersThatMakeNoSense) {
  const std::pair<const char*, const char*> cases[] = {
      {"{bring: nose, to: [0, 0]}", "'nose' is none of the recipe's names"},
      {"{bring: [0, 0]}", "bring needs to"},
      {"{bring: [0, 0], to: [0.1, 0], move: [0, 0]}", "move belongs to across and through"},
      {"{bring: [0, 0], to: [0.1, 0], through: [[0, 0], [0, 1]], move: [0, 0]}", "not 2"},
      {"{layers: all}", "not 0"},
      {"{edge: [[0, 0]], to_edge: [[0, 0], [0, 1]]}", "edge takes 2 points"},
      {"{bring: [0, 0, 1], to: [0.1, 0]}", "2 numbers"},
      {"{bring: [0, .nan], to: [0.1, 0]}", "nan"},
      {"{bring: {corner: [0, 0], meet: []}, to: [0.1, 0]}", "meet takes 4 points"},
      {"{bring: {at: 0.5}, to: [0.1, 0]}", "one of corner, on and meet"},
      {"{bring: {on: [[0, 0], [0.1, 0]], at: 2}, to: [0.1, 0]}", "at 2 is not from 0 to 1"},
      {"{bring: [0, 0], to: [0.1, 0], layers: {top: 0}}", "top 0 is not at least 1"},
      {"{bring: [0, 0], to: [0.1, 0], layers: some}", "layers takes all, or top"},
      {"{bring: [0, 0], to: [0.1, 0], layers: {top: 1}, flap: [0, 0]}", "not both"},
      {"{bring: [0, 0], to: [0.1, 0], way: up}", "way is 'up'"},
      {"{bring: [0, 0], to: [0.1, 0], angle_deg: -10}", "angle_deg -10 is not inside (0, 180)"},
      {"{fold: [0, 0]}", "fold"},
      {"7", "map"},
  };
  for (const auto& [fold, words] : cases) {
    const std::string said = refusal("steps:\n  - fold_through: " + std::string(fold));
    EXPECT_NE(said.find(words), std::string::npos) << fold << ": " << said;
    EXPECT_NE(said.find("line 2"), std::string::npos) << said;
  }
  EXPECT_NE(refusal("names: [1]\nsteps: []").find("names must be a map"), std::string::npos);
  EXPECT_NE(refusal("names: {a: b, b: [0, 0]}\nsteps: []").find("'b' is none"), std::string::npos);
}

TEST_F(RecipeTest, OverridesOneValue) {
  const Recipe recipe =
      loadRecipe(write(kGood), {}, {}, {{"material/thickness", "3e-4"}, {"solver/gamma", "0.9"}});
  EXPECT_DOUBLE_EQ(recipe.config.material.thickness, 3e-4);
  EXPECT_DOUBLE_EQ(recipe.config.solver.gamma, 0.9);
  EXPECT_NE(refusal(kGood, {{"material/thicknes", "1"}}).find("thicknes"), std::string::npos);
  EXPECT_NE(refusal(kGood, {{"material/thickness", "thin"}}).find("thin"), std::string::npos);
  EXPECT_NE(refusal(kGood, {{"material/thickness/x", "1"}}).find("material/thickness/x"),
            std::string::npos);
}

TEST_F(RecipeTest, APresetIsOverriddenByWhatElseIsStatedWhereverItStands) {
  const Material copy_paper = materialOf(PaperKind::kCopyPaper);
  const Recipe recipe =
      loadRecipe(write("material: {thickness: 2.0e-4, preset: copy_paper}\nsteps: []"), {}, {}, {});
  EXPECT_DOUBLE_EQ(recipe.config.material.thickness, 2e-4);
  EXPECT_DOUBLE_EQ(recipe.config.material.yield_curvature, copy_paper.yield_curvature);
  const Recipe set = loadRecipe(write(kGood), {}, {}, {{"material/preset", "copy_paper"}});
  EXPECT_DOUBLE_EQ(set.config.material.hardening, copy_paper.hardening);
  EXPECT_EQ(refusal("material: {preset: cardboard}\nsteps: []"),
            refusal("material: {preset: cardboard, thickness: 1.0e-4}\nsteps: []"));
  EXPECT_NE(refusal("material: {preset: cardboard}\nsteps: []")
                .find("material/preset must be copy_paper, not 'cardboard'"),
            std::string::npos);
}

// B / (2 rho t g) of copy paper is the cube of 48 mm.
TEST(MaterialOf, CopyPaperBendsAsMeasured) {
  const Material paper = materialOf(PaperKind::kCopyPaper);
  EXPECT_NEAR(std::cbrt(paper.bendingStiffness() / (2 * paper.arealDensity() * 9.81)), 0.048, 5e-4);
  EXPECT_DOUBLE_EQ(paper.arealDensity(), 0.08);
}

TEST_F(RecipeTest, ARolledSheetCurlsToItsCurvatureAtOnce) {
  // A cylinder of 20 /m: the ends of 0.1 m stand 2 sin(1) / 20 apart.
  Recipe recipe =
      loadRecipe(write("sheet: {size: [0.1, 0.03], max_edge: 0.008, curvature: {value: "
                       "20, axis_deg: 90}}\nsteps:\n  - settle: {quasi_static: true}"));
  EXPECT_TRUE(std::get<SettleStep>(recipe.steps[0]).quasi_static);
  RecipeRunner runner(recipe);
  Simulation simulation = makeSimulation(recipe.sheet, recipe.config);
  while (runner.update(simulation)) ASSERT_TRUE(simulation.step().converged);
  EXPECT_LE(simulation.time(), 0.1);
  const int left = simulation.sheet().nearestVertex({0, 0.015}),
            right = simulation.sheet().nearestVertex({0.1, 0.015});
  const double apart =
      (simulation.positions().col(left) - simulation.positions().col(right)).norm();
  EXPECT_NEAR(apart / (2 * std::sin(1.0) / 20), 1, 0.01);
}

TEST_F(RecipeTest, RefusesWithTheLineAndTheValue) {
  const auto expect = [this](const std::string& text, const std::string& part) {
    const std::string sentence = refusal(text);
    EXPECT_NE(sentence.find(part), std::string::npos) << text << "\n  said: " << sentence;
  };
  expect("sheet: {sise: [1, 1]}", "sise");
  expect("steps:\n  - fold: [{line: [[0, 0], [1, 1]], angle_deg: 180}]", "line 2: angle_deg 180");
  expect("steps:\n  - fold: [{line: [[0, 0], [1, 1]]}]", "angle_deg");
  expect("steps:\n  - fold: [{angle_deg: 10}]", "line or a crease");
  expect("steps:\n  - fold: [{line: [[0, 0]], angle_deg: 10}]", "two ends");
  expect("steps:\n  - fold: [{line: [[0, x], [1, 1]], angle_deg: 10}]", "'x'");
  expect("steps:\n  - fold: [{line: [[0, .nan], [1, 1]], angle_deg: 10}]", "nan");
  expect("steps:\n  - wave: hello", "wave");
  expect("steps:\n  - settle: {timeout: -1}", "-1");
  expect("steps:\n  - {pin: {points: [[0, 0]]}, unpin: all}", "one thing");
  expect("steps:\n  - unpin: some", "all");
  expect("steps:\n  - settle: {quasi_static: maybe}", "quasi_static must be true or false");
  expect("steps: 3", "list");
  expect("material: {membrane: rubber}", "discrete_shells or st_venant_kirchhoff, not 'rubber'");
  expect("material: {crease_height_term: 2}", "true or false");
  expect("material: {hardening: -2}", "-2");
  expect("solver: {integrator: euler}", "'euler'");
  expect("sheet: {curvature: {value: .nan}}", "nan");
  expect("sheet: {curvature: 5}", "map");
  expect("material: {thickness: -1}", "-1");
  expect("solver: {max_iterations: 2.5}", "2.5");
  expect("solver: {threads: -1}", "solver/threads is -1, but must be from 0 to 1024");
  expect("gravity: [0, 0]", "3 numbers");
  expect("sheet: [", "line");
  expect("just words", "map");
  EXPECT_THROW(loadRecipe("/nowhere/at_all.yaml"), std::invalid_argument);
}

TEST_F(RecipeTest, TextThatNestsWithoutEndIsRefused) {
  std::string dashes;
  for (int i = 0; i < 1000000; ++i) dashes += "- ";
  for (const std::string& text : {std::string(1000000, '['), std::string(1000000, '{'), dashes}) {
    try {
      readRecipe({"yaml", "", "steps:\n" + text});
      FAIL() << text.substr(0, 2);
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("deeper"), std::string::npos) << error.what();
    }
  }
}

TEST_F(RecipeTest, IsReadFromTextToo) {
  const Recipe recipe = readRecipe({"yaml", "", "steps:\n  - settle: {timeout: 3}"});
  ASSERT_EQ(recipe.steps.size(), 1u);
  EXPECT_TRUE(recipe.states("steps"));
  EXPECT_FALSE(recipe.states("sheet"));
  EXPECT_TRUE(readRecipe({"yaml", "", kGood}).states("sheet"));
  try {
    readRecipe({"yaml", "", "steps:\n  - wave: hello"});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).rfind("yaml, line 2: ", 0), 0u) << error.what();
  }
}

TEST_F(RecipeTest, RefusesShortTextThatUnfoldsToMillionsOfFolds) {
  std::string folds, steps;
  for (int i = 0; i < 1000; ++i) folds += ", *f", steps += ", *s";
  EXPECT_NE(
      refusal("steps: [&s {fold: [&f {crease: all, angle_deg: 1}" + folds + "]}" + steps + "]")
          .find("1000000 values"),
      std::string::npos);
}

TEST_F(RecipeTest, RunnerCarriesItOut) {
  RecipeRunner runner(loadRecipe(write(kGood)));
  Simulation simulation = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  double last_progress = 0;
  bool was_pinned = false;
  while (runner.update(simulation)) {
    ASSERT_TRUE(simulation.step().converged);
    ASSERT_LT(simulation.time(), 2);
    const double progress = runner.progress(simulation);
    EXPECT_GE(progress, last_progress);
    last_progress = progress;
    was_pinned |= simulation.pinned().size() == 2;
  }
  EXPECT_TRUE(was_pinned);
  EXPECT_TRUE(simulation.pinned().empty());
  EXPECT_TRUE(runner.finished());
  EXPECT_DOUBLE_EQ(runner.progress(simulation), 1);
  ASSERT_EQ(simulation.creases().size(), 1u);
  EXPECT_EQ(simulation.creases()[0].name, "middle");
  EXPECT_NEAR(simulation.creases()[0].rest_angle, M_PI / 2, 1e-12);
}

TEST_F(RecipeTest, RejectsAKeyThatOccursTwice) {
  const std::string sentence = refusal("sheet: {size: [0.1, 0.1]}\n\nsheet: {max_edge: 0.02}\n");
  EXPECT_NE(sentence.find("line 3: the key 'sheet' occurs twice"), std::string::npos) << sentence;
  EXPECT_NE(refusal("solver: {beta: 0.3, gamma: 0.6, beta: 0.4}").find("'beta' occurs twice"),
            std::string::npos);
  // In two maps, or as a value, a word may stand twice.
  EXPECT_EQ(refusal("steps:\n  - unpin: all\n  - unpin: all\n"), "");
  EXPECT_EQ(refusal("steps: [{fold: [{line: [[0, 0], [0.1, 0.1]], angle_deg: 1, name: name}]}]"),
            "");
}

TEST_F(RecipeTest, RejectsTheNameOfAGroupForACrease) {
  for (const std::string& name :
       {std::string("all"), std::string("mountains"), std::string("valleys"), std::string("''"),
        std::string(101, 'x')}) {
    const std::string sentence = refusal(
        "\nsteps: [{fold: [{line: [[0, 0], [0.1, 0.1]], angle_deg: 1, name: " + name + "}]}]");
    EXPECT_NE(sentence.find("line 2"), std::string::npos) << name << ": " << sentence;
  }
}

TEST_F(RecipeTest, NotesASettleStepThatTimesOut) {
  constexpr const char* kSteps = R"(
sheet: {size: [0.1, 0.1], max_edge: 0.05}
steps:
  - fold: [{line: [[0, 0.05], [0.1, 0.05]], angle_deg: 90}]
    duration: 0
  - settle: {timeout: 0.05}
  - settle: {timeout: 20}
)";
  RecipeRunner runner(loadRecipe(write(kSteps)));
  Simulation simulation = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  std::vector<std::string> warnings;
  while (runner.update(simulation)) {
    ASSERT_TRUE(simulation.step().converged);
    for (const std::string& warning : runner.takeWarnings()) warnings.push_back(warning);
  }
  EXPECT_EQ(runner.place().timeouts, std::vector<int>{1});
  EXPECT_EQ(warnings, std::vector<std::string>{
                          "step 2: the paper had not settled after 0.05 s, its timeout"});
}

TEST_F(RecipeTest, ReadAgainWithItsDefaultsIsTheSame) {
  SimulationConfig defaults;
  defaults.fold_duration = 3;
  const Recipe recipe = readRecipe(
      {"r.yaml", "", "steps: [{fold: [{line: [[0, 0], [0.1, 0.1]], angle_deg: 1}]}]"}, defaults);
  const Recipe again = readRecipe(recipe.source, configFrom(toJson(recipe.defaults)));
  EXPECT_EQ(std::get<FoldStep>(recipe.steps[0]).duration, 3);
  EXPECT_EQ(std::get<FoldStep>(again.steps[0]).duration, 3);
}

TEST_F(RecipeTest, PassesOverAFoldedFormAndExpandsTheHomeFolder) {
  const std::string patterns = std::filesystem::absolute("data/patterns").string();
  setenv("HOME", patterns.c_str(), 1);
  const Recipe recipe =
      loadRecipe(write("sheet: {pattern: \"~/01_diagonal-cp.fold\", scale: 0.1, form: flat}"));
  EXPECT_EQ(recipe.sheet.form, FoldForm::kFlat);
  EXPECT_EQ(recipe.sheet.pattern, patterns + "/01_diagonal-cp.fold");
  EXPECT_EQ(makeSimulation(recipe.sheet, recipe.config).creases().size(), 1u);
  EXPECT_NE(refusal("sheet: {form: crumpled}").find("must be flat or folded"), std::string::npos);
}

}  // namespace
}  // namespace shell_origami
