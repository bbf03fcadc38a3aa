#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/crease_actuation.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/snapshot.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

FoldRamp ramp(double from, double target, double start, double duration) {
  FoldRamp result;
  result.driven = true;
  result.from = from;
  result.target = target;
  result.start = start;
  result.duration = duration;
  return result;
}

TEST(CreaseActuation, rampsThatStartTogetherFollowTheOneThatGoesFarthest) {
  CreaseActuation creases({ramp(0, 1, 5, 2), ramp(0, -2.5, 5, 2), ramp(0, 2.5, 5, 2),
                           ramp(0.5, 0.1, 5, 2), ramp(0, 3, 5, 1), ramp(0, 3, 4, 2)},
                          0.01);
  creases.synchronize(5);
  const std::vector<FoldRamp>& ramps = creases.ramps();
  EXPECT_EQ(ramps[0].lead_target, -2.5);  // the first of those that go farthest
  EXPECT_EQ(ramps[1].lead_target, -2.5);
  EXPECT_EQ(ramps[2].lead_target, 2.5);  // goes as far: follows itself
  EXPECT_EQ(ramps[3].lead_from, 0.5);    // unfolds, alone
  EXPECT_EQ(ramps[3].lead_target, 0.1);
  EXPECT_EQ(ramps[4].lead_target, 3);  // of another duration
  EXPECT_EQ(ramps[5].lead_target, 0);  // started earlier: left as it was
}

TEST(CreaseActuation, aFoldOfAnotherStiffnessStartsWithTheMomentThatThereIs) {
  Sheet sheet(triangulateRectangle(0.1, 0.1, 0.02));
  makeFoldLine(sheet, {Vector2(0.05, 0), Vector2(0.05, 0.1)}, "", {});
  const Shell shell(sheet, {});
  const double angle = 0.5, rest = 0.8;
  Positions x = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    const double beyond = std::max(0.0, p.x() - 0.05);
    x.col(v) = Vector3(p.x() - beyond * (1 - std::cos(angle)), p.y(), beyond * std::sin(angle));
  }
  ASSERT_NEAR(meanAngle(0, shell, x), angle, 1e-12);
  const double soft = 0.01;
  for (const double stiffness : {soft, 3 * soft, soft / 3}) {
    CreaseActuation creases({rest}, soft, shell, x);
    RestState before = shell.restState(), after = before;
    creases.apply(1, 1, shell, before);
    creases.start(0, 1.5, 1, 1, stiffness, false, shell, x);
    creases.synchronize(1);
    creases.apply(1, 1, shell, after);
    for (int j : shell.creaseHinges()[0]) {
      EXPECT_NEAR(shell.moment(j, angle, after), shell.moment(j, angle, before), 1e-12 * soft)
          << stiffness;
    }
  }
  // A rest angle beyond the largest there is would be needed: the moment is smaller.
  CreaseActuation creases({rest}, soft, shell, x);
  creases.start(0, 1.5, 1, 1, soft / 100, false, shell, x);
  EXPECT_EQ(creases.ramps()[0].from, kLargestRestAngle);
}

TEST(CreaseActuation, aHundredThousandRampsStartTogetherAtOnce) {
  // A comparison of every two would take minutes.
  std::vector<FoldRamp> ramps;
  for (int i = 0; i < 100000; ++i) ramps.push_back(ramp(0, 1 + 1e-5 * i, 0, 1 + i % 3));
  CreaseActuation creases(std::move(ramps), 0.01);
  creases.synchronize(0);
  EXPECT_EQ(creases.ramps()[0].lead_target, creases.ramps()[99999].target);
  EXPECT_EQ(creases.ramps()[1].lead_target, creases.ramps()[99997].target);
}

TEST(CreaseActuation, manyEntriesOfOneStepFoldAsTheirGroup) {
  SheetSource source;
  source.pattern = (std::filesystem::path(__FILE__).parent_path().parent_path() /
                    "data/patterns/16_miura-cp.fold")
                       .string();
  source.scale = 0.15;
  source.max_edge = 0.02;
  Simulation group = makeSimulation(source, {}), entries = makeSimulation(source, {});
  FoldEdit fold;
  fold.angle = 1;
  fold.where = CreaseName{"all"};
  group.fold(fold);
  const std::vector<Crease> creases = entries.sheet().creases();
  ASSERT_GT(creases.size(), 100u);
  for (const Crease& crease : creases) {
    fold.where = CreaseName{crease.name};
    fold.angle = crease.pattern_angle < 0 ? -1 : 1;
    entries.fold(fold);
  }
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(group.step().converged);
    ASSERT_TRUE(entries.step().converged);
  }
  EXPECT_EQ(toJson(group.snapshot()), toJson(entries.snapshot()));
}

}  // namespace
}  // namespace shell_origami
