#include <shell_origami/origami/simulation.h>

#include <shell_origami/mesh/triangulate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;
constexpr double kGravity = 9.81;
const double kWeight = Material().arealDensity() * kSide * kSide * kGravity;  // [N]

Simulation square(double gravity = 0) {
  SimulationConfig config;
  config.gravity = {0, 0, -gravity};
  return Simulation(Sheet(triangulateRectangle(kSide, kSide, 0.02)), config);
}

Region leftEdge() { return {{{0, 0}, {0.001, 0}, {0.001, kSide}, {0, kSide}}}; }
Region rightEdge() { return {{{0.149, 0}, {kSide, 0}, {kSide, kSide}, {0.149, kSide}}}; }

Pose turnedBy(double angle, const Vector3& axis, const Vector3& position) {
  return {position, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()))};
}

TEST(HeldVertices, FollowTheirFrameRigidlyFromWhereTheyWere) {
  Simulation simulation = square();
  const Pose start = turnedBy(0.4, {1, 2, 3}, {0.3, -0.1, 0.2});
  const std::vector<int> held = simulation.pin(leftEdge(), "hand", start);
  const Positions before = simulation.positions();
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.5, Vector3::UnitX()));
  const Vector3 shift(0.01, 0.02, 0.03);
  constexpr int kSteps = 30;
  for (int i = 1; i <= kSteps; ++i) {
    const double s = static_cast<double>(i) / kSteps;
    const Eigen::Quaterniond part = Eigen::Quaterniond::Identity().slerp(s, turn);
    simulation.carry("hand",
                     {part * start.position + s * shift, (part * start.orientation).normalized()});
    ASSERT_TRUE(simulation.step().converged);
  }
  for (int v : held) {
    const Vector3 expected = turn * Vector3(before.col(v)) + shift;
    EXPECT_LT((simulation.positions().col(v) - expected).norm(), 1e-12);
  }
}

TEST(HeldVertices, StayWhereAFrameLastCarriedThem) {
  Simulation simulation = square();
  const int v = simulation.pin(std::vector<Vector2>{{0, 0}}, "hand", {})[0];
  simulation.carry("hand", Pose{Vector3(0, 0, 0.001)});
  simulation.step();
  const Vector3 there = simulation.positions().col(v);
  EXPECT_DOUBLE_EQ(there.z(), 0.001);
  for (int i = 0; i < 10; ++i) simulation.step();
  EXPECT_EQ(simulation.positions().col(v), there);
}

TEST(HeldVertices, AVertexIsHeldInOneWay) {
  Simulation simulation = square();
  const std::vector<std::int64_t> corner = {simulation.sheet().nearestVertex({0, 0})};
  const int v = static_cast<int>(corner[0]);
  simulation.pin(corner, "left", {});
  simulation.pin(corner, "right", {});
  EXPECT_EQ(simulation.held().grips().count("left"), 0u);
  EXPECT_EQ(simulation.held().grips().at("right").places.count(v), 1u);
  simulation.pin(corner);
  EXPECT_TRUE(simulation.held().grips().empty());
  EXPECT_EQ(simulation.pinned(), std::set<int>{v});
  simulation.pin(corner, "left", {});
  simulation.unpin(corner);
  EXPECT_TRUE(simulation.held().grips().empty());
  EXPECT_TRUE(simulation.pinned().empty());
}

TEST(HeldVertices, WhatAFrameTakesLaterGoesWithTheRest) {
  // The frame has moved on since it carried the paper last: nothing jumps.
  Simulation simulation = square();
  simulation.pin(leftEdge(), "hand", {});
  const Positions before = simulation.positions();
  const int v = simulation.pin(std::vector<Vector2>{{kSide, 0}}, "hand", Pose{{1, 1, 1}})[0];
  simulation.carry("hand", Pose{Vector3(0, 0, 0.001)});
  simulation.step();
  EXPECT_LT((simulation.positions().col(v) - before.col(v) - Vector3(0, 0, 0.001)).norm(), 1e-15);
}

TEST(HeldVertices, AFoldThroughThemMovesNothing) {
  Simulation simulation = square();
  const Pose pose = turnedBy(1, {3, 2, 1}, {0.1, 0.2, 0.3});
  const std::vector<int> held = simulation.pin(leftEdge(), "hand", pose);
  FoldEdit fold;
  fold.where = Segment{Vector2(0, 0.051), Vector2(kSide, 0.08)};
  fold.angle = 1;
  simulation.fold(fold);
  const Positions before = simulation.positions();
  simulation.carry("hand", {pose.position + Vector3(0, 0, 1e-6), pose.orientation});
  ASSERT_TRUE(simulation.step().converged);
  for (int v : held) {
    const Vector3 moved = simulation.positions().col(v) - before.col(v);
    EXPECT_LT((moved - Vector3(0, 0, 1e-6)).norm(), 1e-15);
  }
}

TEST(HeldVertices, TheReactionOfHangingPaperIsItsWeight) {
  Simulation simulation = square(kGravity);
  const Pose pose = turnedBy(0.7, {1, 1, 0}, {0.1, 0, 0.05});
  simulation.pin(leftEdge());
  simulation.pin(rightEdge(), "hand", pose);
  ASSERT_TRUE(simulation.settle().converged);
  const auto wrenches = simulation.holdingWrenches();
  ASSERT_EQ(wrenches.size(), 2u);
  const Wrench &left = wrenches.at(""), &hand = wrenches.at("hand");
  const Vector3 right_force = pose.orientation * hand.force;
  EXPECT_NEAR((left.force + right_force).z() / kWeight, 1, 1e-3);
  EXPECT_LT((left.force + right_force).head<2>().norm(), 1e-3 * kWeight);
  // Each bears half, and the torques about one point balance the weight at the middle.
  EXPECT_NEAR(left.force.z() / kWeight, 0.5, 0.01);
  const Vector3 right_torque = pose.orientation * hand.torque + pose.position.cross(right_force);
  const Vector3 middle(kSide / 2, kSide / 2, 0);
  const Vector3 torque = left.torque + right_torque;
  const Vector3 expected = middle.cross(Vector3(0, 0, kWeight));
  EXPECT_NEAR(torque.x(), expected.x(), 2e-3 * kWeight * kSide);
  EXPECT_NEAR(torque.y(), expected.y(), 2e-3 * kWeight * kSide);
}

TEST(HeldVertices, PaperThatAHandAcceleratesPullsAtIt) {
  // Held all over, so that it moves as one body: F = m a + m g.
  Simulation simulation = square(kGravity);
  simulation.pin(Region{{{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}}}, "hand", {});
  const double dt = simulation.config().solver.time_step, a = 3;
  for (int i = 1; i <= 10; ++i) {
    simulation.carry("hand", Pose{Vector3(0, 0, a / 2 * (i * dt) * (i * dt))});
    ASSERT_TRUE(simulation.step().converged);
  }
  const double speed = a * 9.5 * dt;  // over the last step
  const double drag = simulation.config().material.air_damping * speed;
  EXPECT_NEAR(simulation.holdingWrenches().at("hand").force.z(),
              kWeight / kGravity * (kGravity + a + drag), 1e-6 * kWeight);
}

TEST(HeldVertices, LetGoOnTheWayTheyStay) {
  Simulation simulation = square();
  simulation.pin(leftEdge(), "hand", {});
  simulation.carry("hand", Pose{Vector3(0, 0, 0.001)});
  simulation.unpin();
  ASSERT_TRUE(simulation.step().converged);
  EXPECT_EQ(simulation.positions().row(2).cwiseAbs().maxCoeff(), 0);

  simulation.pin(leftEdge(), "hand", {});
  simulation.carry("hand", Pose{Vector3(0, 0, 0.001)});
  simulation.pin(leftEdge());
  ASSERT_TRUE(simulation.step().converged);
  EXPECT_EQ(simulation.positions().row(2).cwiseAbs().maxCoeff(), 0);
}

// A recording holds no failed steps, so that what one leaves must be what was there before it.
TEST(HeldVertices, AFailedStepLeavesTheirWayToGo) {
  SimulationConfig config;
  config.solver.max_iterations = 1;
  Simulation simulation(Sheet(triangulateRectangle(kSide, kSide, 0.02)), config);
  simulation.pin(leftEdge(), "hand", {});
  simulation.pin(rightEdge());
  const Pose far{Vector3(-1, 0.5, 0.3)};
  simulation.carry("hand", far);
  ASSERT_FALSE(simulation.step().converged);
  EXPECT_TRUE(simulation.held().grips().at("hand").next == far);
  const Snapshot read = snapshotFrom(toJson(simulation.snapshot()));
  EXPECT_TRUE(read.held.grips().at("hand").next == far);
  EXPECT_TRUE(read.held.grips().at("hand").pose == Pose());
}

TEST(HeldVertices, RefuseWhatIsNoFrame) {
  Simulation simulation = square();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Pose no_length{Vector3::Zero(), Eigen::Quaterniond(0, 0, 0, 0)};
  EXPECT_THROW(simulation.pin(leftEdge(), "", {}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(leftEdge(), "hand", Pose{{nan, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(leftEdge(), "hand", Pose{{1e9, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(leftEdge(), "hand", no_length), std::invalid_argument);
  EXPECT_TRUE(simulation.pinned().empty());
  simulation.pin(leftEdge(), "hand", {});
  EXPECT_THROW(simulation.carry("foot", {}), std::invalid_argument);
  EXPECT_THROW(simulation.carry("hand", Pose{{0, 0, nan}}), std::invalid_argument);
  EXPECT_THROW(simulation.carry("hand", no_length), std::invalid_argument);
}

}  // namespace
}  // namespace shell_origami
