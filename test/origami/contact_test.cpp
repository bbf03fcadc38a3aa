/// Paper that cannot pass through itself, as users of a simulation see it.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/simulation.h>

#include "verify/loose_leaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;
constexpr double kDegree = M_PI / 180;

Simulation square(const SimulationConfig& config = {}) {
  return Simulation(Sheet(triangulateRectangle(kSide, kSide, 0.0125)), config);
}

SimulationConfig without() {
  SimulationConfig config;
  config.contact.enabled = false;
  return config;
}

FoldEdit across(double x, double degrees, double duration = 1) {
  FoldEdit edit;
  edit.where = Segment{Vector2(x, 0), Vector2(x, kSide)};
  edit.angle = degrees * kDegree;
  edit.duration = duration;
  return edit;
}

/// Steps on, with a look at every `every`-th state.
void run(Simulation& simulation, int steps, int every = 10) {
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation.step();
    ASSERT_TRUE(report.converged) << report.failure;
    if (i % every == 0) {
      ASSERT_TRUE(simulation.crossings().empty()) << simulation.time() << " s";
    }
  }
}

/// Two flaps, each a third of the sheet, of which the second comes to lie on the first.
Simulation letter(const SimulationConfig& config = {}) {
  Simulation simulation = square(config);
  simulation.fold(across(kSide / 3, 175));
  simulation.fold(across(2 * kSide / 3, 175));
  return simulation;
}

TEST(Contact, NothingNearIsTheSameToTheBit) {
  Simulation with = square(), other = square(without());
  for (Simulation* simulation : {&with, &other}) {
    simulation->fold(across(kSide / 2, 150));
    for (int i = 0; i < 100; ++i) simulation->step();
  }
  EXPECT_EQ(with.positions(), other.positions());
  EXPECT_EQ(with.counters().newton_iterations, other.counters().newton_iterations);
}

TEST(Contact, FlapsStopAtEachOther) {
  Simulation through = letter(without());
  for (int i = 0; i < 60; ++i) through.step();
  ASSERT_FALSE(through.crossings().empty()) << "the scene tests nothing";
  Simulation simulation = letter();
  run(simulation, 120, 4);
  EXPECT_FALSE(simulation.contacts().empty());
  EXPECT_GT(smallestGap(simulation.contacts()), 0);
  EXPECT_GT(simulation.energies().contact, 0);
  EXPECT_EQ(crossingSentence(simulation), "");
}

TEST(Contact, AnImpactOfWholeFacesKeepsThemApart) {
  Simulation simulation = square();
  simulation.fold(across(kSide / 2, 179, 0.3));
  run(simulation, 120, 1);
  EXPECT_NEAR(simulation.creases()[0].angle / kDegree, 179, 0.3);
}

// Contact acts within the paper: it changes no momentum. What a step leaves of it is the solver's
// tolerance, 1e-4 m/s at most for a vertex, over all of them and the steps of the impact.
TEST(Contact, ACollisionKeepsMomentum) {
  SimulationConfig config;
  config.material.air_damping = 0;
  config.solver.tolerance = 1e-8;
  Simulation simulation = letter(config);
  const auto momentum = [&] {
    return Vector3(simulation.velocities() * simulation.shell().shell().masses());
  };
  bool touched = false;
  for (int i = 0; i < 70; ++i) {
    const StepReport report = simulation.step();
    ASSERT_TRUE(report.converged) << report.failure;
    touched = touched || !simulation.contacts().empty();
    ASSERT_LT(momentum().norm(), 1e-8) << simulation.time();
  }
  EXPECT_TRUE(touched);
}

// A leaf that slid down another one stopped within a step: what an earlier step had shown of how
// well Newton's method converges was held to be true of a step that began elsewhere.
TEST(Contact, ALeafThatSlidesKeepsItsSpeed) {
  SimulationConfig config;
  config.material.air_damping = 0;
  config.solver.tolerance = 1e-8;
  config.gravity = Vector3(0, 0, -9.81);
  const Eigen::Isometry3d table = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d above(Eigen::Translation3d(-0.03, 0, 6e-5) *
                                Eigen::AngleAxisd(0.3, Vector3::UnitZ()));
  LooseLeaves leaves({{0.18, table}, {0.06, above}}, 0.02, config);
  leaves.simulation().pin(leaves.vertices(0));
  for (int i = 0; i < 120; ++i) leaves.step();
  const double slope = std::atan(1.02 * config.contact.friction);
  const auto speed = [&] { return leaves.mean(1, leaves.simulation().velocities()).x(); };
  double last = 0;
  for (int i = 1; i <= 60; ++i) {
    const double angle = slope * std::min(1.0, i / 30.0);
    leaves.simulation().configure({9.81 * Vector3(std::sin(angle), 0, -std::cos(angle)), 0, 1});
    leaves.step();
    ASSERT_GT(speed(), last) << "step " << i;
    last = speed();
  }
  // Half a second at g (sin - mu cos), within the first and the last of these steps.
  const double gain = 9.81 * (std::sin(slope) - config.contact.friction * std::cos(slope)) / 60;
  EXPECT_NEAR(last, 30 * gain, 2 * gain);
}

TEST(Contact, GoesOnFromASnapshotInMidContactToTheBit) {
  Simulation simulation = letter();
  while (simulation.contacts().empty()) ASSERT_TRUE(simulation.step().converged);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(simulation.step().converged);
  Simulation restored(snapshotFrom(toJson(simulation.snapshot())));
  for (int i = 0; i < 30; ++i) {
    simulation.step();
    restored.step();
    ASSERT_EQ(simulation.positions(), restored.positions()) << i;
  }
}

TEST(Contact, ALineAcrossLayersThatTouchLeavesThemApart) {
  Simulation simulation = letter();
  run(simulation, 120);
  ASSERT_FALSE(simulation.contacts().empty());
  for (const double y : {0.041, 0.0785, 0.11}) {
    FoldEdit edit;
    edit.where = Segment{Vector2(0, y), Vector2(kSide, y + 0.013)};
    edit.angle = 0.3;
    simulation.fold(edit);
    ASSERT_TRUE(simulation.crossings().empty()) << y;
    run(simulation, 20, 5);
  }
}

TEST(Contact, EquilibriumIsFoundWithoutACrossing) {
  Simulation simulation = letter();
  run(simulation, 70);
  simulation.settle();
  EXPECT_TRUE(simulation.crossings().empty());
  EXPECT_TRUE(simulation.settled());
}

/// A sheet folded in half to 90 degrees, whose flap a frame holds by its edge.
TEST(Contact, AFrameThatPushesPaperIntoPaperIsStopped) {
  Simulation simulation = square();
  simulation.pin(Region{{{0.08, 0}, {0.15, 0}, {0.15, 0.15}, {0.08, 0.15}}});
  simulation.fold(across(kSide / 2, 90));
  run(simulation, 90);
  simulation.pin(std::vector<Vector2>{{0, 0.075}}, "hand", {});
  Pose pose;
  bool blocked = false;
  // Down through the pinned half, 6 mm a step.
  for (int i = 0; i < 40; ++i) {
    pose.position.z() -= 0.006;
    pose.position.x() += 0.002;
    simulation.carry("hand", pose);
    const double time = simulation.time();
    const StepReport report = simulation.step();
    if (!report.converged) break;
    EXPECT_GT(simulation.time(), time);
    ASSERT_TRUE(simulation.crossings().empty()) << i;
    blocked = blocked || simulation.blocked();
  }
  ASSERT_TRUE(blocked);
}

TEST(Contact, WhatCrossesWhenItIsMadeIsLeftOutAndTold) {
  Simulation through = letter(without());
  for (int i = 0; i < 60; ++i) through.step();
  const std::size_t before = through.crossings().size();
  ASSERT_GT(before, 0u);
  std::vector<double> rest;
  for (const CreaseStatus& crease : through.creases()) rest.push_back(crease.rest_angle);
  Simulation simulation(through.sheet(), {}, through.positions(), rest);
  EXPECT_NE(crossingSentence(simulation).find(std::to_string(before) + " pairs"),
            std::string::npos);
  simulation.fold(across(2 * kSide / 3, 20));
  simulation.fold(across(kSide / 3, 20));
  for (int i = 0; i < 200; ++i) {
    const StepReport report = simulation.step();
    ASSERT_TRUE(report.converged) << report.failure;
    ASSERT_LT(simulation.maxStrain(), 0.01);
  }
  EXPECT_EQ(crossingSentence(simulation), "") << "it has parted";
  simulation.fold(across(2 * kSide / 3, 175));
  simulation.fold(across(kSide / 3, 175));
  run(simulation, 100);
}

}  // namespace
}  // namespace shell_origami
