/// Folds on folded paper: what lines they crease, on which layers, to which side, and what they
/// refuse.
#include <shell_origami/origami/fold_through.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/sheet/fold_line.h>
#include <shell_origami/sheet/rigid_panels.h>
#include "test/origami/squares.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kMiddle = kSide / 2;

Landmark at(double x, double y) { return {Vector2(x, y)}; }

/// A square whose creases have these angles [degrees], and whose panels are flat.
Simulation folded(const std::vector<std::pair<Segment, double>>& folds) {
  Sheet sheet(triangulateRectangle(kSide, kSide, 0.03));
  for (const auto& [line, angle] : folds) makeFoldLine(sheet, line);
  std::vector<double> angles;
  for (const auto& [line, angle] : folds) angles.push_back(angle * kDegree);
  return Simulation(sheet, {}, foldRigidly(sheet, angles), angles);
}

/// Its right half lies on its left half, front on front.
Simulation half(double degrees = 178) {
  return folded({{{Vector2(kMiddle, 0), Vector2(kMiddle, kSide)}, degrees}});
}

FoldThrough fold(const FoldAxiom& axiom, double degrees = 170) {
  FoldThrough fold;
  fold.axiom = axiom;
  fold.angle = degrees * kDegree;
  return fold;
}

/// Somebody who looks at the left half's front.
const Viewpoint kFront{Vector2(0.01, 0.02), true};

std::string refusal(const FoldThrough& fold, const Simulation& paper,
                    const Viewpoint& view = kFront) {
  try {
    planFold(fold, view, paper);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Compares a layer's line, in either direction, and its angle [degrees].
void expectLayer(const LayerFold& layer, const Segment& line, double degrees, double tolerance) {
  const bool same = (layer.line[0] - line[0]).norm() < (layer.line[1] - line[0]).norm();
  EXPECT_LT((layer.line[same ? 0 : 1] - line[0]).norm(), tolerance);
  EXPECT_LT((layer.line[same ? 1 : 0] - line[1]).norm(), tolerance);
  EXPECT_NEAR(layer.angle / kDegree, degrees, 1e-9);
}

struct OnFlatPaper {
  FoldAxiom axiom;
  Segment line;
};

class FlatPaper : public testing::TestWithParam<OnFlatPaper> {};

TEST_P(FlatPaper, IsCreasedWhereTheAxiomSays) {
  const Simulation paper = square();
  FoldThrough request = fold(GetParam().axiom);
  const FoldPlan plan = planFold(request, frontOf(paper.sheet()), paper);
  ASSERT_EQ(plan.layers.size(), 1u);
  expectLayer(plan.layers[0], GetParam().line, 170, 1e-12);
  // Away from the viewer, and seen from behind: a mountain; both: a valley.
  request.behind = true;
  EXPECT_LT(planFold(request, frontOf(paper.sheet()), paper).layers[0].angle, 0);
  const Viewpoint back{kFront.point, false};
  EXPECT_GT(planFold(request, back, paper).layers[0].angle, 0);
}

const Landmark kCenter{LinesMeet{{at(0, 0), at(kSide, kSide), at(kSide, 0), at(0, kSide)}}};
const Vector2 kCorners[4] = {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};

INSTANTIATE_TEST_SUITE_P(
    Axioms, FlatPaper,
    testing::Values(
        OnFlatPaper{BringPoint{at(kSide, 0), at(0, 0)},
                    {Vector2(kMiddle, 0), Vector2(kMiddle, kSide)}},
        OnFlatPaper{BringPoint{{CornerNear{{1, 1}}}, {CornerNear{{-1, -1}}}},
                    {kCorners[1], kCorners[3]}},
        // The lower edge to the left one, and to the upper one, which is parallel.
        OnFlatPaper{BringEdge{{at(0, 0), at(kSide, 0)}, {at(0, 0), at(0, kSide)}},
                    {kCorners[0], kCorners[2]}},
        OnFlatPaper{BringEdge{{at(0, 0), at(kSide, 0)}, {at(kSide, kSide), at(0, kSide)}},
                    {Vector2(0, kMiddle), Vector2(kSide, kMiddle)}},
        OnFlatPaper{FoldAcross{{at(0, 0), at(kSide, 0)}, at(0.05, kSide), at(0, 0)},
                    {Vector2(0.05, 0), Vector2(0.05, kSide)}},
        OnFlatPaper{
            FoldAlong{{Landmark{PartOfWay{{at(0, 0), at(0, kSide)}, 0.25}}, kCenter}, at(0, 0)},
            {Vector2(0, kSide / 4), Vector2(kSide, 3 * kSide / 4)}}));

TEST(FoldThrough, CreasesEveryLayerToItsSide) {
  // The lower corners to the upper ones. Layers at 178 degrees are folded as if they lay exactly on
  // each other.
  const FoldPlan plan = planFold(fold(BringPoint{at(0, 0), at(0, kSide)}), kFront, half());
  ASSERT_EQ(plan.layers.size(), 2u);
  expectLayer(plan.layers[0], {Vector2(0, kMiddle), Vector2(kMiddle, kMiddle)}, 170, 1e-12);
  expectLayer(plan.layers[1], {Vector2(kMiddle, kMiddle), Vector2(kSide, kMiddle)}, -170, 1e-12);
  EXPECT_GT(plan.after.point.y(), kMiddle) << "the viewer looks at what stays";
}

TEST(FoldThrough, FoldsTheTopLayerOrAFlapAlone) {
  // The right edge, which lies on the left one, back to the middle.
  FoldThrough top =
      fold(BringEdge{{at(kSide, 0), at(kSide, kSide)}, {at(kMiddle, 0), at(kMiddle, kSide)}});
  top.layers = FoldLayers::kTop;
  const Segment line{Vector2(0.75 * kSide, 0), Vector2(0.75 * kSide, kSide)};
  const FoldPlan plan = planFold(top, kFront, half());
  ASSERT_EQ(plan.layers.size(), 1u);
  expectLayer(plan.layers[0], line, -170, 1e-12);
  FoldThrough flap = top;
  flap.layers = FoldLayers::kFlap;
  flap.flap = at(0.9 * kSide, kMiddle);
  expectLayer(planFold(flap, kFront, half()).layers.at(0), line, -170, 1e-12);
  FoldThrough both = top;
  both.count = 2;
  EXPECT_EQ(planFold(both, kFront, half()).layers.size(), 2u);
}

TEST(FoldThrough, TurnsAnExistingCreaseFurther) {
  FoldThrough along = fold(FoldAlong{{at(kMiddle, 0), at(kMiddle, kSide)}, at(kSide, kMiddle)}, 50);
  const FoldPlan plan = planFold(along, kFront, half(40));
  // As one line, though the crease has an edge for each triangle beside it.
  ASSERT_EQ(plan.layers.size(), 1u);
  expectLayer(plan.layers[0], {Vector2(kMiddle, 0), Vector2(kMiddle, kSide)}, 90, 1e-9);
  along.angle = 150 * kDegree;
  EXPECT_NE(refusal(along, half(40)).find("would pass 180"), std::string::npos);
}

TEST(FoldThrough, SaysWhyPaperCannotBeFoldedSo) {
  const auto expect = [](const FoldThrough& fold, const Simulation& paper, const char* words) {
    EXPECT_NE(refusal(fold, paper).find(words), std::string::npos)
        << words << ": " << refusal(fold, paper);
  };
  const FoldThrough down = fold(BringPoint{at(0, 0), at(0, kSide)});
  expect(fold(BringPoint{at(0, 0), at(0, 0)}), half(), "at one place");
  expect(fold(BringPoint{at(0, 0), at(kSide, 0)}), half(), "at one place, as they are seen");
  expect(fold(BringPoint{at(-1, 0), at(0, 0)}), half(), "(-1, 0) is off the paper");
  expect(fold(BringPoint{at(std::nan(""), 0), at(0, 0)}), half(), "off the paper");
  expect(fold(FoldAlong{{at(0, 0), at(0.05, kSide)}, at(0, 0)}), half(), "is on the fold");
  const Landmark nowhere{LinesMeet{{at(0, 0), at(0, 1), at(0.1, 0), at(0.1, 1)}}};
  expect(fold(FoldAlong{{nowhere, at(0, 0)}, at(0, 0)}), half(), "are parallel");
  FoldThrough top = down;
  top.layers = FoldLayers::kTop;
  top.count = 3;
  expect(top, half(), "top is 3, but there are 2 layers");
  top.count = 1;
  expect(top, half(), "joined, beyond the fold, to layer 2");
  FoldThrough flap = down;
  flap.layers = FoldLayers::kFlap;
  flap.flap = at(0.01, kSide);
  expect(flap, half(), "not on the side that moves");
  // The lower layer alone, towards the viewer, is held down by the upper one.
  FoldThrough under =
      fold(BringEdge{{at(0, 0), at(0, kSide)}, {at(kMiddle, 0), at(kMiddle, kSide)}});
  under.layers = FoldLayers::kFlap;
  under.flap = at(0, kMiddle);
  expect(under, half(), "stays, and is over one that moves");
  under.behind = true;
  EXPECT_EQ(refusal(under, half()), "");
  const Segment strip{Vector2(0.8 * kSide, 0), Vector2(0.8 * kSide, kSide)};
  expect(down, folded({{strip, 90}}), "stands on edge");
}

TEST(FoldThrough, LeavesAStripThatIsNarrowerThanTriangles) {
  const Simulation paper = square({}, 0.03);
  const Landmark low{PartOfWay{{at(0, 0), at(kSide, 0)}, 0.95}};
  const FoldThrough most = fold(FoldAcross{{at(0, 0), at(kSide, 0)}, low, at(0, 0)});
  const FoldPlan plan = planFold(most, frontOf(paper.sheet()), paper);
  ASSERT_EQ(plan.layers.size(), 1u);
  EXPECT_GT(plan.after.point.x(), 0.95 * kSide);
  EXPECT_TRUE(plan.after.front);
  const FoldThrough all = fold(FoldAcross{{at(0, 0), at(kSide, 0)}, at(kSide, 0), at(0, 0)});
  EXPECT_NE(refusal(all, paper, frontOf(paper.sheet())).find("nothing stays"), std::string::npos);
}

TEST(FoldThrough, RefusesPaperThatIsBentAlongTheFold) {
  Sheet sheet(triangulateRectangle(kSide, kSide, 0.015));
  Positions rolled = flatInSpace(sheet);
  for (Eigen::Index v = 0; v < rolled.cols(); ++v) {
    const double x = rolled(0, v) - kMiddle;
    // A wave across the viewer's direction, along the fold.
    rolled(2, v) = 0.02 * std::cos(3 * M_PI * x / kSide);
    rolled(1, v) += 0.02 * std::cos(3 * M_PI * x / kSide);
  }
  const Simulation paper(sheet, {}, rolled, {});
  const FoldThrough request = fold(BringPoint{at(0, 0), at(0, kSide)});
  EXPECT_NE(refusal(request, paper).find("is bent along the fold"), std::string::npos)
      << refusal(request, paper);
}

}  // namespace
}  // namespace shell_origami
