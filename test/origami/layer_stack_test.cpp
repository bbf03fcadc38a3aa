/// The layers at a place, from the front to the back, and the view from a direction.
#include <shell_origami/origami/layer_stack.h>
#include <shell_origami/sheet/fold_line.h>
#include <shell_origami/sheet/rigid_panels.h>
#include "test/origami/squares.h"

#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

constexpr double kMiddle = kSide / 2;
/// Of the left half.
const Viewpoint kAbove{Vector2(0.01, 0.02), true}, kBelow{Vector2(0.01, 0.02), false};

/// The right half of a square at this angle [degrees] to the left one, which lies in its place.
Simulation half(double degrees) {
  Sheet sheet(triangulateRectangle(kSide, kSide, 0.03));
  makeFoldLine(sheet, {Vector2(kMiddle, 0), Vector2(kMiddle, kSide)});
  const std::vector<double> angles{degrees * kDegree};
  Positions positions = foldRigidly(sheet, angles);
  return Simulation(sheet, {}, positions, angles);
}

TEST(LayerStack, FromTheFrontToTheBack) {
  const Simulation paper = half(178);
  const auto layers = layersAt({Vector2(0.02, 0.05)}, kAbove, paper);
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_NE(layers[0].panel, layers[1].panel);
  EXPECT_EQ(layers[0].depth, 0);
  // The upper layer rises by 2 degrees from the crease, 0.055 m away.
  EXPECT_NEAR(layers[1].depth, 0.055 * std::sin(2 * kDegree), 0.01 * layers[1].depth);
  EXPECT_NEAR((layers[1].flat - Vector2(0.02, 0.05)).norm(), 0, 1e-12);
  EXPECT_NEAR((layers[0].flat - Vector2(kSide - 0.02, 0.05)).norm(), 0, 1e-12);

  const auto behind = layersAt({Vector2(0.02, 0.05)}, kBelow, paper);
  ASSERT_EQ(behind.size(), 2u);
  EXPECT_EQ(behind[0].panel, layers[1].panel);
  EXPECT_NEAR(behind[1].depth, layers[1].depth, 1e-12);
}

/// At a vertex several triangles of a panel meet, and at a crease two panels.
TEST(LayerStack, EachPanelIsThereOnce) {
  const Simulation paper = half(178);
  for (int v = 0; v < paper.sheet().vertexCount(); ++v) {
    const Vector2 place = paper.sheet().flatPositions()[v];
    const auto layers = layersAt({place}, kAbove, paper);
    ASSERT_EQ(layers.size(), 2u) << place.transpose();
    EXPECT_NE(layers[0].panel, layers[1].panel);
  }
  EXPECT_THROW(layersAt({Vector2(0.2, 0)}, kAbove, paper), std::invalid_argument);
}

TEST(LayerStack, AViewFromADirectionIsThatOfItsSide) {
  const Simulation flat = half(0);
  for (const Vector3& from : {Vector3(0.3, 0.2, 2), Vector3(0, 0.5, -1)}) {
    const Viewpoint view = viewFrom(from, flat);
    EXPECT_EQ(view.front, from.z() > 0);
    EXPECT_GT(viewedPaper(view, flat).viewer.dot(from), 0);
  }
  // Folded, the right half shows its back above.
  const Simulation folded = half(178);
  const Viewpoint above = viewFrom(Vector3::UnitZ(), folded);
  EXPECT_GT(viewedPaper(above, folded).viewer.z(), 0);
  EXPECT_EQ(above.front, above.point.x() < kMiddle);
}

TEST(LayerStack, ADirectionAlongThePaperIsRejected) {
  const Simulation flat = half(0);
  for (const Vector3& from : {Vector3(1, 0, 0), Vector3(0, 1, 0.01), Vector3(0, 0, 0),
                              Vector3(0, NAN, 1), Vector3(0, 0, HUGE_VAL)}) {
    EXPECT_THROW(viewFrom(from, flat), std::invalid_argument) << from.transpose();
  }
}

TEST(Landmark, TheNearestPointOfThePaper) {
  const Simulation paper = half(90);  // the right half stands upright
  const auto nearest = [&](double x, double y, double z) {
    return nearestFlatPoint({x, y, z}, paper.sheet(), paper.positions());
  };
  const auto expect = [](const Vector2& found, double x, double y) {
    EXPECT_NEAR((found - Vector2(x, y)).norm(), 0, 1e-12) << found.transpose();
  };
  expect(nearest(0.02, 0.03, 0.001), 0.02, 0.03);
  expect(nearest(kMiddle - 0.001, 0.03, 0.04), kMiddle + 0.04, 0.03);
  expect(nearest(-0.01, -0.02, -0.1), 0, 0);
  expect(nearest(0.2, 0.2, 0.2), kSide, kSide);
  EXPECT_THROW(nearest(0, 0, 1e300), std::invalid_argument);
}

}  // namespace
}  // namespace shell_origami
