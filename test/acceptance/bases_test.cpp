/// Miura-ori, the waterbomb base and the apple's cone against their closed forms.
#include "verify/rigid_origami.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

/// Folds to the angles one after the other and rests at each.
template <class Check>
void foldThrough(Simulation& simulation, const std::vector<std::pair<std::string, double>>& creases,
                 const std::vector<double>& degrees, Check check) {
  for (const double angle : degrees) {
    foldAndRest(simulation, creases, angle * kDegree);
    SCOPED_TRACE(testing::Message() << "at " << angle << " degrees");
    check(angle * kDegree);
  }
}

/// Largest relative error of rigid folding. Newton's method stops at 1e-5 m/s: a vertex then moves
/// by less than 1.7e-7 m in a step, 7e-6 of the side of a panel of 25 mm.
constexpr double kRigid = 7e-6;

const std::vector<double> kTenStates{15, 30, 45, 60, 75, 90, 105, 120, 135, 150};

/// Closed form 8 of parallelograms with equal sides and an acute angle q of 60 degrees; the zigzags
/// are the family at 2g. Of an even number of panels each is l long along the rows and s wide
/// across them. `count`: panels along each side of the sheet; `side`: of a panel [m]; `angle`: 2g
/// [rad].
void expectMiura(const Simulation& simulation, int count, double side, double angle) {
  const Miura exact{side, side, 60 * kDegree, angle / 2};
  for (const CreaseStatus& crease : simulation.creases()) {
    const bool zigzag = crease.name.rfind("zigzag", 0) == 0;
    const double expected = zigzag ? exact.zigzagAngle() : exact.otherAngle();
    EXPECT_NEAR(std::abs(crease.angle) / expected, 1, kRigid) << crease.name;
  }
  const auto distance = [&](const Vector2& a, const Vector2& b) {
    return (simulation.positions().col(simulation.sheet().nearestVertex(a)) -
            simulation.positions().col(simulation.sheet().nearestVertex(b)))
        .norm();
  };
  const int even = count / 2 * 2;
  const Vector2 along(even * side, 0), across(0, even * side * std::sin(exact.q));
  EXPECT_NEAR(distance({0, 0}, along) / (even * exact.length()), 1, kRigid);
  EXPECT_NEAR(distance({0, 0}, across) / (even * exact.width()), 1, kRigid);
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
  // Two seconds after a fold the paper still swings by some hundredths of a degree.
  foldThrough(simulation, {{"diagonal", 1}}, {15, 30, 45, 60, 75, 90, 105, 120, 135, 150, 165},
              [&](double angle) {
                const double mountain = waterbombMountain(angle);
                for (const CreaseStatus& crease : simulation.creases()) {
                  const double expected = crease.name == "diagonal" ? angle : mountain;
                  EXPECT_NEAR(crease.angle / kDegree, expected / kDegree, 0.05) << crease.name;
                }
                EXPECT_LT(simulation.maxStrain(), 0.002);
              });
}

TEST(SixCreases, FoldTheSameWayFastAndSlowly) {
  // Free creases that led the others, if only by a degree, would pop the vertex the wrong way when
  // there is time for it. The preliminary base is the waterbomb's vertex with the four on a cross.
  for (const auto& [name, driven] :
       {std::pair{"waterbomb", "diagonal"}, std::pair{"preliminary", "cross"}}) {
    for (const double duration : {1.0, 20.0}) {
      Simulation simulation = fromRecipe(name);
      simulation.fold(foldCrease(driven, 90 * kDegree, duration));
      stepUntil(simulation, duration + 2);
      const double follows = waterbombMountain(M_PI / 2);
      for (const CreaseStatus& crease : simulation.creases()) {
        const double expected = crease.driven ? M_PI / 2 : follows;
        EXPECT_NEAR(crease.angle / kDegree, expected / kDegree, 5e-4) << name << " in " << duration;
      }
    }
  }
}

TEST(Cone, SlopeOfTheApplesBowl) {
  // Closed form 10, at alpha = 15 degrees: 23.56 degrees. The pleat's sides are 4 degrees from
  // shut, alpha sin(4 degrees) apart, which changes the slope by a small multiple of the square.
  constexpr double kAlpha = 15 * kDegree, kRadius = 0.06;
  const Simulation simulation = foldedCone(kAlpha, kRadius);
  EXPECT_TRUE(simulation.settled());
  const double slope = measuredConeSlope(simulation, kAlpha, kRadius) / kDegree;
  EXPECT_NEAR(slope, coneSlope(kAlpha) / kDegree,
              4 * std::pow(kAlpha * std::sin(4 * kDegree), 2) / kDegree);
}

}  // namespace
}  // namespace shell_origami
