/// Folds across, along and up to slits.
#include <shell_origami/sheet/fold_line.h>
#include "test/mesh/lattice.h"
#include "test/sheet/random_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace shell_origami {
namespace {

/// The square with one slit from (1, 2) to (3, 2), in triangles of 0.3.
Sheet slitSquare() { return read(insideSlit().document(Faces::kNone), 1, 0.3).sheet; }

FoldLine fold(Sheet& sheet, double x0, double y0, double x1, double y1) {
  const double border = borderLength(sheet);
  const FoldLine made = makeFoldLine(sheet, {Vector2(x0, y0), Vector2(x1, y1)}, "line");
  sheet.validate();
  EXPECT_NEAR(sheet.area(), 16, 1e-12);
  EXPECT_NEAR(borderLength(sheet), border, 1e-12);
  EXPECT_EQ(unforcedSlivers(sheet, 0.3), 0);
  return made;
}

TEST(SlitFolds, acrossASlitBothPartsFoldUnderOneName) {
  Sheet sheet = slitSquare();
  const FoldLine made = fold(sheet, 1.7, 0, 2.3, 4);
  EXPECT_EQ(made.parts, 2);
  ASSERT_EQ(sheet.creases().size(), 2u);
  EXPECT_EQ(made.crease_ids.size(), 2u);
  for (const Crease& crease : sheet.creases()) EXPECT_EQ(crease.name, "line");
  EXPECT_NEAR(creaseLength(sheet), std::hypot(0.6, 4), 1e-12);
  const Vector2 &below = sheet.flatPositions()[sheet.creases()[0].vertices.back()],
                &above = sheet.flatPositions()[sheet.creases()[1].vertices.front()];
  EXPECT_LT((below - above).norm(), 1e-12);
  EXPECT_LT((below - Vector2(2, 2)).norm(), 1e-12);
}

TEST(SlitFolds, aLineMayEndOnASlit) {
  for (const double from : {0.0, 4.0}) {
    Sheet sheet = slitSquare();
    const FoldLine made = fold(sheet, 1.6, from, 2.21, 2);
    EXPECT_EQ(made.parts, 1);
    EXPECT_NEAR(creaseLength(sheet), std::hypot(0.61, 2), 1e-12);
    Sheet back = slitSquare();
    EXPECT_EQ(fold(back, 2.21, 2, 1.6, from).parts, 1);
    EXPECT_NEAR(creaseLength(back), std::hypot(0.61, 2), 1e-12);
  }
}

TEST(SlitFolds, whatRunsAlongASlitDoesNotFold) {
  Sheet sheet = slitSquare();
  const FoldLine whole = fold(sheet, 0, 2, 4, 2);
  EXPECT_EQ(whole.parts, 2);
  EXPECT_NEAR(creaseLength(sheet), 2, 1e-12);
  // From, to or beyond the middle of the slit.
  for (const auto& [x0, x1, length] : {std::array<double, 3>{0, 2.05, 1},
                                       {2.05, 0, 1},
                                       {2.05, 4, 1},
                                       {4, 1.95, 1},
                                       {1, 4, 1},
                                       {0, 3, 1}}) {
    Sheet part = slitSquare();
    EXPECT_EQ(fold(part, x0, 2, x1, 2).parts, 1);
    EXPECT_NEAR(creaseLength(part), length, 1e-12);
  }
  // Whichever side of the slit the line's end comes to lie on.
  RandomSheets random(7);
  for (int i = 0; i < 20; ++i) {
    const double x = random.between(1.1, 2.9);
    for (const double from : {0.0, 4.0}) {
      Sheet level = slitSquare(),
            upright =
                read(Lattice().line({2, 1}, {2, 3}, 'C').document(Faces::kNone), 1, 0.3).sheet;
      fold(level, from, 2, x, 2);
      fold(upright, 2, from, 2, x);
      EXPECT_NEAR(creaseLength(level), 1, 1e-12);
      EXPECT_NEAR(creaseLength(upright), 1, 1e-12);
    }
  }
  Sheet same = slitSquare();
  const Sheet before = same;
  EXPECT_THROW(makeFoldLine(same, {Vector2(1.2, 2), Vector2(2.7, 2)}), std::invalid_argument);
  EXPECT_EQ(same.triangles(), before.triangles());
}

TEST(SlitFolds, aLineThroughTheEndOfASlitIsWhole) {
  for (const double x : {0.0, 1.0, 2.0}) {
    Sheet sheet = slitSquare();
    EXPECT_EQ(fold(sheet, x, 0, 2 - x, 4).parts, 1);
    EXPECT_EQ(sheet.creases().size(), 1u);
  }
}

TEST(SlitFolds, aLineThroughACrossOfSlitsGoesOnBeyondIt) {
  Sheet sheet = read(crossOfSlits().document(Faces::kNone), 1, 0.3).sheet;
  EXPECT_EQ(fold(sheet, 0, 0, 4, 4).parts, 2);
  EXPECT_NEAR(creaseLength(sheet), 4 * std::sqrt(2), 1e-12);
  EXPECT_EQ(fold(sheet, 0, 2, 4, 2).parts, 2);
  EXPECT_EQ(fold(sheet, 2, 4, 2, 0).parts, 2);
  EXPECT_NEAR(creaseLength(sheet), 4 * std::sqrt(2) + 4, 1e-12);
}

TEST(SlitFolds, newVerticesStandOnTheirSideOfAnOpenSlit) {
  // The lip below the slit is bent down, the one above it up.
  const auto place = [](const Vector2& p, double side) {
    const double gape = std::max(0.0, 1 - std::abs(p.x() - 2));
    return Vector3(p.x(), p.y(), side * 0.1 * gape * std::max(0.0, 1 - std::abs(p.y() - 2)));
  };
  const auto sideOf = [](const Sheet& sheet, int v) {
    const int t = sheet.triangulation().around(v)[0];
    return sheet.triangulation().centroid(t).y() > 2 ? 1.0 : -1.0;
  };
  RandomSheets random(5);
  for (int i = 0; i < 50; ++i) {
    Sheet sheet = slitSquare();
    Positions space(3, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      space.col(v) = place(sheet.flatPositions()[v], sideOf(sheet, v));
    }
    const Segment line{Vector2(random.between(1.2, 2.8), 0), Vector2(random.between(1.2, 2.8), 4)};
    const Remap remap = makeFoldLine(sheet, line, "", {&space, {}}).remap;
    const Positions after = remap.apply(space, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      const Vector3 expected = place(sheet.flatPositions()[v], sideOf(sheet, v));
      EXPECT_LT((after.col(v) - expected).norm(), 0.01) << sheet.flatPositions()[v].transpose();
    }
  }
}

}  // namespace
}  // namespace shell_origami
