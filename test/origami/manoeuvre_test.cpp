/// Manoeuvres: which lines they crease, to which sides, in which phases, and what they refuse.
#include <shell_origami/origami/manoeuvre.h>
#include <shell_origami/origami/precreases.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/sheet/fold_line.h>
#include <shell_origami/sheet/rigid_panels.h>
#include "test/origami/squares.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace shell_origami {
namespace {

/// tan(22.5 degrees): where the bisector of the angle at a flap's tip meets its side.
constexpr double kBisector = 0.41421356237309503;

using Creases = std::vector<std::pair<Segment, double>>;  // angles in degrees

Landmark at(double x, double y) { return {Vector2(x * kSide, y * kSide)}; }
Segment line(double x, double y, double z, double w) {
  return {Vector2(x * kSide, y * kSide), Vector2(z * kSide, w * kSide)};
}

/// The angles that a paper's creases are asked for, those that are to be shut shut altogether.
std::vector<double> exactAngles(const Simulation& paper) {
  std::vector<double> angles;
  for (const CreaseStatus& crease : paper.creases()) {
    const double target = crease.target_angle;
    angles.push_back(std::abs(target) > 3 ? std::copysign(M_PI, target) : target);
  }
  return angles;
}

/// A square with rigid panels whose creases have these angles.
Simulation folded(const Creases& creases) {
  Simulation paper = square();
  for (const auto& [where, degrees] : creases) {
    FoldEdit fold;
    fold.where = where;
    fold.angle = degrees * kDegree;
    fold.duration = 0;
    paper.fold(fold);
  }
  std::vector<double> angles;
  for (const CreaseStatus& crease : paper.creases()) angles.push_back(crease.target_angle);
  return Simulation(paper.sheet(), {}, foldRigidly(paper.sheet(), exactAngles(paper)), angles);
}

/// The preliminary base, its cross valleys.
Creases preliminary() {
  return {{line(0, 0.5, 0.5, 0.5), 178}, {line(0.5, 0.5, 1, 0.5), 178},
          {line(0.5, 0, 0.5, 0.5), 178}, {line(0.5, 0.5, 0.5, 1), 178},
          {line(0, 1, 0.5, 0.5), -178},  {line(0.5, 0.5, 1, 0), -178}};
}

/// The square folded along both diagonals, a triangle of four layers.
Creases twiceAcross() {
  return {{line(0, 0, 0.5, 0.5), 178},
          {line(0.5, 0.5, 1, 1), 178},
          {line(0, 1, 0.5, 0.5), 178},
          {line(0.5, 0.5, 1, 0), -178}};
}

ManoeuvrePlan planOf(const Manoeuvre& manoeuvre, const Simulation& paper) {
  return planManoeuvre(manoeuvre, {}, frontOf(paper.sheet()), paper);
}

std::string refusal(const Manoeuvre& manoeuvre, const Simulation& paper) {
  try {
    planOf(manoeuvre, paper);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The angle that a plan's result gives to a line [degrees]; 1000: it has no such line.
double angleAt(const ManoeuvrePlan& plan, const Segment& line) {
  for (const FoldEdit& fold : plan.result) {
    const Segment made = std::get<Segment>(fold.where);
    for (int k = 0; k < 2; ++k) {
      const double off = (made[k] - line[0]).norm() + (made[1 - k] - line[1]).norm();
      if (off < 1e-9) return fold.angle / kDegree;
    }
  }
  return 1000;
}

/// Whether the creases of the paper, as a plan leaves them, let it lie flat: panels close around
/// every vertex.
double closingErrorAfter(const ManoeuvrePlan& plan, const Simulation& before) {
  Simulation paper(before.snapshot());
  for (FoldEdit fold : plan.result) {
    fold.duration = 0;
    paper.fold(fold);
  }
  const std::vector<double> angles = exactAngles(paper);
  double worst = 0;
  for (int v : innerCreaseVertices(paper.sheet())) {
    worst = std::max(worst, closingError(paper.sheet(), v, angles));
  }
  return worst;
}

TEST(PetalFold, LiftsAFlapOfThePreliminaryBase) {
  const Simulation paper = folded(preliminary());
  const ManoeuvrePlan plan = planOf(PetalFold{at(1, 1)}, paper);
  const double hip = 1 - kBisector / 2;
  EXPECT_NEAR(angleAt(plan, line(1, 1, hip, 0.5)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(1, 1, 0.5, hip)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(1, 0, hip, 0.5)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(0, 1, 0.5, hip)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(hip, 0.5, 0.5, hip)), -178, 1e-9) << "the hinge";
  EXPECT_NEAR(angleAt(plan, line(hip, 0.5, 1, 0.5)), 0, 1e-9) << "unfolds";
  EXPECT_NEAR(angleAt(plan, line(0.5, hip, 0.5, 1)), 0, 1e-9);
  EXPECT_EQ(plan.result.size(), 7u);
  EXPECT_EQ(plan.phases.size(), 1u);
  EXPECT_LT(closingErrorAfter(plan, paper), 1e-7);
}

TEST(SquashFold, OpensAFlapToThePreliminaryBase) {
  // The flap's fold, half a diagonal, comes onto its hinge, half of the other one.
  const Simulation paper = folded(twiceAcross());
  const SquashFold squash{at(0.9, 0.8), at(1, 1), {at(0.5, 0.5), at(1, 0)}};
  const ManoeuvrePlan plan = planOf(squash, paper);
  EXPECT_NEAR(angleAt(plan, line(0.5, 0.5, 1, 1)), 0, 1e-9) << "the fold opens";
  EXPECT_NEAR(std::abs(angleAt(plan, line(0.5, 0.5, 1, 0.5))), 178, 1e-9);
  EXPECT_NEAR(std::abs(angleAt(plan, line(0.5, 0.5, 0.5, 1))), 178, 1e-9);
  EXPECT_EQ(plan.phases.size(), 3u) << "raised, opened, shut";
  EXPECT_LT(closingErrorAfter(plan, paper), 1e-7);
}

// Its two hinges lie on each other, so that either could open.
TEST(SquashFold, OpensTheLayerThatTheFlapsPointIsOn) {
  const Simulation paper = folded(twiceAcross());
  for (const bool first : {true, false}) {
    const SquashFold squash{
        first ? at(0.9, 0.8) : at(0.8, 0.9), at(1, 1), {at(0.5, 0.5), at(1, 0)}};
    const ManoeuvrePlan plan = planOf(squash, paper);
    EXPECT_NEAR(std::abs(angleAt(plan, line(0.5, 0.5, 1, 0))), first ? 0 : 178, 1e-9);
    EXPECT_NEAR(std::abs(angleAt(plan, line(0.5, 0.5, 0, 1))), first ? 178 : 0, 1e-9);
    EXPECT_LT(closingErrorAfter(plan, paper), 1e-7);
  }
}

/// A tip: the square folded along its diagonal, pointed at (1, 1), its spine.
Creases tip() { return {{line(0, 0, 1, 1), -178}}; }

class ReverseFolds : public testing::TestWithParam<bool> {};

TEST_P(ReverseFolds, TurnATipInsideOut) {
  const bool inside = GetParam();
  const Simulation paper = folded(tip());
  const ReverseFold reverse{at(1, 1), FoldAlong{{at(0.6, 0.6), at(1, 0.8)}, at(1, 1)}, inside};
  const ManoeuvrePlan plan = planOf(reverse, paper);
  EXPECT_EQ(plan.phases.size(), 5u) << "loosen, open, halfway, on, tighten";
  EXPECT_NEAR(angleAt(plan, line(1, 1, 0.6, 0.6)), 178, 1e-9) << "the spine turns over";
  // Of the four creases at the bend three are mountains inside; outside, three are valleys.
  EXPECT_NEAR(angleAt(plan, line(0.6, 0.6, 1, 0.8)), inside ? -178 : 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(0.6, 0.6, 0.8, 1)), inside ? -178 : 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(0.6, 0.6, 0, 0)), -178, 1e-9) << "the body keeps its spine";
  EXPECT_LT(closingErrorAfter(plan, paper), 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ReverseFolds, testing::Bool());

TEST(Manoeuvres, SayWhyPaperCannotBeFoldedSo) {
  const auto expect = [](const Manoeuvre& manoeuvre, const Simulation& paper, const char* words) {
    EXPECT_NE(refusal(manoeuvre, paper).find(words), std::string::npos)
        << words << ": " << refusal(manoeuvre, paper);
  };
  const Simulation base = folded(preliminary());
  expect(PetalFold{at(0.5, 0.5)}, base, "is not on the edge of the paper");
  expect(PetalFold{at(2, 0.5)}, base, "is off the paper");
  expect(PetalFold{at(1, 1)}, square(), "no two creases end on the edge");
  Creases open = preliminary();
  open[1].second = 40;
  expect(PetalFold{at(1, 1)}, folded(open), "must be shut first");
  const Simulation across = folded(twiceAcross());
  const SquashFold squash{at(0.9, 0.8), at(1, 1), {at(0.5, 0.5), at(1, 0)}};
  SquashFold changed = squash;
  changed.bring = at(0.8, 0.7);
  expect(changed, across, "is on no fold");
  changed = squash;
  changed.flap = at(0.1, 0.2);
  expect(changed, across, "is on neither of the layers");
  changed = squash;
  changed.onto = {at(0.5, 0.5), at(1, 1)};
  expect(changed, across, "does not come onto the line");
  const FoldAxiom far{FoldAlong{{at(0.2, 0), at(0.2, 1)}, at(0, 0.5)}};
  expect(ReverseFold{at(1, 1), far, true}, folded(tip()), "is not on the side that moves");
  const FoldAxiom near_tip{FoldAlong{{at(0.6, 0.6), at(1, 0.8)}, at(1, 1)}};
  expect(ReverseFold{at(1, 1), near_tip, true}, square(), "parts it into two halves");
}

/// Runs a recipe's text to its end.
Simulation run(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  RecipeRunner runner(readRecipe({"test", "", text}));
  Simulation paper = makeSimulation(runner.recipe().sheet, runner.recipe().config);
  while (runner.update(paper)) {
    const StepReport report = paper.step();
    if (!report.converged) throw std::runtime_error(report.failure);
  }
  if (warnings) *warnings = runner.takeWarnings();
  return paper;
}

double angleOf(const Simulation& paper, const std::string& name) {
  for (const CreaseStatus& crease : paper.creases()) {
    if (crease.name == name) return crease.angle / kDegree;
  }
  throw std::runtime_error("no crease is called " + name);
}

TEST(RecipeSteps, UnfoldTakesTheLastFoldBack) {
  const Simulation paper =
      run("sheet: {size: [0.1, 0.1], max_edge: 0.03}\n"
          "steps:\n"
          "  - fold: [{line: [[0, 0.02], [0.1, 0.02]], angle_deg: 60, name: first}]\n"
          "  - fold_through: {bring: [0, 0.1], to: [0, 0.06], angle_deg: 90, name: second}\n"
          "  - unfold: {step: last}\n"
          "  - settle: {timeout: 3}\n");
  EXPECT_NEAR(angleOf(paper, "first"), 60, 0.5);
  EXPECT_NEAR(angleOf(paper, "second"), 0, 0.5);
}

TEST(RecipeSteps, LoosenChangesAStiffnessAndNoAngle) {
  const std::string sheet =
      "sheet: {size: [0.1, 0.1], max_edge: 0.03}\n"
      "steps:\n"
      "  - fold: [{line: [[0, 0.05], [0.1, 0.05]], angle_deg: 60, name: middle}]\n"
      "  - settle: {timeout: 3}\n";
  for (const char* which : {"middle", "[[0, 0.05], [0.1, 0.05]]"}) {
    const Simulation paper =
        run(sheet + "  - loosen: {creases: [" + which + "], stiffness: 1.0e-4}\n");
    EXPECT_NEAR(angleOf(paper, "middle"), 60, 0.5);
    const Snapshot snapshot = paper.snapshot();
    ASSERT_EQ(snapshot.creases.ramps().size(), 1u);
    EXPECT_EQ(snapshot.creases.ramps()[0].stiffness, 1e-4);
  }
  EXPECT_THROW(run(sheet + "  - loosen: {creases: [none], stiffness: 1}\n"), std::invalid_argument);
  EXPECT_THROW(run(sheet + "  - loosen: {creases: [[[0, 0], [0.1, 0]]], stiffness: 1}\n"),
               std::invalid_argument);
}

TEST(RecipeSteps, AManoeuvreThatFailsIsToldAloud) {
  // Nothing can turn the tip inside out: it is held.
  std::vector<std::string> warnings;
  run("sheet: {size: [0.1, 0.1], max_edge: 0.02}\n"
      "contact: {enabled: false}\n"
      "steps:\n"
      "  - fold: [{line: [[0, 0], [0.1, 0.1]], angle_deg: -178}]\n"
      "  - settle: {timeout: 1}\n"
      "  - pin: {points: [[0.1, 0.1], [0.08, 0.1], [0.1, 0.08], [0.02, 0], [0, 0.02]]}\n"
      "  - reverse: {flap: [0.1, 0.1], through: [[0.06, 0.06], [0.1, 0.08]]}\n"
      "    duration: 1\n",
      &warnings);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("step 4, reverse: crease"), std::string::npos) << warnings[0];
}

TEST(Precreases, AreTheLinesOfAllFoldsOfTheCrane) {
  const Recipe recipe = loadRecipe("../recipes/crane.yaml");
  const std::vector<FoldEdit> lines = precreasesOf(recipe);
  for (const FoldEdit& fold : lines) EXPECT_EQ(fold.angle, 0);
  const double side = recipe.sheet.width;
  // Of the neck, as folding in coordinates gives them (H and the four layers of its W0 half).
  const double expected[4][4] = {{0.646446610, 0.353553390, 0.592253422, 0.272447553},
                                 {0.592253422, 0.272447553, 0.538060234, 0.191341716},
                                 {0.538060234, 0.191341716, 0.519030117, 0.095670858},
                                 {0.519030117, 0.095670858, 0.5, 0}};
  for (const auto& e : expected) {
    const Vector2 a(e[0] * side, e[1] * side), b(e[2] * side, e[3] * side);
    const bool there = std::any_of(lines.begin(), lines.end(), [&](const FoldEdit& fold) {
      const Segment made = std::get<Segment>(fold.where);
      return std::min((made[0] - a).norm() + (made[1] - b).norm(),
                      (made[1] - a).norm() + (made[0] - b).norm()) < 1e-7;
    });
    EXPECT_TRUE(there) << e[0] << ", " << e[1];
  }
}

TEST(Precreases, RefuseToCountLayers) {
  try {
    precreasesOf(
        readRecipe({"test", "",
                    "sheet: {size: [0.1, 0.1], max_edge: 0.05}\nprecrease: true\nsteps:\n"
                    "  - fold_through: {bring: [0, 0], to: [0.1, 0.1]}\n"
                    "  - fold_through: {bring: [0.1, 0], to: [0, 0.1], layers: {top: 1}}\n"}));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "precrease, step 2: which layers are at the top is not known before the paper is "
                 "folded: use flap");
  }
}

}  // namespace
}  // namespace shell_origami
