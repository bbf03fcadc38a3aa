/// Paper that is held softly.
#include <shell_origami/origami/obstacle_json.h>
#include "test/origami/squares.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

const Region kLeftEdge{{{0, 0}, {1e-3, 0}, {1e-3, kSide}, {0, kSide}}};
const Region kRightEdge{{{kSide - 1e-3, 0}, {kSide, 0}, {kSide, kSide}, {kSide - 1e-3, kSide}}};

void run(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation.step();
    ASSERT_TRUE(report.converged) << report.failure;
  }
}

TEST(Grasps, BearTheWeightOfPaper) {
  Simulation simulation = square(heavy());
  simulation.apply(GraspEdit{"hand", kLeftEdge, {100, 1, 0.05}});
  settle(simulation);
  const double weight = weightOf(simulation);
  const Wrench wrench = simulation.graspWrenches().at("hand");
  EXPECT_NEAR(wrench.force.z(), weight, 0.01 * weight);
  // Each spring gives way by the weight over the stiffness of all.
  double sunk = 0;
  const auto& vertices = simulation.grasps().all().at("hand").vertices;
  for (const auto& [v, vertex] : vertices) {
    sunk -= simulation.positions()(2, v) / static_cast<double>(vertices.size());
  }
  EXPECT_NEAR(sunk, weight / 100, 0.02 * weight / 100);
}

TEST(Grasps, SlipAtTheirForce) {
  Simulation simulation = square();
  simulation.pin(kLeftEdge);
  const double force = 0.5;
  simulation.apply(GraspEdit{"hand", kRightEdge, {1000, force, 0.1}, "arm", {}});
  // Far more than the springs reach and the paper stretches.
  for (int i = 0; i < 60; ++i) {
    simulation.carry("arm", {{0.02 * (simulation.time() + 1. / 60), 0, 0}});
    run(simulation, 1);
  }
  EXPECT_NEAR(simulation.graspWrenches().at("hand").force.x(), force, 1e-3 * force);
  EXPECT_NEAR(simulation.holdingWrenches().at("").force.x(), -force, 0.02 * force);
  const auto& grasp = simulation.grasps().all().at("hand");
  EXPECT_EQ(grasp.pose.position.x(), 0.02 * simulation.time());
  for (const auto& [v, vertex] : grasp.vertices) {
    EXPECT_NEAR((vertex.place - vertex.grasped).x(), -0.02, 2e-3);
  }
  // Back again it gives way at once, the other way round.
  simulation.carry("arm", {{0.015, 0, 0}});
  run(simulation, 1);
  EXPECT_LT(simulation.graspWrenches().at("hand").force.x(), 0);
}

TEST(Grasps, LoseWhatSlipsOutOfReach) {
  Simulation simulation = square();
  simulation.pin(kLeftEdge);
  simulation.apply(GraspEdit{"hand", kRightEdge, {1000, 0.5, 0.005}, "arm", {}});
  for (int i = 0; i < 60; ++i) {
    simulation.carry("arm", {{0.02 * (simulation.time() + 1. / 60), 0, 0}});
    run(simulation, 1);
  }
  EXPECT_TRUE(simulation.grasps().all().at("hand").vertices.empty());
  EXPECT_LT(simulation.maxStrain(), 1e-3);
}

TEST(Grasps, CarryPaperAlong) {
  Simulation simulation = square(heavy());
  simulation.apply(GraspEdit{"hand", kLeftEdge, {1000, 1, 0.01}, "arm", {}});
  for (int i = 0; i < 120; ++i) {
    const double t = std::min(1.0, simulation.time() + 1. / 60);
    simulation.carry("arm", {{0, 0, 0.1 * t}});
    run(simulation, 1);
  }
  settle(simulation);
  const double weight = weightOf(simulation);
  for (const auto& [v, vertex] : simulation.grasps().all().at("hand").vertices) {
    EXPECT_NEAR(simulation.positions()(2, v), 0.1 - weight / 1000, 0.02 * weight / 1000);
  }
}

TEST(Grasps, LetGo) {
  Simulation simulation = square(heavy());
  simulation.apply(GraspEdit{"hand", kLeftEdge});
  run(simulation, 10);
  EXPECT_EQ(simulation.apply(ReleaseEdit{}).ids, std::vector<std::string>{"hand"});
  run(simulation, 30);
  EXPECT_LT(simulation.positions().row(2).maxCoeff(), -0.3);
}

TEST(Grasps, ThatCannotBeAreRejected) {
  Simulation simulation = square();
  simulation.apply(GraspEdit{"hand", kLeftEdge});
  const auto has = [&](const Edit& edit, const std::string& words) {
    const std::string message = rejection(simulation, edit);
    EXPECT_NE(message.find(words), std::string::npos) << words << ": " << message;
  };
  has(GraspEdit{"", kLeftEdge}, "is no name of a grasp");
  has(GraspEdit{"hand", kLeftEdge}, "there is a grasp 'hand' already");
  has(AddObstacleEdit{"hand", Sphere{0.1}, {{1, 1, 1}}, {}, "", {}},
      "there is a grasp 'hand' already");
  has(GraspEdit{"o", std::vector<std::int64_t>{99999}}, "99999");
  has(GraspEdit{"o", kLeftEdge, {-1, 1, 1}}, "stiffness is -1");
  has(GraspEdit{"o", kLeftEdge, {1, std::nan(""), 1}}, "max_force is nan");
  has(GraspEdit{"o", kLeftEdge, {1, 1, 0}}, "reach is 0");
  has(ReleaseEdit{{"arm"}}, "there is no grasp 'arm'");
  EXPECT_EQ(simulation.grasps().all().size(), 1u);
}

TEST(Grasps, GoOnToTheBitFromASnapshot) {
  Simulation simulation = square(heavy());
  simulation.apply(GraspEdit{"left", kLeftEdge, {200, 0.006, 0.02}, "arm", {}});
  simulation.apply(GraspEdit{"right", kRightEdge});
  simulation.fold(diagonal(1));
  run(simulation, 20);
  const auto bytes = nlohmann::json::to_cbor(toJson(simulation.snapshot()));
  Simulation again(snapshotFrom(nlohmann::json::from_cbor(bytes)));
  EXPECT_EQ(toJson(again.grasps()), toJson(simulation.grasps()));
  run(simulation, 20);
  run(again, 20);
  EXPECT_TRUE(again.positions() == simulation.positions());
}

}  // namespace
}  // namespace shell_origami
