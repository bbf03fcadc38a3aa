#include <shell_origami/rviz/snapping.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/rviz/seen_fold.h>
#include <shell_origami/sheet/fold_line.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;
constexpr double kPixelsPerMeter = 4000;  // 600 pixels for the sheet

/// Looks down on the paper without perspective: the point (0, 0) is in the middle of the view.
Camera fromAbove() {
  const Vector2 size(1200, 1200);
  Eigen::Matrix4d to_clip = Eigen::Matrix4d::Identity();
  to_clip(0, 0) = 2 * kPixelsPerMeter / size.x();
  to_clip(1, 1) = 2 * kPixelsPerMeter / size.y();
  to_clip(2, 2) = -1;
  return {to_clip, size};
}

Vector2 pixelOf(double x, double y) {
  return {600 + kPixelsPerMeter * x, 600 - kPixelsPerMeter * y};
}

/// A square, creased along its diagonal through (0, 0).
class SnappingTest : public testing::Test {
 protected:
  static Sheet creased() {
    Sheet sheet(triangulateRectangle(kSide, kSide, 0.01));
    makeFoldLine(sheet, {Vector2(0, 0), Vector2(kSide, kSide)}, "spine");
    return sheet;
  }
  void SetUp() override { caster.follow(paper.positions()); }
  void fold(double angle) {
    paper.move(foldRigidly(paper.sheet(), {angle}), {angle});
    caster.follow(paper.positions());
  }
  std::optional<Spot> at(const Vector2& pixel, const std::optional<Vector2>& from = {}) const {
    return spotAt(pixel, camera, paper, caster, from);
  }
  Spot found(double x, double y, const std::optional<Vector2>& from = {}) const {
    const auto spot = at(pixelOf(x, y), from);
    EXPECT_TRUE(spot);
    if (!spot) return {};
    EXPECT_LT((paper.flat(spot->place) - spot->flat).norm(), 1e-9);
    return *spot;
  }

  ShownPaper paper{creased()};
  RayCaster caster{paper.sheet().flatPositions(), paper.sheet().triangles()};
  Camera camera = fromAbove();
};

void expectAt(const Spot& spot, SnapKind kind, double x, double y) {
  EXPECT_EQ(spot.kind, kind);
  EXPECT_LT((spot.flat - Vector2(x, y)).norm(), 1e-12) << spot.flat.transpose();
}

TEST_F(SnappingTest, Corners) {
  expectAt(found(0.002, 0.0005), SnapKind::kCorner, 0, 0);
  expectAt(found(0.1485, 0.001), SnapKind::kCorner, kSide, 0);
  EXPECT_EQ(describe(found(0.1485, 0.001), paper), "corner (150.0, 0.0) mm");
}

TEST_F(SnappingTest, ACornerThatIsMissedByPixels) {
  expectAt(found(-0.001, -0.0015), SnapKind::kCorner, 0, 0);
  EXPECT_FALSE(at(pixelOf(-0.003, -0.003)));
}

TEST_F(SnappingTest, Middles) {
  expectAt(found(0.074, 0.001), SnapKind::kMiddle, 0.075, 0);
  const Spot spot = found(0.074, 0.0752);
  expectAt(spot, SnapKind::kMiddle, 0.075, 0.075);
  EXPECT_EQ(describe(spot, paper), "middle of crease spine (75.0, 75.0) mm");
}

TEST_F(SnappingTest, CreasesAndTheOutline) {
  const Spot spot = found(0.0533, 0.0531);
  EXPECT_EQ(spot.kind, SnapKind::kCrease);
  EXPECT_EQ(spot.crease, 0);
  EXPECT_NEAR(spot.flat.x(), 0.0532, 1e-9);
  EXPECT_NEAR(spot.flat.y(), 0.0532, 1e-9);
  const Spot side = found(0.0331, 0.001);
  EXPECT_EQ(side.kind, SnapKind::kOutline);
  EXPECT_NEAR(side.flat.x(), 0.0331, 1e-9);
  EXPECT_NEAR(side.flat.y(), 0, 1e-15);
}

TEST_F(SnappingTest, DirectionsFromTheFirstPoint) {
  const Vector2 from(0.1, 0.02);
  const Spot up = found(0.1012, 0.05, from);
  expectAt(up, SnapKind::kDirection, 0.1, 0.05);
  EXPECT_EQ(up.direction, 90);
  const double slope = std::tan(M_PI / 8);
  const Spot steep = found(0.12, 0.02 + 0.02 * slope + 0.001, from);
  EXPECT_EQ(steep.kind, SnapKind::kDirection);
  EXPECT_EQ(steep.direction, 22.5);
  EXPECT_EQ(found(0.1012, 0.05).kind, SnapKind::kFree) << "without a first point";
}

TEST_F(SnappingTest, WhereADirectionMeetsALine) {
  const Vector2 from(0.1, 0.02);
  expectAt(found(0.1012, 0.099, from), SnapKind::kCrossing, 0.1, 0.1);
  expectAt(found(0.1488, 0.0711, from), SnapKind::kCrossing, kSide, 0.07);
}

TEST_F(SnappingTest, OnlyWhatIsSeenOfFoldedPaper) {
  fold(179 * M_PI / 180);
  // Both of these corners are within reach, one below the other.
  const auto& corners = paper.corners();
  const auto high = [&](int v, int w) { return paper.positions()(2, v) < paper.positions()(2, w); };
  const int above = *std::max_element(corners.begin(), corners.end(), high);
  const Vector2 pixel = camera.pixel(paper.positions().col(above));
  const Vector2 inside = pixel + 5 * (pixelOf(0.075, 0.075) - pixel).normalized();
  const Spot spot = at(inside).value();
  EXPECT_EQ(spot.kind, SnapKind::kCorner);
  EXPECT_EQ(spot.vertex, above);
  EXPECT_EQ(paper.panel(spot.place.triangle),
            paper.panel(caster.cast(camera.ray(inside))->triangle));
}

TEST_F(SnappingTest, TheFoldLiesWhereItIsSeen) {
  LaidFold fold;
  fold.first = found(0.05, 0);
  fold.second = found(0.05, kSide);
  const auto seen = seenFold(fold, paper, {0, 0, 1});
  ASSERT_TRUE(seen);
  EXPECT_LT((seen->normal - Vector3(-1, 0, 0)).norm(), 1e-9) << "the smaller side moves";
  EXPECT_NEAR(seen->moving.x(), 0, 1e-12);
  fold.moving = Vector2(0.1, 0.02);
  EXPECT_LT((seenFold(fold, paper, {0, 0, 1})->normal - Vector3(1, 0, 0)).norm(), 1e-9);
  EXPECT_LT((seenFold(fold, paper, {0, 0, -1})->viewer - Vector3(0, 0, -1)).norm(), 1e-9);
  fold.moving = Vector2(0.0501, 0.02);
  EXPECT_LT(seenFold(fold, paper, {0, 0, 1})->normal.x(), 0) << "too near to say which";
}

TEST_F(SnappingTest, TheGhostIsWhatMoves) {
  LaidFold fold;
  fold.bring = true;
  fold.first = found(0, kSide);
  fold.second = found(0.075, 0.075);
  const auto seen = seenFold(fold, paper, {0, 0, 1});
  ASSERT_TRUE(seen);
  const int moving = paper.panel(fold.first.place.triangle);
  const auto ghost = ghostOf(*seen, paper, {static_cast<std::uint32_t>(moving)}, M_PI / 2);
  double area = 0, top = 0;
  for (std::size_t i = 0; i < ghost.size(); i += 3) {
    area += (ghost[i + 1] - ghost[i]).cross(ghost[i + 2] - ghost[i]).norm() / 2;
    for (std::size_t k = i; k < i + 3; ++k) {
      EXPECT_LT(std::abs(seen->distance(ghost[k])), 1e-9) << "upright over the fold";
      top = std::max(top, ghost[k].z());
    }
  }
  // A corner cut off at half of half a diagonal.
  const double height = kSide * std::sqrt(2.0) / 4;
  EXPECT_NEAR(area, height * height, 1e-9);
  EXPECT_NEAR(top, height, 1e-9);
  EXPECT_TRUE(ghostOf(*seen, paper, {}, 1).empty());
}

}  // namespace
}  // namespace shell_origami
