#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/compliance.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/snapshot.h>
#include <shell_origami/sheet/rigid_panels.h>

#include "verify/rigid_origami.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace shell_origami {
namespace {

/// A crease pattern of test/data, 0.15 m wide and flat.
Simulation pattern(const std::string& name, const SimulationConfig& config = {}) {
  SheetSource source;
  source.pattern =
      (std::filesystem::path(__FILE__).parent_path().parent_path() / "data/patterns" / name)
          .string();
  source.scale = 0.15;
  source.max_edge = 0.015;
  return makeSimulation(source, config);
}

FoldEdit foldAll(double part) {
  FoldEdit fold;
  fold.where = CreaseName{"all"};
  fold.part = part;
  return fold;
}

void stepUntilSettled(Simulation& simulation) {
  simulation.step();
  while (!simulation.settled() && simulation.time() < 10) {
    ASSERT_TRUE(simulation.step().converged);
  }
}

double worstMiss(const Simulation& simulation) {
  double worst = 0;
  for (const CreaseStatus& crease : simulation.creases()) {
    worst = std::max(worst, std::abs(crease.angle - crease.target_angle));
  }
  return worst;
}

TEST(Compliance, SoftensWhileCreasesFoldAndHardensAfterwards) {
  Compliance compliance;
  EXPECT_FALSE(compliance.soft());
  compliance.start(1000);
  for (int i = 0; i < 11; ++i) compliance.advance(true, 0.01);
  EXPECT_EQ(compliance.level(), 1);
  EXPECT_NEAR(compliance.creaseFactor(), std::pow(1000, 0.25), 1e-12);
  for (int i = 0; i < 49; ++i) compliance.advance(false, 0.01);
  EXPECT_TRUE(compliance.soft());
  for (int i = 0; i < 2; ++i) compliance.advance(false, 0.01);
  EXPECT_FALSE(compliance.soft());
  EXPECT_EQ(compliance.creaseFactor(), 1);
}

TEST(Compliance, IsForFoldsThatRigidPanelsCannotMake) {
  const Degree4Vertex vertex{1.1, 0.8, false};
  const auto start = [&](const std::vector<double>& targets) {
    std::vector<FoldRamp> ramps;
    const double longest = *std::max_element(targets.begin(), targets.end());
    for (const double target : targets) {
      FoldRamp ramp;
      ramp.driven = ramp.of_pattern = true;
      ramp.target = target;
      ramp.lead_target = longest;
      ramp.duration = 1;
      ramps.push_back(ramp);
    }
    return ramps;
  };
  const Sheet sheet = vertex.sheet();
  const auto angles = vertex.angles(1);
  const std::vector<double> compatible(angles.begin(), angles.end());
  EXPECT_EQ(complianceOf({}, sheet, start(compatible), 0), 1);
  std::vector<FoldRamp> ramps = start({1, 1, 1, -1});
  EXPECT_GT(complianceOf({}, sheet, ramps, 0), 1);
  EXPECT_EQ(complianceOf({}, sheet, ramps, 0.5), 1) << "they have started before";
  EXPECT_EQ(complianceOf({1, CompliantRegion::kCreases}, sheet, ramps, 0), 1);
  EXPECT_EQ(complianceOf({50, CompliantRegion::kCreases}, sheet, start(compatible), 0), 50);
  for (FoldRamp& ramp : ramps) ramp.of_pattern = false;
  EXPECT_EQ(complianceOf({}, sheet, ramps, 0), 1) << "lines are folded as true paper";
}

TEST(Compliance, FoldsThePatternOfACraneThatTruePaperCrumples) {
  Simulation crane = pattern("15_crane-cp.fold");
  crane.fold(foldAll(178.0 / 180));
  stepUntilSettled(crane);
  EXPECT_LT(worstMiss(crane), 2 * kDegree);
  EXPECT_LT(crane.maxStrain(), 1e-4);
  EXPECT_EQ(crane.inPlaneSet().worst, 0) << "no layers ask for room";
  std::vector<double> angles;
  for (const Crease& crease : crane.sheet().creases()) angles.push_back(crease.pattern_angle);
  for (int v : innerCreaseVertices(crane.sheet())) {
    EXPECT_LT(closingError(crane.sheet(), v, angles), 0.02);
  }

  SimulationConfig hard;
  hard.compliance.factor = 1;
  Simulation crumpled = pattern("15_crane-cp.fold", hard);
  crumpled.fold(foldAll(178.0 / 180));
  stepUntilSettled(crumpled);
  EXPECT_GT(worstMiss(crumpled), 90 * kDegree);
}

TEST(Compliance, SoftPaperHasNotSettled) {
  Simulation crane = pattern("15_crane-cp.fold");
  FoldEdit fold = foldAll(0.5);
  fold.duration = 0.3;
  crane.fold(fold);
  while (crane.time() < 0.5) ASSERT_TRUE(crane.step().converged);
  EXPECT_FALSE(crane.folding());
  EXPECT_FALSE(crane.settled());
  // Goes on as it was, to the bit.
  Simulation again(snapshotFrom(toJson(crane.snapshot())));
  for (int i = 0; i < 30; ++i) {
    ASSERT_TRUE(crane.step().converged);
    ASSERT_TRUE(again.step().converged);
  }
  EXPECT_EQ(crane.positions(), again.positions());
}

/// A sheet folded in half twice, the second time through both layers, in soft paper.
Simulation foldedTwice() {
  SimulationConfig config;
  config.compliance.factor = 1000;
  config.material.crease_stiffness = 0.1;
  const double side = 0.15, middle = side / 2;
  Simulation paper(Sheet(triangulateRectangle(side, side, 0.02)), config);
  const auto fold = [&](const Vector2& from, const Vector2& to, double degrees, double duration) {
    FoldEdit edit;
    edit.where = Segment{from, to};
    edit.angle = degrees * kDegree;
    edit.duration = duration;
    paper.fold(edit);
  };
  const auto foldAcross = [&](double degrees, double duration) {
    fold({0, middle}, {middle, middle}, degrees, duration);
    fold({middle, middle}, {side, middle}, -degrees, duration);
  };
  fold({middle, 0}, {middle, side}, 0, 0);
  foldAcross(0, 0);
  fold({middle, 0}, {middle, side}, 178, 0.5);
  stepUntilSettled(paper);
  foldAcross(178, 0.5);
  paper.step();
  stepUntilSettled(paper);
  return paper;
}

TEST(Compliance, KeepsTheStretchThatLayersNeed) {
  const Simulation paper = foldedTwice();
  EXPECT_TRUE(paper.crossings().empty());
  EXPECT_LT(worstMiss(paper), 15 * kDegree);
  EXPECT_GT(paper.inPlaneSet().worst, 1e-3);
  EXPECT_LT(paper.inPlaneSet().mean, 1e-3) << "what is needed and no more";
  // The stress that it bears, of the paper as it is set; hardening adds some in its last step.
  EXPECT_LT(paper.maxStrain(), 2 * kInPlaneYield);
}

TEST(Compliance, WhatPaperKeepsSurvivesSnapshotsAndEdits) {
  Simulation paper = foldedTwice();
  Simulation again(snapshotFrom(toJson(paper.snapshot())));
  const InPlaneSet::Size before = paper.inPlaneSet();
  EXPECT_EQ(again.inPlaneSet().worst, before.worst);
  EXPECT_EQ(again.maxStrain(), paper.maxStrain());
  FoldEdit line;
  line.where = Segment{Vector2(0.02, 0), Vector2(0.02, 0.15)};
  line.angle = 0.1;
  for (Simulation* simulation : {&paper, &again}) {
    simulation->fold(line);
    EXPECT_NEAR(simulation->inPlaneSet().mean, before.mean, 0.05 * before.mean);
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(simulation->step().converged);
  }
  EXPECT_EQ(paper.positions(), again.positions());
}

TEST(Compliance, PartsAreOfEachCreasesOwnAngle) {
  Simulation crane = pattern("15_crane-cp.fold");
  crane.fold(foldAll(1));
  double largest = 0;
  for (std::size_t i = 0; i < crane.sheet().creases().size(); ++i) {
    const double asked = crane.sheet().creases()[i].pattern_angle;
    EXPECT_EQ(std::signbit(crane.creases()[i].target_angle), std::signbit(asked));
    largest = std::max(largest, std::abs(crane.creases()[i].target_angle));
  }
  EXPECT_EQ(largest, kLargestRestAngle) << "180 degrees are taken to the limit of creases";
}

TEST(Compliance, GroupsFoldToTheirOwnSide) {
  for (const std::string group : {"mountains", "valleys", "all"}) {
    Simulation crane = pattern("15_crane-cp.fold");
    FoldEdit fold;
    fold.where = CreaseName{group};
    fold.angle = 1;
    const EditRecord record = crane.fold(fold);
    EXPECT_GT(record.crease_ids.size(), 5u);
    for (std::uint32_t id : record.crease_ids) {
      const int i = crane.sheet().creaseIndex(id);
      EXPECT_EQ(crane.creases()[i].target_angle,
                crane.sheet().creases()[i].pattern_angle < 0 ? -1 : 1);
    }
  }
}

TEST(Compliance, RefusesPartsOfNoAngle) {
  const auto refusal = [](Simulation simulation, const FoldEdit& fold) {
    try {
      simulation.fold(fold);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(pattern("15_crane-cp.fold"), foldAll(1.5)).find("part 1.5"), std::string::npos);
  EXPECT_NE(refusal(pattern("15_crane-cp.fold"), foldAll(NAN)).find("part nan"), std::string::npos);
  FoldEdit line;
  line.where = Segment{Vector2(0, 0), Vector2(0.15, 0.15)};
  line.part = 0.5;
  EXPECT_NE(refusal(pattern("15_crane-cp.fold"), line).find("asks for none of a line"),
            std::string::npos);
}

}  // namespace
}  // namespace shell_origami
