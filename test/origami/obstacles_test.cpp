/// Paper that lies on rigid bodies, is pushed by them, and does not pass through them.
#include <shell_origami/origami/obstacle_json.h>
#include "test/origami/squares.h"
#include "verify/obstacle_scenes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

/// A square at a pose, flat.
Simulation squareAt(const Pose& pose, const SimulationConfig& config = heavy()) {
  const Sheet sheet(triangulateRectangle(kSide, kSide, 0.0125));
  Positions x = flatInSpace(sheet);
  for (Eigen::Index v = 0; v < x.cols(); ++v) x.col(v) = pose.toWorld(x.col(v));
  return Simulation(sheet, config, x, {});
}

TEST(Obstacles, ADroppedSheetRestsOnATable) {
  Simulation simulation = droppedSheet(0.0125);
  EXPECT_TRUE(simulation.resting());
  const double distance = simulation.config().contact.distance;
  EXPECT_LE(simulation.positions().row(2).maxCoeff(), 0);
  EXPECT_GE(simulation.positions().row(2).minCoeff(), -distance);
  const Wrench wrench = simulation.obstacleWrenches().at("table");
  const double weight = weightOf(simulation);
  EXPECT_LT(wrench.force.head<2>().norm(), 1e-6 * weight);
  // About the origin, a corner of the sheet.
  EXPECT_NEAR(wrench.torque.x(), -weight * kSide / 2, 2e-3 * weight * kSide);
  EXPECT_NEAR(wrench.torque.y(), weight * kSide / 2, 2e-3 * weight * kSide);
  const Positions before = simulation.positions();
  advance(simulation, 3600);
  EXPECT_TRUE(simulation.positions() == before);
}

/// A sheet that hangs from its pinned upper edge, in the plane x = 0.
Simulation hangingSheet() {
  const Pose upright{Vector3::Zero(),
                     Eigen::Quaterniond(Eigen::AngleAxisd(-M_PI / 2, Vector3::UnitY()))};
  Simulation simulation = squareAt(upright);
  simulation.pin(Region{{{kSide - 1e-3, 0}, {kSide, 0}, {kSide, kSide}, {kSide - 1e-3, kSide}}});
  return simulation;
}

TEST(Obstacles, AFastBoxSweepsAFlapAside) {
  Simulation simulation = hangingSheet();
  simulation.apply(obstacle("box", Box{{0.02, 0.3, 0.02}}, {{-0.1, kSide / 2, 0.03}}));
  simulation.apply(MoveObstacleEdit{"box", {{0.2, kSide / 2, 0.03}}, 0.3});
  double farthest = 0;
  for (int i = 0; i < 18; ++i) {
    advance(simulation, 1);
    // At no time slower than 1 m/s.
    EXPECT_FALSE(simulation.stopped());
    farthest = std::max(farthest, simulation.positions().row(0).mean());
  }
  EXPECT_NEAR(simulation.obstacles().all().at("box").base.position.x(), 0.2, 1e-12);
  EXPECT_GT(farthest, 0.03);
  advance(simulation, 60);
  EXPECT_LT(simulation.maxStrain(), 1e-4);
}

TEST(Obstacles, ABallThatIsDrivenThroughPinnedPaperIsStopped) {
  Simulation simulation = square();
  simulation.pin(Region{{{0, 0}, {kSide, 0}, {kSide, 1e-3}, {0, 1e-3}}});
  simulation.pin(Region{{{0, kSide - 1e-3}, {kSide, kSide - 1e-3}, {kSide, kSide}, {0, kSide}}});
  const Vector3 above(kSide / 2, kSide / 2, 0.05), below(kSide / 2, kSide / 2, -0.05);
  simulation.apply(obstacle("ball", Sphere{0.02}, {above}));
  simulation.apply(MoveObstacleEdit{"ball", {below}, 0.5});
  bool stopped = false;
  for (int i = 0; i < 45; ++i) {
    advance(simulation, 1);
    stopped = stopped || (simulation.stopped() &&
                          simulation.stopped()->ids == std::vector<std::string>{"ball"});
  }
  EXPECT_TRUE(stopped);
  EXPECT_LE(simulation.maxStrain(), 1.05 * kBearableStrain);
  const Obstacle& ball = simulation.obstacles().all().at("ball");
  EXPECT_GT(ball.base.position.z(), 0);
  EXPECT_FALSE(simulation.obstacles().moving()) << "a move that is late ends where it is stopped";
  // And back again.
  simulation.apply(MoveObstacleEdit{"ball", {above}, 0.5});
  advance(simulation, 60);
  EXPECT_EQ(simulation.obstacles().all().at("ball").base.position, above);
  EXPECT_LT(simulation.maxStrain(), 1e-3);
}

TEST(Obstacles, AFrameCarriesABoxThatCarriesPaper) {
  Simulation simulation = squareAt({{0, 0, 1e-3}});
  AddObstacleEdit tray = obstacle("tray", Box{{0.2, 0.2, 0.01}}, {{kSide / 2, kSide / 2, -0.005}});
  tray.frame = "lift";
  simulation.apply(tray);
  advance(simulation, 30);
  // Up at 0.3 m/s, gently begun and ended.
  const auto height = [](double t) { return 0.15 * (1 - std::cos(M_PI * std::min(t, 1.0))); };
  const double start = simulation.time();
  for (int i = 0; i < 90; ++i) {
    simulation.carry("lift", {{0, 0, height(simulation.time() - start + 1. / 60)}});
    advance(simulation, 1);
  }
  EXPECT_NEAR(simulation.positions().row(2).mean(), height(1), 1e-4);
  EXPECT_EQ(simulation.carriedFrames().at("lift").pose, (Pose{{0, 0, height(1)}}));
  EXPECT_THROW(simulation.apply(MoveObstacleEdit{"tray", {}, 1}), std::invalid_argument);
}

TEST(Obstacles, PaperFallsWhenItsTableIsTakenAway) {
  Simulation simulation = squareAt({{0, 0, 1e-3}});
  simulation.apply(obstacle("table", HalfSpace{}));
  advance(simulation, 60);
  ASSERT_TRUE(simulation.resting());
  EXPECT_EQ(simulation.apply(RemoveObstacleEdit{}).ids, std::vector<std::string>{"table"});
  advance(simulation, 30);
  EXPECT_LT(simulation.positions().row(2).maxCoeff(), -0.3);
}

TEST(Obstacles, PaperThatLiesFlatOnATableIsLetLie) {
  Simulation simulation = squareAt({});
  simulation.apply(obstacle("table", HalfSpace{}));
  advance(simulation, 60);
  EXPECT_TRUE(simulation.resting());
}

TEST(Obstacles, PaperComesToEquilibriumOnABall) {
  Simulation simulation = squareAt({{-kSide / 2, -kSide / 2, 0.051}});
  simulation.apply(obstacle("ball", Sphere{0.05}));
  simulation.settle();
  const double weight = weightOf(simulation);
  EXPECT_NEAR(simulation.obstacleWrenches().at("ball").force.z(), -weight, 0.01 * weight);
  EXPECT_EQ(simulation.cutObstacle(), "");
}

TEST(Obstacles, CreasesAreMadeInPaperThatLiesOnABall) {
  Simulation simulation = squareAt({{-kSide / 2, -kSide / 2, 0.051}});
  simulation.apply(obstacle("ball", Sphere{0.05}, {}, 1));
  advance(simulation, 30);
  simulation.fold(diagonal(-1));
  simulation.fold({Segment{Vector2(0.03, 0), Vector2(0.05, kSide)}, -0.3, 0.5, {}, "", 0});
  EXPECT_EQ(simulation.cutObstacle(), "");
  advance(simulation, 60);
}

struct Rejection {
  AddObstacleEdit edit;
  std::string words;
};

TEST(Obstacles, ThatCannotBeAreRejected) {
  Simulation simulation = square();
  simulation.apply(obstacle("table", HalfSpace{}));
  const double nan = std::nan("");
  const Pose beside{{1, 0, 1}};
  const auto surface = [](Surface made) {
    return MeshShape{std::make_shared<const Surface>(std::move(made))};
  };
  Surface open = boxSurface({0.1, 0.1, 0.1}), wild = open, far = open;
  open.faces.pop_back();
  wild.faces[0][0] = 8;
  far.vertices(0, 0) = nan;
  const std::vector<Rejection> cases{
      {obstacle("", Sphere{0.1}, beside), "is no name of an obstacle"},
      {obstacle("a/b", Sphere{0.1}, beside), "'a/b' is no name of an obstacle"},
      {obstacle("table", Sphere{0.1}, beside), "there is an obstacle 'table' already"},
      {obstacle("o", Sphere{-0.1}, beside), "radius is -0.1 m"},
      {obstacle("o", Sphere{nan}, beside), "radius is nan m"},
      {obstacle("o", Box{{0.1, 1e-4, 0.1}}, beside), "box is 0.0001 m"},
      {obstacle("o", Cylinder{0.1, 1e6}, beside), "length is 1e+06 m"},
      {obstacle("o", Sphere{0.1}, {{nan, 0, 0}}), "a frame stands at (nan, 0, 0)"},
      {obstacle("o", Sphere{0.1}, {{0, 0, 0}, Eigen::Quaterniond(1, 1, 0, 0)}), "length 1.41"},
      {obstacle("o", Sphere{0.1}, beside, -1), "friction -1 is not from 0 to 10"},
      {obstacle("o", Sphere{0.1}, beside, nan), "friction nan"},
      {obstacle("o", surface(open), beside), "is open at the edge"},
      {obstacle("o", surface(wild), beside), "has no vertex 8"},
      {obstacle("o", surface(far), beside), "is not finite"},
      {obstacle("o", surface({}), beside), "has no triangle"},
      {obstacle("o", Sphere{0.02}, {{0.05, 0.05, 0.01}}), "would cut the paper"},
      {obstacle("o", Box{{1, 1, 1}}, {{0.05, 0.05, 0.01}}), "would cut the paper"},
      {obstacle("o", HalfSpace{}, {{0, 0, 1e-3}}), "would cut the paper"},
  };
  for (const Rejection& rejected : cases) {
    const std::string message = rejection(simulation, rejected.edit);
    EXPECT_NE(message.find(rejected.words), std::string::npos) << rejected.words << ": " << message;
  }
  EXPECT_EQ(rejection(simulation, RemoveObstacleEdit{{"table", "chair"}}),
            "there is no obstacle 'chair'");
  EXPECT_EQ(rejection(simulation, MoveObstacleEdit{"chair", {}, 1}),
            "there is no obstacle 'chair'");
  EXPECT_NE(rejection(simulation, MoveObstacleEdit{"table", {}, nan}).find("duration nan s"),
            std::string::npos);
  EXPECT_EQ(simulation.obstacles().all().size(), 1u);
  EXPECT_TRUE(simulation.step().converged);
}

/// Slides down a slope against a box that a frame moves.
Simulation busyScene() {
  Simulation simulation = squareAt({{0, 0, 5e-3}});
  simulation.apply(
      obstacle("slope", HalfSpace{},
               {{0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(0.02, Vector3::UnitY()))}));
  AddObstacleEdit box = obstacle("box", Box{{0.02, 0.2, 0.02}}, {{0.17, 0.07, 0.01}});
  box.frame = "arm";
  simulation.apply(box);
  simulation.apply(obstacle(
      "roller", Cylinder{0.01, 0.2},
      {{0.07, 0.07, 0.05}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vector3::UnitX()))}));
  simulation.fold({Segment{Vector2(0.05, 0), Vector2(0.05, kSide)}, 0.8, 0.5, {}, "", 0});
  simulation.apply(MoveObstacleEdit{"roller", {{0.07, 0.07, 0.012}}, 0.5});
  return simulation;
}

void moveScene(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    simulation.carry("arm", {{-0.2 * simulation.time(), 0, 0}});
    ASSERT_TRUE(simulation.step().converged);
  }
}

TEST(Obstacles, GoOnToTheBitFromASnapshot) {
  Simulation simulation = busyScene();
  moveScene(simulation, 15);
  ASSERT_FALSE(simulation.contacts().empty());
  const auto json = nlohmann::json::to_cbor(toJson(simulation.snapshot()));
  Simulation again(snapshotFrom(nlohmann::json::from_cbor(json)));
  EXPECT_EQ(toJson(again.obstacles()), toJson(simulation.obstacles()));
  moveScene(simulation, 15);
  moveScene(again, 15);
  EXPECT_TRUE(again.positions() == simulation.positions());
  EXPECT_EQ(again.counters().newton_iterations, simulation.counters().newton_iterations);
}

TEST(Obstacles, TheSameScenesAreTheSameToTheBit) {
  Simulation first = busyScene(), second = busyScene();
  moveScene(first, 30);
  moveScene(second, 30);
  EXPECT_TRUE(first.positions() == second.positions());
}

TEST(Obstacles, OfASnapshotThatIsBrokenAreRejected) {
  const nlohmann::json whole = toJson(busyScene().snapshot());
  const std::vector<std::pair<std::string, nlohmann::json>> changes{
      {"/obstacles/pace", 2},
      {"/obstacles/all/box/friction", -1},
      {"/obstacles/all/box/shape", {{"cone", 1}}},
      {"/obstacles/all/box/base/position", {0, 0}},
      {"/obstacles/all/roller/left", nullptr},
  };
  for (const auto& [place, value] : changes) {
    nlohmann::json broken = whole;
    broken[nlohmann::json::json_pointer(place)] = value;
    EXPECT_THROW(snapshotFrom(broken), std::invalid_argument) << place;
  }
}

}  // namespace
}  // namespace shell_origami
