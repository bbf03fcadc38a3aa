/// Miura-ori, the waterbomb base and the apple's cone against their closed forms.
#include "verify/folding.h"

#include "origami/recipe.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

/// The recipe's sheet, coarse and flat, with nothing done to it yet.
Simulation fromRecipe(const std::string& name) {
  const Recipe recipe =
      loadRecipe("../recipes/" + name + ".yaml", {}, {}, {{"sheet/max_edge", "0.025"}});
  SimulationConfig config = recipe.config;
  config.solver.tolerance = quasiStatic().solver.tolerance;
  return makeSimulation(recipe.sheet, config);
}

void stepUntil(Simulation& simulation, double time) {
  while (simulation.time() < time) {
    const StepReport report = simulation.step();
    ASSERT_TRUE(report.converged) << report.failure;
  }
}

/// Folds to the angles one after the other and rests at each.
template <class Check>
void foldThrough(Simulation& simulation, const std::vector<std::pair<std::string, double>>& creases,
                 const std::vector<double>& degrees, Check check) {
  for (const double angle : degrees) {
    for (const auto& [name, sign] : creases) {
      simulation.fold(foldCrease(name, sign * angle * kDegree, 1.5));
    }
    stepUntil(simulation, simulation.time() + 3.5);
    SCOPED_TRACE(testing::Message() << "at " << angle << " degrees");
    check(angle * kDegree);
  }
}

const std::vector<double> kTenStates{15, 30, 45, 60, 75, 90, 105, 120, 135, 150};

/// Closed form 8 of parallelograms with equal sides and an acute angle q of 60 degrees; the zigzags
/// are the family at 2g. Of an even number of panels each is l long along the rows and s wide across
/// them. `count`: panels along each side of the sheet; `side`: of a panel [m]; `angle`: 2g [rad].
void expectMiura(const Simulation& simulation, int count, double side, double angle) {
  constexpr double q = 60 * kDegree;
  const double g = angle / 2;
  for (const CreaseStatus& crease : simulation.creases()) {
    const bool zigzag = crease.name.rfind("zigzag", 0) == 0;
    const double expected = zigzag ? angle : 2 * std::atan(std::cos(q) * std::tan(g));
    EXPECT_NEAR(std::abs(crease.angle) / expected, 1, 0.01) << crease.name;
  }
  const auto distance = [&](const Vector2& a, const Vector2& b) {
    return (simulation.positions().col(simulation.sheet().nearestVertex(a)) -
            simulation.positions().col(simulation.sheet().nearestVertex(b)))
        .norm();
  };
  const double l = side * std::sqrt(1 - std::pow(std::sin(g) * std::sin(q), 2));
  const double s = side * std::cos(g) * std::tan(q) /
                   std::sqrt(1 + std::pow(std::cos(g) * std::tan(q), 2));
  const int even = count / 2 * 2;
  const Vector2 along(even * side, 0), across(0, even * side * std::sin(q));
  EXPECT_NEAR(distance({0, 0}, along) / (even * l), 1, 0.01);
  EXPECT_NEAR(distance({0, 0}, across) / (even * s), 1, 0.01);
  EXPECT_LT(simulation.maxStrain(), 0.002);
}

TEST(Miura, FoldAnglesLengthAndWidthAtTenStates) {
  Simulation simulation = fromRecipe("miura");
  foldThrough(simulation, {{"zigzag_valley", 1}, {"zigzag_mountain", -1}}, kTenStates,
              [&](double angle) { expectMiura(simulation, 6, 0.025, angle); });
}

TEST(Miura, AThousandCreasesFoldAsSixtyDo) {
  Simulation simulation = fromRecipe("miura_1000");
  EXPECT_EQ(simulation.creases().size(), 1012u);
  foldThrough(simulation, {{"zigzag_valley", 1}, {"zigzag_mountain", -1}}, {40, 80, 120, 150},
              [&](double angle) { expectMiura(simulation, 23, 0.013, angle); });
}

TEST(Waterbomb, MountainFollowsTheValleys) {
  // Closed form 9: tan(rho_M / 2) = -tan(rho_V / 2) / sqrt 2.
  Simulation simulation = fromRecipe("waterbomb");
  foldThrough(simulation, {{"diagonal", 1}}, {15, 30, 45, 60, 75, 90, 105, 120, 135, 150, 165},
              [&](double angle) {
    const double mountain = -2 * std::atan(std::tan(angle / 2) / std::sqrt(2.0));
    for (const CreaseStatus& crease : simulation.creases()) {
      const double expected = crease.name == "diagonal" ? angle : mountain;
      EXPECT_NEAR(crease.angle / kDegree, expected / kDegree, 1) << crease.name;
    }
    EXPECT_LT(simulation.maxStrain(), 0.002);
  });
}

TEST(SixCreases, FoldTheSameWayFastAndSlowly) {
  // Free creases that led the others, if only by a degree, would pop the vertex the wrong way when
  // there is time for it. The preliminary base is the waterbomb's vertex with the four on a cross.
  for (const auto& [name, driven] : {std::pair{"waterbomb", "diagonal"},
                                     std::pair{"preliminary", "cross"}}) {
    for (const double duration : {1.0, 20.0}) {
      Simulation simulation = fromRecipe(name);
      simulation.fold(foldCrease(driven, 90 * kDegree, duration));
      stepUntil(simulation, duration + 2);
      const double follows = -2 * std::atan(std::sqrt(0.5));
      for (const CreaseStatus& crease : simulation.creases()) {
        const double expected = crease.driven ? M_PI / 2 : follows;
        EXPECT_NEAR(crease.angle / kDegree, expected / kDegree, 1) << name << " in " << duration;
      }
    }
  }
}

TEST(Cone, SlopeOfTheApplesBowl) {
  // Closed form 10: a mountain and a valley from one inner point, alpha = 15 degrees apart, folded
  // shut take 2 alpha out of the sheet's 360 degrees around it, and what is left makes a cone of
  // slope near acos(1 - alpha / pi) = 23.7 degrees.
  constexpr double kAlpha = 15 * kDegree, kRadius = 0.06;
  const Sheet sheet = vertexSheet({M_PI / 2 - kAlpha / 2, M_PI / 2 + kAlpha / 2}, {1, -1}, kRadius,
                                  0.006);
  SimulationConfig config;
  Simulation simulation(sheet, config);
  FoldRequest valley = foldCrease("rho0", 176 * kDegree, 2);
  FoldRequest mountain = foldCrease("rho1", -176 * kDegree, 2);
  valley.stiffness = mountain.stiffness = 0.5;
  simulation.fold(valley);
  simulation.fold(mountain);
  stepUntil(simulation, 5);
  EXPECT_TRUE(simulation.settled());
  // The slope of the border's points against the axis that a cone through them has: the normal of
  // the plane that fits the unit vectors from the apex.
  Eigen::MatrixXd directions(0, 3);
  const Vector3 apex = simulation.positions().col(0);
  for (int v = 1; v < simulation.sheet().vertexCount(); ++v) {
    const Vector2& flat = simulation.sheet().flatPositions()[v];
    const double direction = std::atan2(flat.y(), flat.x());
    if (flat.norm() < 0.99 * kRadius || std::abs(direction - M_PI / 2) < 1.5 * kAlpha) continue;
    directions.conservativeResize(directions.rows() + 1, 3);
    directions.row(directions.rows() - 1) =
        (Vector3(simulation.positions().col(v)) - apex).normalized();
  }
  ASSERT_GT(directions.rows(), 40);
  // n . axis = sin(slope) for every ruling n: least squares for axis / sin(slope).
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(directions.rows());
  const Vector3 scaled = directions.colPivHouseholderQr().solve(ones);
  const double slope = std::asin(1 / scaled.norm()) / kDegree;
  std::printf("cone of slope %.2f degrees\n", slope);
  EXPECT_NEAR(slope, std::acos(1 - kAlpha / M_PI) / kDegree, 2);
}

}  // namespace
}  // namespace shell_origami
