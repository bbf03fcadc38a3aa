/// Manoeuvres: which lines they crease, to which sides, in which phases, and what they refuse.
#include "test/origami/manoeuvres.h"

namespace shell_origami {
namespace {

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

/// A pleat of a strip, seen from its front: towards the viewer, then back.
TEST(PleatFold, FoldsTowardsTheViewerAndBack) {
  PleatFold pleat;
  pleat.fold.axiom = FoldAlong{{at(0.5, 0), at(0.5, 1)}, at(1, 0.3)};
  pleat.back = {at(0.6, 0), at(0.6, 1)};
  ManoeuvrePlan plan = planOf(pleat, square());
  EXPECT_EQ(plan.result.size(), 2u);
  EXPECT_NEAR(angleAt(plan, line(0.5, 0, 0.5, 1)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(0.6, 0, 0.6, 1)), -178, 1e-9);
  pleat.fold.behind = true;
  plan = planOf(pleat, square());
  EXPECT_NEAR(angleAt(plan, line(0.5, 0, 0.5, 1)), -178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(0.6, 0, 0.6, 1)), 178, 1e-9);
}

TEST(PleatFold, GoesThroughLayers) {
  const Simulation paper = folded(tip());
  PleatFold pleat;
  pleat.fold.axiom = BringPoint{at(1, 1), at(0.5, 0.5)};
  // At a right angle to the spine, as the first fold, so that the tip goes on straight.
  pleat.back = {at(0.85, 0.85), at(0.7, 1)};
  const ManoeuvrePlan plan = planOf(pleat, paper);
  EXPECT_EQ(plan.result.size(), 4u);
  EXPECT_LT(closingErrorAfter(plan, paper), 1e-7);
  const double first = angleAt(plan, line(0.75, 0.75, 1, 0.5));
  EXPECT_NEAR(std::abs(first), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(0.75, 0.75, 0.5, 1)), -first, 1e-9) << "the other layer";
  EXPECT_NEAR(angleAt(plan, line(0.85, 0.85, 1, 0.7)), -first, 1e-9) << "and back";
}

TEST(RabbitEar, LaysTwoEdgesOnTheBaseAndTheTipToItsSecondCorner) {
  const RabbitEar ear{at(1, 0), {at(0, 0), at(1, 1)}};
  const ManoeuvrePlan plan = planOf(ear, square());
  // The center of the circle in a triangle with two sides of 1 and a right angle between them.
  const double r = 1 - std::sqrt(0.5);
  EXPECT_EQ(plan.result.size(), 4u);
  EXPECT_NEAR(angleAt(plan, line(1 - r, r, 0, 0)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(1 - r, r, 1, 1)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(1 - r, r, 1, 0)), 178, 1e-9);
  EXPECT_NEAR(angleAt(plan, line(1 - r, r, 1, r)), -178, 1e-9)
      << "on the side of the second corner";
  EXPECT_LT(closingErrorAfter(plan, square()), 1e-7);
}

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
  PleatFold pleat;
  pleat.fold.axiom = FoldAlong{{at(0.5, 0), at(0.5, 1)}, at(1, 0.3)};
  pleat.back = {at(0.4, 0), at(0.4, 1)};
  expect(pleat, square(), "which is not beyond its first fold");
  pleat.back = {at(0.4, 0), at(0.6, 1)};
  expect(pleat, square(), "which is not beyond its first fold");
  pleat.back = {at(0.6, 0), at(0.6, 0)};
  expect(pleat, square(), "at one place");
  const RabbitEar ear{at(1, 0), {at(0, 0), at(1, 1)}};
  expect(RabbitEar{at(1, 0), {at(0, 0), at(0.5, 0)}}, square(), "are on one line");
  expect(RabbitEar{at(1, 0), {at(0, 0), at(0, 1)}}, square(), "is not an edge of the paper");
  expect(ear, folded({{line(0.6, 0, 0.6, 1), 178}}), "the flap is folded between");
}

}  // namespace
}  // namespace shell_origami
