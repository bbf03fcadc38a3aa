/// What every integrator promises, on a small sheet.
#include <shell_origami/dynamics/stepper.h>
#include <shell_origami/energy/shell_potential.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.1;

/// The shell rests as it is; held vertices go by `velocity`.
class Carry : public BoundaryConditions {
 public:
  explicit Carry(Vector3 way, Positions start) : way_(std::move(way)), start_(std::move(start)) {}
  void applyAt(double s, Positions& prescribed) override {
    prescribed = start_.colwise() + s * way_;
  }
  bool constant() const override { return false; }  // tests change the gravity between steps

 private:
  Vector3 way_;
  Positions start_;
};

struct Paper {
  Sheet sheet{triangulateRectangle(kSide, kSide, 0.03)};
  ShellPotential shell;
  Motion motion;

  explicit Paper(const Vector3& gravity = Vector3::Zero(), const Material& material = {})
      : shell(sheet, material, gravity) {
    motion.positions = Positions::Zero(3, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      motion.positions.col(v).head<2>() = sheet.flatPositions()[v];
    }
    motion.velocities = motion.accelerations = Positions::Zero(3, sheet.vertexCount());
  }
  std::vector<bool> allFree() const { return std::vector<bool>(sheet.vertexCount(), true); }
  /// All but one row of the border.
  std::vector<bool> freeAbove(double y) const {
    std::vector<bool> free;
    for (const Vector2& p : sheet.flatPositions()) free.push_back(p.y() > y);
    return free;
  }
};

SolverConfig configOf(IntegratorKind kind) {
  SolverConfig config;
  config.integrator = kind;
  config.time_step = kind == IntegratorKind::kSymplecticEuler ? 1e-6 : 1e-3;
  config.tolerance = 1e-10;
  return config;
}

class AnyIntegrator : public testing::TestWithParam<IntegratorKind> {};

TEST_P(AnyIntegrator, FallsFreelyLikeAStone) {
  const Vector3 gravity(0, 0, -9.81);
  Paper paper(gravity);
  const Positions start = paper.motion.positions;
  paper.motion.accelerations = gravity.replicate(1, start.cols());
  const SolverConfig config = configOf(GetParam());
  Stepper stepper(config);
  stepper.setFree(paper.allFree());
  Carry nothing(Vector3::Zero(), start);
  constexpr int kSteps = 50;
  for (int i = 0; i < kSteps; ++i) {
    ASSERT_TRUE(stepper.step({&paper.shell}, paper.shell.shell().masses(), 0, nothing, paper.motion)
                    .converged);
  }
  // Both Euler methods take the speed at the end of each step: g t (t + dt) / 2.
  const double t = kSteps * config.time_step;
  const double late = GetParam() == IntegratorKind::kNewmark ? 0 : config.time_step;
  const double fall = -9.81 * t * (t + late) / 2;
  EXPECT_LT((paper.motion.positions.row(2).array() - fall).abs().maxCoeff(), 1e-6 * -fall);
  EXPECT_NEAR(paper.motion.velocities.row(2).mean(), -9.81 * t, 1e-6 * 9.81 * t);
}

TEST_P(AnyIntegrator, CarriesHeldVerticesToWhereTheyGo) {
  Paper paper;
  const std::vector<bool> free = paper.freeAbove(1e-6);
  const SolverConfig config = configOf(GetParam());
  Stepper stepper(config);
  stepper.setFree(free);
  const Vector3 way(0, 0, 0.1 * config.time_step);  // at 0.1 m/s
  for (int i = 0; i < 5; ++i) {
    const Positions before = paper.motion.positions;
    Carry lift(way, before);
    ASSERT_TRUE(stepper.step({&paper.shell}, paper.shell.shell().masses(), 0, lift, paper.motion)
                    .converged);
    for (int v = 0; v < paper.sheet.vertexCount(); ++v) {
      if (free[v]) continue;
      EXPECT_EQ(paper.motion.positions.col(v), before.col(v) + way);
      EXPECT_NEAR(paper.motion.velocities(2, v), 0.1, 1e-12);
    }
  }
}

TEST_P(AnyIntegrator, KeepsTheStateOfAStepThatFails) {
  Paper paper;
  SolverConfig config = configOf(GetParam());
  config.max_iterations = 1;
  config.tolerance = 1e-300;
  config.time_step = 0.1;
  Stepper stepper(config);
  stepper.setFree(paper.allFree());
  paper.motion.velocities.setRandom();
  paper.motion.velocities *= 100;
  const Motion before = paper.motion;
  Carry nothing(Vector3::Zero(), before.positions);
  const StepReport report =
      stepper.step({&paper.shell}, paper.shell.shell().masses(), 0, nothing, paper.motion);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.failure.empty());
  EXPECT_GE(report.vertex, 0);
  EXPECT_EQ(report.retries, 10);
  EXPECT_EQ(paper.motion.positions, before.positions);
  EXPECT_EQ(paper.motion.velocities, before.velocities);
  EXPECT_EQ(paper.motion.accelerations, before.accelerations);
}

INSTANTIATE_TEST_SUITE_P(All, AnyIntegrator,
                         testing::Values(IntegratorKind::kNewmark, IntegratorKind::kBackwardEuler,
                                         IntegratorKind::kSymplecticEuler));

TEST(Newmark, ExpectsAsMuchOfTheAccelerationToStayAsLastDid) {
  const Vector3 gravity(0, 0, -9.81);
  for (double part : {-1.0, 0.0, 0.25, 1.0, 3.0}) {
    Paper paper(gravity);
    const Positions start = paper.motion.positions;
    Stepper stepper(configOf(IntegratorKind::kNewmark));
    stepper.setFree(paper.allFree());
    Carry nothing(Vector3::Zero(), start);
    ASSERT_TRUE(stepper.step({&paper.shell}, paper.shell.shell().masses(), 0, nothing, paper.motion)
                    .converged);
    EXPECT_EQ(paper.motion.acceleration_persistence, 1) << "there was no acceleration to keep";
    paper.shell.gravity = part * gravity;
    ASSERT_TRUE(stepper.step({&paper.shell}, paper.shell.shell().masses(), 0, nothing, paper.motion)
                    .converged);
    EXPECT_NEAR(paper.motion.acceleration_persistence, std::clamp(part, 0.0, 1.0), 1e-6) << part;
  }
}

TEST(Integrators, AnExplicitStepAsLongAsAnImplicitOneBlowsUpAndIsTakenInParts) {
  // The stiffest wave of this mesh crosses an edge within some 20 microseconds.
  for (const auto& [dt, holds] : {std::pair{1e-6, true}, {1e-3, false}}) {
    Paper paper;
    SolverConfig config = configOf(IntegratorKind::kSymplecticEuler);
    config.time_step = dt;
    Stepper stepper(config);
    stepper.setFree(paper.allFree());
    paper.motion.positions.row(2) = 1e-5 * Eigen::RowVectorXd::Random(paper.sheet.vertexCount());
    Carry nothing(Vector3::Zero(), paper.motion.positions);
    int retries = 0;
    for (int i = 0; i < 200 && retries == 0; ++i) {
      retries +=
          stepper.step({&paper.shell}, paper.shell.shell().masses(), 0, nothing, paper.motion)
              .retries;
    }
    EXPECT_EQ(retries == 0, holds) << dt;
    EXPECT_TRUE(paper.motion.positions.allFinite());
  }
}

TEST(Relax, PaperHangsWhereDampedMotionTakesIt) {
  const Vector3 gravity(0, 0, -9.81);
  Paper at_once(gravity), in_time(gravity);
  const auto keep = [](const Positions&) {};
  SolverConfig config;
  config.tolerance = 1e-6;
  Stepper stepper(config);
  stepper.setFree(at_once.freeAbove(0.026));
  const StepReport report =
      stepper.relax({&at_once.shell}, at_once.shell.shell().masses(), keep, at_once.motion);
  ASSERT_TRUE(report.converged) << report.failure;
  EXPECT_LT(report.newton_iterations, 100);
  EXPECT_EQ(at_once.motion.velocities.squaredNorm(), 0);

  Carry nothing(Vector3::Zero(), in_time.motion.positions);
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(
        stepper.step({&in_time.shell}, in_time.shell.shell().masses(), 20, nothing, in_time.motion)
            .converged);
  }
  const Positions difference = at_once.motion.positions - in_time.motion.positions;
  const double drop = -in_time.motion.positions.row(2).minCoeff();
  EXPECT_GT(drop, 0.005);
  EXPECT_LT(difference.colwise().norm().maxCoeff(), 1e-3 * drop);
}

TEST(Relax, PaperThatFallsFindsNoEquilibrium) {
  Paper paper({0, 0, -9.81});
  const Positions before = paper.motion.positions;
  Stepper stepper(SolverConfig{});
  stepper.setFree(paper.allFree());
  const StepReport report = stepper.relax(
      {&paper.shell}, paper.shell.shell().masses(), [](const Positions&) {}, paper.motion);
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.failure.find("no equilibrium"), std::string::npos);
  EXPECT_EQ(paper.motion.positions, before);
}

}  // namespace
}  // namespace shell_origami
