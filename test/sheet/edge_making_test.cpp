/// Ten thousand random folds on random sheets: rectangles, an L, a ring, a star.
#include "sheet/fold_line.h"
#include "sheet/mesh_refine.h"
#include "sheet/triangulate.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace shell_origami {
namespace {

using Loop = std::vector<Vector2>;

PlanarGraph outline(const std::vector<Loop>& loops, const std::vector<Vector2>& holes = {}) {
  PlanarGraph graph;
  for (const Loop& loop : loops) {
    const int first = static_cast<int>(graph.points.size()), count = static_cast<int>(loop.size());
    graph.points.insert(graph.points.end(), loop.begin(), loop.end());
    for (int i = 0; i < count; ++i) {
      graph.segments.push_back({first + i, first + (i + 1) % count});
    }
  }
  graph.holes = holes;
  return graph;
}

PlanarGraph ell() {
  return outline({{{0, 0}, {.15, 0}, {.15, .06}, {.06, .06}, {.06, .15}, {0, .15}}});
}

PlanarGraph ring() {
  return outline({{{0, 0}, {.15, 0}, {.15, .15}, {0, .15}},
                  {{.05, .05}, {.05, .1}, {.1, .1}, {.1, .05}}},
                 {{.075, .075}});
}

PlanarGraph star() {
  Loop loop;
  for (int i = 0; i < 10; ++i) {
    const double radius = i % 2 ? 0.04 : 0.09, angle = M_PI * i / 5;
    loop.emplace_back(0.1 + radius * std::cos(angle), 0.1 + radius * std::sin(angle));
  }
  return outline({loop});
}

class RandomFolds {
 public:
  explicit RandomFolds(unsigned seed) : random_(seed) {}

  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  int below(int count) { return static_cast<int>(count * unit()); }

  PlanarGraph sheetOutline() {
    const double width = 0.05 + 0.2 * unit(), height = 0.05 + 0.2 * unit();
    switch (below(4)) {
      case 0: return ell();
      case 1: return ring();
      case 2: return star();
      default: return outline({{{0, 0}, {width, 0}, {width, height}, {0, height}}});
    }
  }
  /// Anywhere on the paper, three times in ten at a vertex.
  Vector2 point(const Sheet& sheet) {
    if (unit() < 0.3) return sheet.flatPositions()[below(sheet.vertexCount())];
    Eigen::AlignedBox2d box;
    for (const Vector2& p : sheet.flatPositions()) box.extend(p);
    for (;;) {
      const Vector2 p = box.min() + Vector2(unit(), unit()).cwiseProduct(box.sizes());
      if (sheet.triangulation().locate(p, 0)) return p;
    }
  }

 private:
  std::mt19937 random_;
};

double borderLength(const Sheet& sheet) {
  double length = 0;
  for (const Edge& edge : sheet.edges()) {
    if (!edge.onBorder()) continue;
    const auto [a, b] = edge.vertices;
    length += (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm();
  }
  return length;
}

double shortestEdge(const Sheet& sheet, const Triangle& t) {
  const auto& p = sheet.flatPositions();
  return std::min({(p[t[0]] - p[t[1]]).norm(), (p[t[1]] - p[t[2]]).norm(),
                   (p[t[2]] - p[t[0]]).norm()});
}

/// Triangles with an angle below 15 degrees that lines do not force. Lines force an angle where
/// they meet at it, and slivers where they or their ends pass closer than a tenth of max_edge.
int unforcedSlivers(const Sheet& sheet, double max_edge) {
  int count = 0;
  for (int t = 0; t < static_cast<int>(sheet.triangles().size()); ++t) {
    if (isSliver(sheet.triangulation(), t, 15 * M_PI / 180) &&
        shortestEdge(sheet, sheet.triangles()[t]) > 0.1 * max_edge) {
      ++count;
    }
  }
  return count;
}

TEST(EdgeMaking, TenThousandRandomFoldsKeepTheSheetWhole) {
  RandomFolds random(11);
  int folds = 0, along_border = 0, in_parts = 0;
  while (folds < 10000) {
    const double max_edge = 0.012 + 0.02 * random.unit();
    Sheet sheet(triangulate(random.sheetOutline(), max_edge));
    const double area = sheet.area(), border = borderLength(sheet);
    const int count = 1 + random.below(12);
    for (int i = 0; i < count; ++i) {
      const Line line{random.point(sheet), random.point(sheet)};
      if ((line[0] - line[1]).norm() < 1e-6) continue;
      ++folds;
      SCOPED_TRACE(testing::Message() << "fold " << folds);
      try {
        const FoldLine made = makeFoldLine(sheet, line);
        in_parts += made.parts > 1;
        ASSERT_FALSE(made.crease_ids.empty());
      } catch (const std::invalid_argument& refusal) {
        ASSERT_STREQ(refusal.what(), "the line runs along the border of the paper");
        ++along_border;
      }
      ASSERT_NO_THROW(sheet.validate());
      ASSERT_NEAR(sheet.area() / area, 1, 1e-12);
      ASSERT_NEAR(borderLength(sheet) / border, 1, 1e-12);
      ASSERT_EQ(unforcedSlivers(sheet, max_edge), 0);
    }
  }
  EXPECT_LT(along_border, folds / 100);
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
