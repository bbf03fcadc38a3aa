#include <shell_origami/origami/recipe.h>

#include <shell_origami/mesh/triangulate.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace shell_origami {
namespace {

using Json = nlohmann::json;

constexpr double kSide = 0.15;

Snapshot throughAFile(const Snapshot& snapshot) {
  return snapshotFrom(Json::from_cbor(Json::to_cbor(toJson(snapshot))));
}

void run(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) ASSERT_TRUE(simulation.step().converged);
}

FoldEdit along(const Vector2& a, const Vector2& b, double angle) {
  FoldEdit fold;
  fold.where = Segment{a, b};
  fold.angle = angle;
  fold.duration = 0.4;
  return fold;
}

void expectSame(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(a.positions(), b.positions());
  EXPECT_EQ(a.velocities(), b.velocities());
  EXPECT_EQ(a.sheet().flatPositions(), b.sheet().flatPositions());
  EXPECT_EQ(a.sheet().triangles(), b.sheet().triangles());
  EXPECT_EQ(a.time(), b.time());
  EXPECT_EQ(a.counters().newton_iterations, b.counters().newton_iterations);
  ASSERT_EQ(a.creases().size(), b.creases().size());
  for (std::size_t i = 0; i < a.creases().size(); ++i) {
    EXPECT_EQ(a.creases()[i].id, b.creases()[i].id);
    EXPECT_EQ(a.creases()[i].name, b.creases()[i].name);
    EXPECT_EQ(a.creases()[i].moment, b.creases()[i].moment);
    EXPECT_EQ(a.creases()[i].target_angle, b.creases()[i].target_angle);
  }
}

/// Yields, hangs in gravity, is held by two frames and by a pin, and folds in two places.
Simulation busyPaper() {
  SimulationConfig config;
  config.gravity = {0, 0, -9.81};
  config.material.yield_curvature = 100;
  config.rest = {3, 0.4};
  Simulation simulation(Sheet(triangulateRectangle(kSide, kSide, 0.02)), config);
  simulation.pin(Region{{{0, 0}, {0.02, 0}, {0.02, kSide}, {0, kSide}}});
  simulation.pin(std::vector<Vector2>{{kSide, 0}}, "left", Pose{{0.2, 0, 0}});
  simulation.pin(std::vector<Vector2>{{kSide, kSide}}, "right", {});
  simulation.fold(along({0.07, 0}, {0.07, kSide}, 1.2));
  run(simulation, 10);
  simulation.fold(along({0, 0.05}, {kSide, 0.11}, -0.5));
  return simulation;
}

/// Returns the records of its edits.
std::vector<EditRecord> carryOn(Simulation& simulation) {
  std::vector<EditRecord> records;
  const auto make = [&](const Edit& edit) { records.push_back(simulation.apply(edit)); };
  for (int i = 1; i <= 12; ++i) {
    make(CarryEdit{"left", Pose{{0.2, 0, 0.002 * i}}});
    run(simulation, 1);
  }
  make(along({0.03, kSide}, {kSide, 0.03}, 0.4));
  run(simulation, 12);
  make(SettleEdit{});
  run(simulation, 3);
  make(UnpinEdit{});
  run(simulation, 3);
  return records;
}

TEST(Snapshot, PaperGoesOnToTheBitFromAnyMoment) {
  for (int steps : {0, 1, 9}) {
    Simulation original = busyPaper();
    run(original, steps);
    Simulation copy(throughAFile(original.snapshot()));
    expectSame(original, copy);
    carryOn(original);
    carryOn(copy);
    expectSame(original, copy);
  }
}

TEST(Snapshot, FreeCreasesOfAPatternGoOnToTheBit) {
  const Recipe recipe = loadRecipe("../recipes/waterbomb.yaml");
  Simulation original = makeSimulation(recipe.sheet, recipe.config);
  RecipeRunner runner(recipe);
  for (int i = 0; i < 30; ++i) {
    runner.update(original);
    run(original, 1);
  }
  Simulation copy(throughAFile(original.snapshot()));
  run(original, 30);
  run(copy, 30);
  expectSame(original, copy);
}

TEST(Snapshot, PaperAtRestStaysThere) {
  Simulation simulation = busyPaper();
  run(simulation, 2000);
  const auto iterations = simulation.counters().newton_iterations;
  run(simulation, 10);
  ASSERT_EQ(simulation.counters().newton_iterations, iterations) << "not at rest";
  Simulation copy(throughAFile(simulation.snapshot()));
  run(simulation, 10);
  run(copy, 10);
  expectSame(simulation, copy);
}

TEST(Snapshot, EditsDoneAgainGiveTheSameBits) {
  Simulation simulation = busyPaper();
  const Snapshot start = simulation.snapshot();
  std::vector<EditRecord> records;
  const int end = simulation.sheet().edges()[0].vertices[1];
  records.push_back(simulation.apply(AddVertexEdit{{0, end}, 0.3}));
  records.push_back(simulation.apply(ConfigureEdit{{{0, 0.5, -3}, 2, 0.7}}));
  for (EditRecord& record : carryOn(simulation)) records.push_back(std::move(record));
  Simulation again(start);
  for (const EditRecord& record : records) {
    while (again.counters().steps < record.step) ASSERT_TRUE(again.step().converged);
    again.apply(record.edit);
    EXPECT_EQ(again.sheet().revision(), record.revision);
  }
  while (again.counters().steps < simulation.counters().steps) again.step();
  expectSame(simulation, again);
}

TEST(Snapshot, WhatIsNoPaperIsRefused) {
  const Json good = toJson(busyPaper().snapshot());
  ASSERT_NO_THROW(snapshotFrom(good));
  EXPECT_THROW(snapshotFrom({}), std::invalid_argument);
  EXPECT_THROW(snapshotFrom("paper"), std::invalid_argument);
  const std::vector<std::pair<const char*, Json>> changes = {
      {"/config/material/thickness", -1},
      {"/config/solver/integrator", "guess"},
      {"/config/gravity", {0, 0}},
      {"/sheet/points/0", nullptr},
      {"/sheet/points", {0, 0, 1, 0, 0, 1}},
      {"/sheet/triangles/0/0", 100000},
      {"/sheet/triangles/0/0", -1},
      {"/sheet/creases/0/vertices", {0, 99999}},
      {"/sheet/creases/0/vertices", Json::array()},
      {"/sheet/next_crease_id", 0},
      {"/positions/7", "here"},
      {"/positions", {1, 2, 3}},
      {"/acceleration_persistence", "half"},
      {"/creases/ramps", Json::array()},
      {"/creases/ramps/0/1", nullptr},
      {"/rest/set", {1.0}},
      {"/in_plane", {0, 0, 0}},
      {"/in_plane/0", -0.5},
      {"/in_plane/2", 0.6},
      {"/in_plane/1", nullptr},
      {"/held/in_place", {-3}},
      {"/held/grips/left/orientation", {0, 0, 0, 0}},
      {"/held/grips/left/places/0/vertex", 1 << 20},
      {"/memory", 3},
      {"/counters/steps", "many"},
      {"/time", "noon"},
  };
  for (const auto& [where, value] : changes) {
    Json bad = good;
    bad[Json::json_pointer(where)] = value;
    EXPECT_THROW(snapshotFrom(bad), std::invalid_argument) << where;
  }
  for (const auto& entry : good.items()) {
    Json bad = good;
    bad.erase(entry.key());
    EXPECT_THROW(snapshotFrom(bad), std::invalid_argument) << entry.key();
  }
}

}  // namespace
}  // namespace shell_origami
