/// What tears at paper: it ends finite, whole, and where it can, at rest.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;
constexpr double kDegree = M_PI / 180;

Simulation square(const SimulationConfig& config, double max_edge = 0.015) {
  return Simulation(Sheet(triangulateRectangle(kSide, kSide, max_edge)), config);
}

FoldEdit diagonal(double angle, double duration) {
  FoldEdit request;
  request.where = Segment{Vector2(0, 0), Vector2(kSide, kSide)};
  request.angle = angle;
  request.duration = duration;
  return request;
}

void expectWhole(const Simulation& simulation) {
  ASSERT_TRUE(simulation.positions().allFinite());
  ASSERT_TRUE(simulation.velocities().allFinite());
  const auto& flat = simulation.sheet().flatPositions();
  for (const Triangle& t : simulation.sheet().triangles()) {
    const Vector3 a = simulation.positions().col(t[0]), b = simulation.positions().col(t[1]),
                  c = simulation.positions().col(t[2]);
    ASSERT_GT((b - a).cross(c - a).norm(), 0.05 * doubleArea(flat[t[0]], flat[t[1]], flat[t[2]]));
  }
  for (const CreaseStatus& crease : simulation.creases()) {
    ASSERT_LT(std::abs(crease.angle), M_PI);
  }
}

/// Steps for this long; returns whether every one held.
bool run(Simulation& simulation, double seconds) {
  const double end = simulation.time() + seconds;
  while (simulation.time() < end) {
    if (!simulation.step().converged) return false;
  }
  return true;
}

TEST(StepsThatHold, AFoldInNoTimeOrTenMilliseconds) {
  for (const double duration : {0.0, 0.01}) {
    for (const double thickness : {1e-5, 1e-4, 1e-3}) {
      SCOPED_TRACE(testing::Message() << duration << " s, " << thickness << " m");
      SimulationConfig config;
      config.material.thickness = thickness;
      Simulation simulation = square(config);
      simulation.fold(diagonal(170 * kDegree, duration));
      EXPECT_TRUE(run(simulation, 2));
      expectWhole(simulation);
      // A crease turns what it is stiff enough for: thick paper is heavier, not stiffer to turn.
      EXPECT_NEAR(simulation.creases()[0].angle / kDegree, 170, thickness > 5e-4 ? 175 : 20);
    }
  }
}

TEST(StepsThatHold, AHundredTimesGravity) {
  for (const double thickness : {1e-5, 1e-4, 1e-3}) {
    SCOPED_TRACE(thickness);
    SimulationConfig config;
    config.material.thickness = thickness;
    config.gravity = {0, 0, -981};
    Simulation simulation = square(config);
    simulation.pin(Region{{{0, 0}, {0.02, 0}, {0.02, kSide}, {0, kSide}}});
    run(simulation, 1);
    expectWhole(simulation);
    EXPECT_LT(simulation.positions().row(2).minCoeff(), -0.01);
  }
}

TEST(StepsThatHold, APinnedVertexYankedByFiveCentimetresInOneStep) {
  for (const Vector3& way : {Vector3(0, 0, 0.05), Vector3(0, -0.05, 0), Vector3(0.05, 0.05, 0)}) {
    Simulation simulation = square({});
    const int corner = simulation.pin(std::vector<Vector2>{{0, 0}}, "hand", {})[0];
    run(simulation, 0.1);
    const Vector3 there = simulation.positions().col(corner) + way;
    simulation.carry("hand", Pose{way});
    const Positions before = simulation.positions();
    const StepReport report = simulation.step();
    expectWhole(simulation);
    if (report.converged) EXPECT_LT((simulation.positions().col(corner) - there).norm(), 1e-12);
    else EXPECT_EQ(simulation.positions(), before);
    EXPECT_TRUE(run(simulation, 0.5));
    expectWhole(simulation);
  }
}

TEST(StepsThatHold, AHeldSheetPulledApartGivesUpAndSaysWhere) {
  // Both ends held, one carried far through the other: no such paper.
  Simulation simulation = square({});
  simulation.pin(Region{{{0.14, 0}, {kSide, 0}, {kSide, kSide}, {0.14, kSide}}}, "hand", {});
  simulation.pin(Region{{{0, 0}, {0.01, 0}, {0.01, kSide}, {0, kSide}}});
  simulation.carry("hand", Pose{Vector3(1000, 0, 0)});
  const Positions before = simulation.positions();
  const StepReport report = simulation.step();
  expectWhole(simulation);
  if (!report.converged) {
    EXPECT_EQ(simulation.positions(), before);
    EXPECT_NE(report.failure.find("of the flat sheet"), std::string::npos) << report.failure;
  }
  EXPECT_TRUE(run(simulation, 0.1));
}

TEST(StepsThatHold, SettlesAtOnceWhereTimeWouldTakeIt) {
  SimulationConfig config;
  config.gravity = {0, 0, -9.81};
  const auto make = [&config] {
    Simulation simulation = square(config);
    simulation.pin(Region{{{0, 0}, {0.02, 0}, {0.02, kSide}, {0, kSide}}});
    FoldEdit fold;
    fold.where = Segment{Vector2(0.08, 0), Vector2(0.08, kSide)};
    fold.angle = 60 * kDegree;
    fold.duration = 0.2;
    simulation.fold(fold);
    while (simulation.folding()) simulation.step();
    return simulation;
  };
  Simulation at_once = make(), in_time = make();
  const double time = at_once.time();
  const StepReport report = at_once.settle();
  ASSERT_TRUE(report.converged) << report.failure;
  EXPECT_EQ(at_once.time(), time);
  EXPECT_TRUE(at_once.settled());
  run(in_time, 10);
  EXPECT_LT((at_once.positions() - in_time.positions()).colwise().norm().maxCoeff(), 1e-3 * kSide);
}

/// A strip is bent double between its two ends, pressed together, and let go.
double openingAfterPressing(double yield_curvature) {
  SimulationConfig config;
  config.material.yield_curvature = yield_curvature;
  Simulation strip(Sheet(triangulateRectangle(0.12, 0.02, 0.006)), config);
  strip.pin(Region{{{0, 0}, {0.01, 0}, {0.01, 0.02}, {0, 0.02}}});
  const std::vector<int> hand =
      strip.pin(Region{{{0.11, 0}, {0.12, 0}, {0.12, 0.02}, {0.11, 0.02}}}, "hand",
                Pose{Vector3(0.06, 0, 0)});
  // The hand turns its end over and lays it 4 mm above the other.
  constexpr int kSteps = 90;
  for (int i = 1; i <= kSteps; ++i) {
    const double s = static_cast<double>(i) / kSteps;
    const Eigen::AngleAxisd turn(-M_PI * s, Vector3::UnitY());
    strip.carry("hand", {Vector3(0.06, 0, 0.004 * s), Eigen::Quaterniond(turn)});
    EXPECT_TRUE(strip.step().converged);
  }
  strip.unpin(std::vector<std::int64_t>(hand.begin(), hand.end()));
  run(strip, 3);
  // The direction of the free end against the held one.
  const Vector3 tip = strip.positions().col(strip.sheet().nearestVertex({0.12, 0.01})),
                inner = strip.positions().col(strip.sheet().nearestVertex({0.11, 0.01}));
  return std::acos((tip - inner).normalized().x()) / kDegree;
}

TEST(InelasticPaper, PressedTogetherAndLetGoItKeepsABend) {
  EXPECT_LT(openingAfterPressing(0), 3);
  const double kept = openingAfterPressing(30);
  EXPECT_GT(kept, 40);
  EXPECT_LT(kept, 180);
}

}  // namespace
}  // namespace shell_origami
