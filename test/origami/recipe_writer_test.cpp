/// What was done to a paper, written as a recipe: its text, and that it folds the same paper again.
#include <shell_origami/origami/recipe_writer.h>
#include <shell_origami/origami/yaml_text.h>
#include "test/origami/squares.h"

#include <cstdlib>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

constexpr const char* kEverything =
    R"(sheet: {size: [0.1, 0.12], max_edge: 0.03, pose: {position: [0, 0, 0.2], rpy_deg: [0, 90, 12.5]}, curvature: {value: 3, axis_deg: 45}}
material: {thickness: 0.0002, membrane: discrete_shells}
solver: {time_step: 0.01}
contact: {enabled: false}
compliance: {where: sheet}
gravity: [0, 0, -1]
fold_duration: 0.5
names:
  tip: {corner: [0, 0]}
  top: [0.1, 0.12]
  a: {on: [tip, top], at: 0.3}
  "odd \"name\"": {meet: [tip, a, [0, 0.12], {corner: [0.1, 0]}]}
steps:
  - pin: {points: [[0, 0], [0.1, 0]]}
  - wait: 0.12
  - pin: {region: [[0, 0], [0.02, 0], [0, 0.02]]}
  - pin: {vertices: [0, 3]}
  - unpin: {vertices: [3]}
  - unpin: all
  - fold: [{line: [[0, 0.06], [0.1, 0.06]], angle_deg: 90, stiffness: 0.1, name: middle},
           {crease: middle, part: 0.5},
           {crease: "a crease", angle_deg: -12.25}]
    lasts: 0.25
  - fold: [{line: [[0, 0], [0.1, 0.12]], angle_deg: 0.001}]
    duration: 2
  - settle: {timeout: 3}
  - settle: {quasi_static: true}
    lasts: 0
  - fold_through: {bring: tip, to: [0.1, 0.1]}
  - fold_through: {edge: [tip, top], to_edge: [a, [0, 0.1]], layers: {top: 2}, way: behind}
    duration: 0
  - fold_through: {across: [tip, top], at: a, move: top, flap: "odd \"name\"", angle_deg: 33.3}
  - fold_through: {through: [tip, {on: [a, top], at: 0.25}], move: a}
  - fold: [{line: [tip, top], angle_deg: 178}]
  - petal: {flap: tip}
  - pleat: {through: [a, top], move: tip, back: [top, tip], layers: {top: 2}, way: behind}
  - rabbit_ear: {flap: tip, base: [a, top], way: behind}
  - squash: {flap: a, bring: tip, to: [top, a]}
    duration: 1
  - reverse: {flap: tip, through: [a, top], move: tip, inside: false, angle_deg: 170}
  - unfold: {step: last}
  - loosen: {creases: [middle, [tip, top]], stiffness: 0.01}
  - turn_over: {}
  - look_from: [0, 0.5, -1]
  - add_vertex: {edge: [0, 4], fraction: 0.3}
  - add_obstacle: [{id: table, plane: {}, position: [0, 0, -1]}, {id: jaw, box: [0.1, 0.2, 0.3], position: [1, 2, 3], orientation: [0.6, 0, 0, 0.8], friction: 0.2}]
  - add_obstacle: [{id: ball, sphere: 0.1, position: [2, 0, 0]}, {id: rod, cylinder: {radius: 0.01, length: 0.1}, position: [3, 0, 0]}]
  - obstacle: {id: jaw, move: {position: [1, 2, 4]}}
    duration: 2
  - remove_obstacle: [jaw]
  - remove_obstacle: all
  - grasp: {id: hand, vertices: [0, 3], stiffness: 500, max_force: 0.5, reach: 0.02}
  - release: [hand]
  - release: all
  - stop: {}
  - configure: {gravity: [0, 0, -9.81], air_damping: 2, fold_duration: 0.25}
)";

PaperOrigin originOf(const Recipe& recipe) { return {recipe.sheet, recipe.config, recipe.names}; }

std::vector<WrittenStep> stepsOf(const Recipe& recipe) {
  std::vector<WrittenStep> steps;
  for (const RecipeStep& step : recipe.steps) steps.push_back({step});
  for (const auto& [step, seconds] : recipe.lasts) steps[step].lasts = seconds;
  return steps;
}

TEST(RecipeWriter, WritesWhatItReads) {
  const Recipe recipe = readRecipe({"yaml", "", kEverything});
  const std::string text = recipeText(originOf(recipe), stepsOf(recipe));
  // Names are in the order of the alphabet, after those that they use.
  const Recipe again = readRecipe({"yaml", "", text});
  EXPECT_EQ(recipeText(originOf(again), stepsOf(again)), text);
  const auto lines = [](const std::string& whole) {
    std::multiset<std::string> found;
    std::istringstream stream(whole);
    for (std::string line; std::getline(stream, line);) found.insert(line);
    return found;
  };
  EXPECT_EQ(lines(text), lines(kEverything)) << text;
}

TEST(RecipeWriter, AnEmptyRecipeIsThatOfASheet) {
  EXPECT_EQ(recipeText({}, {}), "sheet: {size: [0.15, 0.15], max_edge: 0.01}\nsteps: []\n");
}

TEST(RecipeWriter, AnglesAreExact) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angles(-M_PI, M_PI);
  for (int i = 0; i < 10000; ++i) {
    const double angle = angles(random);
    const double read = std::strtod(degrees(angle).c_str(), nullptr) * kDegree;
    // The last bit of a number near pi.
    ASSERT_NEAR(read, angle, 4.5e-16) << degrees(angle);
  }
  EXPECT_EQ(degrees(M_PI / 2), "90");
  EXPECT_EQ(degrees(-0.5 * (M_PI / 180)), "-0.5");
}

TEST(RecipeWriter, WordsAreReadBack) {
  for (const std::string text : {"plain", "null", "~", "two words", "\"", "\\", "a: b", "#", "",
                                 "\x01\x1f\x7f\n\t", "折り", "- x", "{", "12"}) {
    const Recipe recipe =
        readRecipe({"yaml", "", "steps: [fold: [{crease: " + word(text) + ", angle_deg: 1}]]"});
    const auto& where = std::get<FoldStep>(recipe.steps[0]).folds[0].where;
    EXPECT_EQ(std::get<CreaseName>(where).name, text);
  }
}

/// A name that was given to another place since, and places that would need each other's names.
TEST(RecipeWriter, NamesOfOtherPlacesAreNotUsed) {
  PaperOrigin origin;
  const Landmark old_tip{Vector2(0, 0), "tip"};
  origin.names["center"] = {PartOfWay{{old_tip, {Vector2(0.1, 0.1)}}, 0.5}};
  origin.names["tip"] = {PartOfWay{{{origin.names["center"].place, "center"}, old_tip}, 0.5}};
  FoldThrough fold;
  fold.axiom = BringPoint{old_tip, {origin.names["center"].place, "center"}};
  const FoldThroughStep step{std::make_shared<FoldThrough>(fold)};
  const std::string text = recipeText(origin, {{step}});
  EXPECT_NE(text.find("bring: [0, 0], to: center"), std::string::npos) << text;
  const Recipe again = readRecipe({"yaml", "", text});
  const Sheet sheet = makeSimulation(again.sheet, again.config).sheet();
  EXPECT_LT((flatPoint(again.names.at("center"), sheet) - Vector2(0.05, 0.05)).norm(), 1e-15);
  EXPECT_LT((flatPoint(again.names.at("tip"), sheet) - Vector2(0.025, 0.025)).norm(), 1e-15);
}

/// A paper whose edits are noted, as a session does.
class Noted {
 public:
  explicit Noted(const PaperOrigin& origin = coarse())
      : simulation(makeSimulation(origin.sheet, origin.config)), journal(origin) {}

  static PaperOrigin coarse() {
    PaperOrigin origin;
    origin.sheet.max_edge = 0.03;
    origin.config.material.crease_stiffness = 0.02;
    return origin;
  }

  void apply(const Edit& edit) {
    const LiveConfig live = liveConfigOf(simulation.config());
    journal.add(edit, simulation.apply(edit), live);
  }

  void step(int count) {
    for (int i = 0; i < count; ++i) {
      const bool moves = !simulation.resting();
      ASSERT_TRUE(simulation.step().converged);
      if (moves) journal.moved(simulation.time());
    }
  }

  /// Folds by a recipe until its end, or for so many steps.
  void run(const std::string& text, int most = std::numeric_limits<int>::max()) {
    RecipeRunner runner(readRecipe({"yaml", "", text}));
    const auto make = [this](const std::vector<Edit>& edits) {
      simulation.apply(edits);
      return true;
    };
    for (int i = 0; i < most && runner.update(simulation, make, &journal); ++i) step(1);
  }

  std::string recipe() const {
    return recipeText(journal.origin(), journal.written(simulation.folding()));
  }

  Simulation simulation;
  Journal journal;
};

/// Whether a recipe folds the same paper, after the same steps but for those at rest.
void expectSame(const Noted& noted) {
  const std::string text = noted.recipe();
  RecipeRunner runner(readRecipe({"yaml", "", text}));
  Simulation again = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  while (runner.update(again)) ASSERT_TRUE(again.step().converged);
  ASSERT_EQ(again.sheet().vertexCount(), noted.simulation.sheet().vertexCount()) << text;
  EXPECT_LT((again.positions() - noted.simulation.positions()).cwiseAbs().maxCoeff(), 1e-12)
      << text;
  EXPECT_EQ(again.pinned(), noted.simulation.pinned()) << text;
}

FoldEdit across(double x, double angle, double duration) {
  FoldEdit fold;
  fold.where = Segment{Vector2(x, 0), Vector2(x, kSide)};
  fold.angle = angle;
  fold.duration = duration;
  return fold;
}

TEST(Journal, FoldsThatBeginTogetherAreOneStep) {
  Noted noted;
  noted.step(3);
  noted.apply(across(0.05, 1.1, 0.3));
  noted.apply(across(0.1, -0.7, 0.3));
  noted.step(9);
  noted.apply(across(0.075, 0.2, 0.2));
  noted.step(30);
  const auto steps = noted.journal.written(false);
  ASSERT_EQ(steps.size(), 3u) << noted.recipe();  // flat paper moves for the length of one step
  EXPECT_TRUE(std::holds_alternative<WaitStep>(steps[0].step));
  EXPECT_EQ(std::get<FoldStep>(steps[1].step).folds.size(), 2u);
  EXPECT_NEAR(*steps[1].lasts, 0.15, 1e-12);
  EXPECT_NEAR(*steps[2].lasts, 0.5, 1e-12);
  expectSame(noted);
}

TEST(Journal, EveryKindOfEditIsMadeAgain) {
  Noted noted;
  noted.apply(PinEdit{std::vector<Vector2>{{0, 0}, {0, kSide}}});
  noted.apply(PinEdit{Ball{Vector3(0.15, 0, 0), 0.02}});
  // Written as one. Between steps each would round what it adds to the accelerations.
  noted.apply(ConfigureEdit{{Vector3(0, 0, -1), 2, 0.4}});
  noted.apply(ConfigureEdit{{Vector3(0, 0, -2), 2, 0.4}});
  noted.apply(across(0.05, 1.0, 0.3));
  noted.step(10);
  const auto [a, b] = noted.simulation.sheet().edges()[5].vertices;
  noted.apply(AddVertexEdit{{a, b}, 0.3});
  noted.step(5);
  noted.apply(StopEdit{});
  noted.apply(ConfigureEdit{{Vector3(0, 0, -2), 3, 0.4}});
  noted.step(7);
  noted.apply(UnpinEdit{std::vector<std::int64_t>{0}});
  noted.step(2);
  noted.apply(SettleEdit{});
  FoldEdit again;
  again.where = CreaseName{"fold_0"};
  again.angle = 0.3;
  noted.apply(again);
  noted.step(11);
  noted.apply(UnpinEdit{});
  noted.step(4);
  EXPECT_NE(noted.recipe().find("configure: {gravity: [0, 0, -2], air_damping: 2, "),
            std::string::npos);
  EXPECT_EQ(noted.recipe().find("gravity: [0, 0, -1]"), std::string::npos);
  expectSame(noted);
}

constexpr const char* kRecipe = R"(
sheet: {size: [0.15, 0.15], max_edge: 0.03}
material: {crease_stiffness: 0.02}
names: {tip: [0, 0]}
steps:
  - fold: [{line: [[0.05, 0], [0.05, 0.15]], angle_deg: 40}]
    duration: 0.3
  - settle: {timeout: 0.2}
  - turn_over: {}
  - fold_through: {bring: tip, to: [0.03, 0.03], angle_deg: 20}
    duration: 0.2
)";

TEST(Journal, TheStepsOfARecipeAreItsOwn) {
  const Recipe recipe = readRecipe({"yaml", "", kRecipe});
  Noted noted({recipe.sheet, recipe.config, recipe.names});
  noted.run(kRecipe);
  EXPECT_EQ(noted.recipe(), recipeText(originOf(recipe), stepsOf(recipe)));
  expectSame(noted);
  noted.step(8);
  noted.apply(across(0.1, 0.4, 0.2));
  noted.step(20);
  expectSame(noted);
}

TEST(Journal, WhatIsDoneWhileARecipeFoldsComesBetweenItsSteps) {
  const Recipe recipe = readRecipe({"yaml", "", kRecipe});
  Noted noted({recipe.sheet, recipe.config, recipe.names});
  RecipeRunner runner(recipe);
  const auto make = [&](const std::vector<Edit>& edits) {
    noted.simulation.apply(edits);
    return true;
  };
  for (int i = 0; runner.update(noted.simulation, make, &noted.journal); ++i) {
    if (i == 7) noted.apply(PinEdit{std::vector<std::int64_t>{0}});
    if (i == 22) noted.apply(UnpinEdit{});
    noted.step(1);
  }
  expectSame(noted);
}

TEST(Journal, TimeAtRestIsLeftOut) {
  Noted noted;
  noted.apply(across(0.05, 0.5, 0.2));
  noted.step(5000);
  ASSERT_TRUE(noted.simulation.resting());
  noted.apply(across(0.1, 0.5, 0.2));
  noted.step(30);
  const auto steps = noted.journal.written(false);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_LT(*steps[0].lasts, 60);
  expectSame(noted);
  // A recipe's step would not end of itself at the same step of time any more.
  noted.run("steps: [fold: [{line: [[0.075, 0], [0.075, 0.15]], angle_deg: 9}]]");
  EXPECT_NEAR(*noted.journal.written(false)[2].lasts, 1, 0.02);
  expectSame(noted);
}

TEST(Journal, AFoldUnderWayIsEnded) {
  Noted noted;
  noted.apply(across(0.05, 0.5, 0.2));
  noted.step(3);
  EXPECT_FALSE(noted.journal.written(true)[0].lasts.has_value());
  EXPECT_NEAR(*noted.journal.written(false)[0].lasts, 0.05, 1e-12);
}

TEST(Journal, IsKeptInAFile) {
  const Recipe recipe = readRecipe({"yaml", "", kRecipe});
  Noted noted({recipe.sheet, recipe.config, recipe.names});
  noted.run(kRecipe, 40);
  noted.apply(PinEdit{std::vector<std::int64_t>{0}, "hand", Pose{}});
  noted.step(3);
  Noted again({recipe.sheet, recipe.config, recipe.names});
  again.simulation = Simulation(noted.simulation.snapshot());
  again.journal = Journal(nlohmann::json::parse(noted.journal.toJson().dump()));
  EXPECT_EQ(again.recipe(), noted.recipe());
  EXPECT_EQ(again.journal.frames(), std::set<std::string>{"hand"});
  EXPECT_NE(noted.recipe().find("# frame hand"), std::string::npos);
}

TEST(Journal, ForgetsWhatIsUndone) {
  Noted noted;
  noted.apply(across(0.05, 0.5, 0.2));
  noted.step(10);
  const std::size_t steps = noted.journal.size();
  const Snapshot before = noted.simulation.snapshot();
  noted.apply(across(0.1, 0.5, 0.2));
  noted.step(10);
  noted.journal.keepFirst(steps);
  noted.simulation = Simulation(before);
  noted.step(4);
  expectSame(noted);
  EXPECT_NEAR(*noted.journal.written(false)[0].lasts, 14. / 60, 1e-12);
}

}  // namespace
}  // namespace shell_origami
