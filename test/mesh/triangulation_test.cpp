#include <shell_origami/mesh/triangulation.h>

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace shell_origami {
namespace {

/// Two triangles over the unit square, split along the diagonal 0-2.
Triangulation square() {
  return Triangulation({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

/// Built anew from its points and triangles it must be the same: neighbours and orientation.
void expectConsistent(const Triangulation& mesh) {
  const Triangulation again(mesh.points(), mesh.triangles());
  double area = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    const Triangle& c = mesh.triangles()[t];
    area += doubleArea(mesh.points()[c[0]], mesh.points()[c[1]], mesh.points()[c[2]]) / 2;
    for (int k = 0; k < 3; ++k) {
      const Triangulation::Side side{t, k};
      ASSERT_EQ(mesh.neighbour(side), again.neighbour(side));
      if (mesh.neighbour(side) == Triangulation::kNone) continue;
      const Triangulation::Side back = mesh.opposite(side);
      EXPECT_EQ(mesh.neighbour(back), t);
      EXPECT_EQ(mesh.ends(side)[0], mesh.ends(back)[1]);
      EXPECT_EQ(mesh.ends(side)[1], mesh.ends(back)[0]);
      EXPECT_EQ(mesh.label(side), mesh.label(back));
    }
  }
  EXPECT_NEAR(area, 1, 1e-14);
  for (int v = 0; v < static_cast<int>(mesh.points().size()); ++v) {
    for (int t : mesh.around(v)) EXPECT_EQ(mesh.triangles()[t][mesh.cornerOf(t, v)], v);
  }
}

TEST(Triangulation, RefusesWhatIsNoTriangulation) {
  const std::vector<Vector2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_THROW(Triangulation(points, {{0, 1, 7}}), std::invalid_argument);
  EXPECT_THROW(Triangulation(points, {{0, 2, 1}, {0, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(Triangulation(points, {{0, 1, 2}, {0, 1, 3}}), std::invalid_argument);
  EXPECT_THROW(Triangulation(points, {{0, 1, 2}}), std::invalid_argument);
  EXPECT_THROW(Triangulation({{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}}), std::invalid_argument);
  EXPECT_THROW(Triangulation({{0, 0}, {1, 0}, {NAN, 1}}, {{0, 1, 2}}), std::invalid_argument);
}

TEST(Triangulation, ASplitHandsItsLabelToBothHalves) {
  Triangulation mesh = square();
  mesh.setLabel(*mesh.findSide(0, 2), 5);
  const int m = mesh.splitEdge(*mesh.findSide(2, 0), {0.25, 0.25});
  expectConsistent(mesh);
  EXPECT_EQ(mesh.triangles().size(), 4u);
  EXPECT_EQ(mesh.label(*mesh.findSide(0, m)), 5);
  EXPECT_EQ(mesh.label(*mesh.findSide(m, 2)), 5);
  EXPECT_EQ(mesh.label(*mesh.findSide(m, 1)), Triangulation::kNone);
  EXPECT_FALSE(mesh.onBorder(m));
  EXPECT_TRUE(mesh.onBorder(0));
}

TEST(Triangulation, ABorderEdgeSplitsItsOnlyTriangle) {
  Triangulation mesh = square();
  const int m = mesh.splitEdge(*mesh.findSide(0, 1), {0.5, 0});
  expectConsistent(mesh);
  EXPECT_EQ(mesh.triangles().size(), 3u);
  EXPECT_TRUE(mesh.onBorder(m));
}

TEST(Triangulation, FlipsOnlyUnlabelledConvexInnerEdges) {
  Triangulation mesh = square();
  EXPECT_FALSE(mesh.canFlip(*mesh.findSide(0, 1)));
  mesh.setLabel(*mesh.findSide(0, 2), 0);
  EXPECT_FALSE(mesh.canFlip(*mesh.findSide(0, 2)));
  mesh.setLabel(*mesh.findSide(0, 2), Triangulation::kNone);
  ASSERT_TRUE(mesh.canFlip(*mesh.findSide(0, 2)));
  mesh.flip(*mesh.findSide(0, 2));
  expectConsistent(mesh);
  EXPECT_TRUE(mesh.findSide(1, 3));
  EXPECT_FALSE(mesh.findSide(0, 2));
}

TEST(Triangulation, LocatesPointsAndRefusesThoseOffIt) {
  const Triangulation mesh = square();
  const auto place = mesh.locate({0.75, 0.25}, 0);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->triangle, 0);
  EXPECT_NEAR(place->weights.sum(), 1, 1e-15);
  EXPECT_FALSE(mesh.locate({1.1, 0.5}, 1e-6));
  EXPECT_TRUE(mesh.locate({1 + 1e-9, 0.5}, 1e-6));
}

TEST(Triangulation, StaysConsistentThroughThreeThousandRandomChanges) {
  std::mt19937 random(1);
  Triangulation mesh = square();
  int flips = 0;
  for (int i = 0; i < 3000; ++i) {
    const int t = static_cast<int>(random() % mesh.triangles().size());
    const Triangulation::Side side{t, static_cast<int>(random() % 3)};
    const Triangle c = mesh.triangles()[t];
    const auto& p = mesh.points();
    const auto thin = [&mesh](int triangle) {
      const Triangle& corners = mesh.triangles()[triangle];
      return doubleArea(mesh.points()[corners[0]], mesh.points()[corners[1]],
                        mesh.points()[corners[2]]) < 1e-6;
    };
    // Rounding turns a sliver's halves over.
    if (thin(t) || (mesh.neighbour(side) >= 0 && thin(mesh.neighbour(side)))) continue;
    if (i % 10 == 0) {
      mesh.splitTriangle(t, (p[c[0]] + p[c[1]] + p[c[2]]) / 3);
    } else if (i % 10 == 1) {
      const auto [a, b] = mesh.ends(side);
      mesh.splitEdge(side, p[a] + 0.5 * (p[b] - p[a]));
    } else if (mesh.canFlip(side)) {
      mesh.flip(side);
      ++flips;
    }
  }
  EXPECT_GT(flips, 100);
  expectConsistent(mesh);
}

}  // namespace
}  // namespace shell_origami
