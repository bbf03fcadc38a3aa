/// Steps of recipes that let time pass, and those that say what services do.
#include <shell_origami/origami/recipe.h>
#include "test/origami/squares.h"

#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

const std::string kSheet = "sheet: {size: [0.1, 0.1], max_edge: 0.05}\n";

std::string refusal(const std::string& step) {
  try {
    readRecipe({"yaml", "", kSheet + "steps:\n  - " + step});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(RecipeSteps, ThatMakeNoSenseAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"wait: -1", "wait -1 s is negative"},
      {"wait: {seconds: 1}", "wait must be a finite number"},
      {"{wait: 1, lasts: -2}", "lasts -2 s is negative"},
      {"lasts: 1", "a step does one thing"},
      {"pin: {}", "pin takes one of region, points and vertices"},
      {"pin: {vertices: [0], points: [[0, 0]]}", "pin takes one of"},
      {"pin: {vertices: []}", "vertices must be a list of their numbers"},
      {"pin: {vertices: [0.5]}", "a vertex must be an integer"},
      {"unpin: some", "unpin takes all, region, points or vertices"},
      {"add_vertex: {edge: [0, 1]}", "add_vertex needs edge and fraction"},
      {"add_vertex: {edge: [0, 1, 2], fraction: 0.5}", "an edge has two vertices"},
      {"stop: {all: true}", "stop knows no 'all'"},
      {"configure: {thickness: 1e-3}", "configure knows no 'thickness'"},
      {"configure: {gravity: [0, 0]}", "gravity must be a list of 3 numbers"},
      {"add_obstacle: {sphere: 0.1}", "an obstacle needs an id"},
      {"add_obstacle: {id: o}", "takes one of plane, box, sphere, cylinder and mesh, not 0"},
      {"add_obstacle: {id: o, sphere: 0.1, box: [1, 1, 1]}", "mesh, not 2"},
      {"add_obstacle: {id: o, sphere: -1}", "radius is -1 m"},
      {"add_obstacle: {id: o, plane: {normal: [0, 0, 0]}}", "normal has no direction"},
      {"add_obstacle: {id: o, mesh: none.stl}", "none.stl"},
      {"add_obstacle: {id: o, mesh: a.png}", "a mesh is a .stl, .obj or .dae file"},
      {"add_obstacle: {id: o, sphere: 0.1, orientation: [0, 0, 0, 2]}", "has length 2"},
      {"add_obstacle: table", "obstacles must be a list"},
      {"obstacle: {id: o}", "obstacle needs id and move"},
      {"remove_obstacle: []", "remove_obstacle takes all, an id or several"},
      {"grasp: {id: hand}", "grasp takes one of region, points and vertices"},
      {"grasp: {vertices: [0]}", "a grasp needs an id"},
      {"release: {}", "release must be a word"},
      {"look_from: up", "look_from must be a list of 3 numbers"},
  };
  for (const auto& [step, words] : cases) {
    EXPECT_NE(refusal(step).find(words), std::string::npos) << step << ": " << refusal(step);
    EXPECT_NE(refusal(step).find("yaml, line 3"), std::string::npos) << refusal(step);
  }
}

/// Carries a recipe out; returns the paper at its end.
Simulation run(const std::string& steps) {
  RecipeRunner runner(readRecipe({"yaml", "", kSheet + "steps:\n" + steps}));
  Simulation simulation = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  while (runner.update(simulation)) simulation.step();
  return simulation;
}

constexpr const char* kFold =
    "  - fold: [{line: [[0.05, 0], [0.05, 0.1]], angle_deg: 30}]\n    duration: 0.4\n";

TEST(RecipeSteps, LastAsLongAsTheyState) {
  const double step = 1. / 60;
  EXPECT_NEAR(run("  - wait: 0.5\n").time(), 0.5, 1e-9);
  EXPECT_NEAR(run("  - wait: 0.51\n").time(), 31 * step, 1e-9);
  EXPECT_NEAR(run("  - wait: 0\n").time(), 0, 1e-9);
  const Simulation cut = run(kFold + std::string("    lasts: 0.21667\n"));
  EXPECT_NEAR(cut.time(), 13 * step, 1e-9);
  EXPECT_TRUE(cut.folding());
  EXPECT_NEAR(run(kFold + std::string("    lasts: 0.8\n")).time(), 0.8, 1e-9);
  EXPECT_NEAR(run("  - settle: {timeout: 9}\n    lasts: 0.1\n").time(), 0.1, 1e-9);
}

TEST(RecipeSteps, ProgressCountsHowLongTheyLast) {
  RecipeRunner runner(
      readRecipe({"yaml", "", kSheet + "steps:\n" + kFold + "    lasts: 1\n  - wait: 3\n"}));
  Simulation simulation = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  while (simulation.time() < 2) {
    ASSERT_TRUE(runner.update(simulation));
    simulation.step();
  }
  EXPECT_NEAR(runner.progress(simulation), 0.5, 0.01);
  EXPECT_EQ(runner.doing(), "wait");
}

TEST(RecipeSteps, StopEndsFoldsWhereTheyAre) {
  const Simulation stopped = run(kFold + std::string("    lasts: 0.2\n  - stop: {}\n"));
  EXPECT_FALSE(stopped.folding());
  EXPECT_LT(stopped.creases()[0].target_angle, 29 * kDegree);
  EXPECT_GT(stopped.creases()[0].target_angle, 1 * kDegree);
}

TEST(RecipeSteps, ConfigureChangesWhatItStates) {
  const SimulationConfig before = run("  - wait: 0\n").config();
  const SimulationConfig after = run("  - configure: {gravity: [0, 0, -3]}\n").config();
  EXPECT_EQ(after.gravity, Vector3(0, 0, -3));
  EXPECT_EQ(after.material.air_damping, before.material.air_damping);
  EXPECT_THROW(run("  - configure: {air_damping: -1}\n"), std::invalid_argument);
}

TEST(RecipeSteps, VerticesAreHeldAddedAndLetGo) {
  EXPECT_EQ(run("  - pin: {vertices: [2, 0]}\n").pinned(), (std::set<int>{0, 2}));
  EXPECT_EQ(run("  - pin: {vertices: [2, 0]}\n  - unpin: {vertices: [0]}\n").pinned(),
            std::set<int>{2});
  EXPECT_EQ(run("  - pin: {region: [[0, 0], [1, 0], [1, 1]]}\n  - unpin: {region: [[0, 0], [1, 0], "
                "[1, 1]]}\n"
                "  - pin: {vertices: [1]}\n  - unpin: all\n")
                .pinned(),
            std::set<int>{});
  const Simulation flat = run("  - wait: 0\n");
  const auto [a, b] = flat.sheet().edges()[0].vertices;
  const Simulation added = run("  - add_vertex: {edge: [" + std::to_string(a) + ", " +
                               std::to_string(b) + "], fraction: 0.25}\n");
  ASSERT_EQ(added.sheet().vertexCount(), flat.sheet().vertexCount() + 1);
  const auto& places = flat.sheet().flatPositions();
  EXPECT_LT((added.sheet().flatPositions().back() - 0.75 * places[a] - 0.25 * places[b]).norm(),
            1e-15);
}

TEST(RecipeSteps, LookFromPicksTheSide) {
  const std::string fold = "  - fold_through: {bring: [0, 0], to: [0.1, 0.1], angle_deg: 20}\n";
  EXPECT_GT(run(fold).creases()[0].target_angle, 0);
  EXPECT_LT(run("  - look_from: [0.1, 0, -1]\n" + fold).creases()[0].target_angle, 0);
  EXPECT_GT(run("  - turn_over: {}\n  - look_from: [0, 0, 1]\n" + fold).creases()[0].target_angle,
            0);
  EXPECT_THROW(run("  - look_from: [1, 0, 0]\n"), std::invalid_argument);
}

}  // namespace
}  // namespace shell_origami
