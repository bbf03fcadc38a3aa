/// Ten thousand random folds on random sheets: rectangles, an L, a ring, a star, one with slits.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>
#include "test/sheet/random_sheets.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

TEST(EdgeMaking, TenThousandRandomFoldsKeepTheSheetWhole) {
  RandomSheets random(11);
  int folds = 0, along_border = 0, too_small = 0, in_parts = 0;
  while (folds < 10000) {
    const double max_edge = random.between(0.012, 0.032);
    Sheet sheet(random.mesh(max_edge));
    const double area = sheet.area(), border = borderLength(sheet);
    const int count = 1 + random.below(12);
    for (int i = 0; i < count; ++i) {
      const Segment line = random.line(sheet);
      ++folds;
      SCOPED_TRACE(testing::Message() << "fold " << folds);
      try {
        const FoldLine made = makeFoldLine(sheet, line);
        in_parts += made.parts > 1;
        ASSERT_FALSE(made.crease_ids.empty());
      } catch (const std::invalid_argument& refusal) {
        const std::string message = refusal.what();
        const bool is_too_small = message.find("the shortest possible is") != std::string::npos;
        ASSERT_TRUE(is_too_small || message == "the line runs along the border of the paper")
            << message;
        ++(is_too_small ? too_small : along_border);
      }
      ASSERT_NO_THROW(sheet.validate());
      ASSERT_NEAR(sheet.area() / area, 1, 1e-12);
      ASSERT_NEAR(borderLength(sheet) / border, 1, 1e-12);
      ASSERT_EQ(unforcedSlivers(sheet, max_edge), 0);
    }
  }
  EXPECT_LT(along_border, folds / 100);
  EXPECT_LT(too_small, folds / 1000);
  EXPECT_GT(in_parts, folds / 50);
}

TEST(EdgeMaking, OverAHoleBothPartsFoldUnderOneName) {
  Sheet sheet(triangulate(ring(), 0.02));
  const FoldLine made = makeFoldLine(sheet, {Vector2(0, 0.07), Vector2(0.15, 0.08)});
  sheet.validate();
  EXPECT_EQ(made.parts, 2);
  ASSERT_EQ(sheet.creases().size(), 2u);
  EXPECT_EQ(sheet.creases()[0].name, sheet.creases()[1].name);
  EXPECT_NE(sheet.creases()[0].id, sheet.creases()[1].id);
  EXPECT_EQ(made.crease_ids.size(), 2u);
}

TEST(EdgeMaking, ALineThroughAReentrantCornerIsWhole) {
  Sheet sheet(triangulate(ell(), 0.02));
  const FoldLine made = makeFoldLine(sheet, {Vector2(0, 0), Vector2(0.06, 0.06)});
  sheet.validate();
  EXPECT_EQ(made.parts, 1);
  // Along the inner border and on into the paper: only the part with paper on both sides folds.
  const FoldLine partly = makeFoldLine(sheet, {Vector2(0.15, 0.06), Vector2(0, 0.06)});
  sheet.validate();
  EXPECT_EQ(partly.parts, 1);
  EXPECT_NEAR(sheet.flatPositions()[partly.vertices.front()].x(), 0.06, 1e-12);
}

TEST(EdgeMaking, CreasesThatNearlyMeetEndInAReasonableMesh) {
  // Two lines at half a degree: their narrow corner is forced, what lies around it is not.
  Sheet sheet(triangulateRectangle(0.15, 0.15, 0.01));
  const std::size_t before = sheet.triangles().size();
  makeFoldLine(sheet, {Vector2(0, 0.05), Vector2(0.15, 0.09)});
  makeFoldLine(sheet, {Vector2(0, 0.05), Vector2(0.15, 0.0914)});
  sheet.validate();
  EXPECT_LT(sheet.triangles().size(), before + 2000);
}

}  // namespace
}  // namespace shell_origami
