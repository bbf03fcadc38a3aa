/// How the paper moves: folds, rest, pins, gravity.
#include "test/origami/squares.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace shell_origami {
namespace {

class FoldAngle : public testing::TestWithParam<double> {};

TEST_P(FoldAngle, OneCreaseComesToRestAtItsTarget) {
  Simulation simulation = square();
  simulation.fold(diagonal(GetParam() * kDegree));
  settle(simulation);
  EXPECT_TRUE(simulation.settled());
  const CreaseStatus crease = simulation.creases()[0];
  // Creases rest at 179 degrees at most. Settled paper may still swing by a part of a degree.
  const double expected = std::copysign(std::min(std::abs(GetParam()), 179.0), GetParam());
  EXPECT_NEAR(crease.angle / kDegree, expected, 0.3);
  EXPECT_LT(simulation.maxStrain(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Angles, FoldAngle,
                         testing::Values(30, -30, 90, -90, 150, -170, 170, 179, 179.9));

TEST(Simulation, AFoldAskedForAtOnceArrivesToo) {
  for (const double duration : {0.0, 0.01}) {
    Simulation simulation = square();
    simulation.fold(diagonal(170 * kDegree, duration));
    settle(simulation);
    EXPECT_NEAR(simulation.creases()[0].angle / kDegree, 170, 0.3);
  }
}

TEST(Simulation, RampRunsFromThePresentRestAngle) {
  Simulation simulation = square();
  simulation.fold(diagonal(90 * kDegree));
  settle(simulation);
  simulation.fold(diagonal(-90 * kDegree, 1));
  EXPECT_NEAR(simulation.creases()[0].rest_angle / kDegree, 90, 1e-9);
  EXPECT_EQ(simulation.creases().size(), 1u);
  settle(simulation);
  EXPECT_NEAR(simulation.creases()[0].angle / kDegree, -90, 0.3);
}

TEST(Simulation, InterruptedRampGoesOnFromWhereItIs) {
  Simulation simulation = square();
  simulation.fold(diagonal(120 * kDegree, 1));
  for (int i = 0; i < 30; ++i) simulation.step();
  const double halfway = simulation.creases()[0].rest_angle;
  EXPECT_NEAR(halfway / kDegree, 60, 0.5);  // half of a smooth step
  simulation.fold(diagonal(0, 1));
  EXPECT_DOUBLE_EQ(simulation.creases()[0].rest_angle, halfway);
}

// Before its first step it was told as settled, whatever its forces.
TEST(Simulation, PaperThatWasLetGoHasNotSettled) {
  SimulationConfig config;
  config.gravity = {0, 0, -9.81};
  Simulation simulation(Sheet(triangulateRectangle(0.1, 0.1, 0.02)), config);
  simulation.pin(std::vector<std::int64_t>{0, 1, 2, 3});
  while (!simulation.resting()) ASSERT_TRUE(simulation.step().converged);
  EXPECT_TRUE(simulation.settled());
  simulation.pin(std::vector<std::int64_t>{0});
  EXPECT_TRUE(simulation.settled());
  simulation.unpin();
  EXPECT_FALSE(simulation.settled());
  EXPECT_FALSE(Simulation(simulation.snapshot()).settled());
}

TEST(Simulation, StrainedPaperOfAFileHasNotSettled) {
  Simulation flat = square();
  EXPECT_TRUE(flat.settled());
  const Simulation stretched(flat.sheet(), {}, 1.001 * flat.positions(), {});
  EXPECT_FALSE(stretched.settled());
}

TEST(Simulation, AStoppedFoldEndsWhereItIs) {
  Simulation simulation = square();
  const EditRecord fold = simulation.fold(diagonal(120 * kDegree));
  while (simulation.time() < 0.2) simulation.step();
  const double reached = simulation.creases()[0].rest_angle;
  EXPECT_GT(reached, 20 * kDegree);
  EXPECT_LT(reached, 100 * kDegree);
  const EditRecord stop = simulation.apply(StopEdit{});
  EXPECT_FALSE(simulation.folding());
  settle(simulation);
  EXPECT_DOUBLE_EQ(simulation.creases()[0].rest_angle, reached);
  EXPECT_DOUBLE_EQ(simulation.creases()[0].target_angle, reached);
  EXPECT_NEAR(simulation.creases()[0].angle, reached, 0.3 * kDegree);
  simulation.stopFolds();  // nothing is under way
  EXPECT_DOUBLE_EQ(simulation.creases()[0].rest_angle, reached);

  Simulation again = square();
  again.apply(fold.edit);
  while (again.counters().steps < stop.step) again.step();
  again.apply(stop.edit);
  EXPECT_EQ(again.creases()[0].rest_angle, reached);
}

TEST(Simulation, SameCallsGiveTheSameBits) {
  const auto run = [] {
    Simulation simulation = square();
    simulation.pin(Region{{{0, 0}, {0.03, 0}, {0.03, 0.03}}});
    simulation.fold(diagonal(160 * kDegree));
    for (int i = 0; i < 40; ++i) simulation.step();
    FoldEdit second = diagonal(-60 * kDegree);
    second.where = Segment{Vector2(0.02, 0.12), Vector2(0.14, 0.05)};
    simulation.fold(second);
    for (int i = 0; i < 40; ++i) simulation.step();
    return simulation.positions();
  };
  const Positions a = run(), b = run();
  ASSERT_EQ(a.cols(), b.cols());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

TEST(Simulation, PaperAtRestCostsNothingUntilAnEditTouchesIt) {
  SimulationConfig config;
  config.gravity = {0, 0, -9.81};
  Simulation simulation = square(config);
  simulation.pin(Region{{{0, 0}, {kSide, 0}, {kSide, 0.03}, {0, 0.03}}});
  simulation.fold(diagonal(60 * kDegree));
  for (int i = 0; i < 1200; ++i) ASSERT_TRUE(simulation.step().converged);
  const Positions rest = simulation.positions();
  const Counters before = simulation.counters();
  const double time = simulation.time();
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(simulation.step().converged);
  EXPECT_EQ(simulation.counters().newton_iterations, before.newton_iterations);
  EXPECT_EQ(simulation.counters().steps, before.steps + 100);
  EXPECT_NEAR(simulation.time(), time + 100.0 / 60, 1e-9);
  EXPECT_EQ(simulation.positions(), rest);
  // It rests where it is in equilibrium: going there at once hardly moves it.
  Simulation copy(simulation.sheet(), config, rest, {simulation.creases()[0].rest_angle});
  copy.pin(Region{{{0, 0}, {kSide, 0}, {kSide, 0.03}, {0, 0.03}}});
  ASSERT_TRUE(copy.settle().converged);
  EXPECT_LT((copy.positions() - rest).colwise().norm().maxCoeff(), 1e-4 * kSide);
  // Let go, it falls.
  simulation.unpin();
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(simulation.step().converged);
  EXPECT_LT((simulation.positions() - rest).row(2).maxCoeff(), -0.05);
}

TEST(Simulation, PinnedVerticesDoNotMoveByABit) {
  SimulationConfig config;
  config.gravity = {0, 0, -9.81};
  Simulation simulation = square(config);
  const std::vector<int> held = simulation.pin(Region{{{0, 0}, {kSide, 0}, {kSide, 0.001}}});
  EXPECT_GE(held.size(), 8u);
  const Positions before = simulation.positions();
  simulation.fold(diagonal(100 * kDegree));
  for (int i = 0; i < 60; ++i) ASSERT_TRUE(simulation.step().converged);
  for (int v : held) EXPECT_EQ(simulation.positions().col(v), before.col(v));
  EXPECT_LT(simulation.positions().row(2).minCoeff(), -0.01);
  EXPECT_EQ(simulation.unpin(), held);
  EXPECT_TRUE(simulation.pinned().empty());
}

TEST(Simulation, FloatingPaperKeepsItsCentreWhileItFolds) {
  SimulationConfig config;
  config.material.air_damping = 0;
  config.solver.tolerance = 1e-8;
  Simulation simulation = square(config);
  simulation.fold(diagonal(120 * kDegree));
  const auto centre = [&simulation] {
    const Shell shell(simulation.sheet(), simulation.config().material);
    return Vector3(simulation.positions() * shell.masses() / shell.masses().sum());
  };
  const Vector3 before = centre();
  for (int i = 0; i < 60; ++i) simulation.step();
  EXPECT_LT((centre() - before).norm(), 1e-9 * kSide);
}

TEST(Simulation, FallingPaperFollowsGravityAndAir) {
  SimulationConfig config;
  config.gravity = {0, 0, -9.81};
  config.material.air_damping = 4;
  config.solver.time_step = 1e-3;
  Simulation simulation = square(config);
  for (int i = 0; i < 500; ++i) simulation.step();
  // z = -g/c (t - (1 - exp(-c t)) / c)
  const double c = 4, t = simulation.time();
  const double expected = -9.81 / c * (t - (1 - std::exp(-c * t)) / c);
  EXPECT_NEAR(simulation.positions().row(2).mean() / expected, 1, 2e-3);
  EXPECT_LT(simulation.maxStrain(), 1e-9);
}

/// Solves may trust what the one before has shown, but not across an event.
TEST(Simulation, AfterAFoldOrAStepInPartsTheSolverLooksAgain) {
  Simulation folded = square();
  folded.fold(diagonal(1));
  settle(folded);
  Snapshot trusting = folded.snapshot();
  trusting.solver = {1e-6, 2};
  Simulation unfolding(trusting), yanked(trusting);
  FoldEdit back = diagonal(-1);
  back.where = CreaseName{folded.creases()[0].name};
  unfolding.fold(back);
  EXPECT_EQ(unfolding.snapshot().solver.contraction, 1);
  EXPECT_EQ(unfolding.snapshot().solver.unchecked, 0);

  yanked.pin(std::vector<Vector2>{{0, 0}}, "hand", {});
  yanked.carry("hand", Pose{Vector3(0, 0, 0.05)});
  const StepReport report = yanked.step();
  ASSERT_TRUE(report.converged) << report.failure;
  ASSERT_GT(report.retries, 0);
  EXPECT_EQ(yanked.snapshot().solver.contraction, 1);
  EXPECT_EQ(yanked.snapshot().solver.unchecked, 0);
}

}  // namespace
}  // namespace shell_origami
