// Sheets and states made by hand are drawn: what the colours of their triangles tell, what is
// written beside them, what the ground shows, and when a drawing differs from another.
#include <shell_origami/node/draw/ground.h>
#include <shell_origami/node/draw/marker_publisher.h>
#include <shell_origami/node/view.h>
#include <shell_origami/sheet/fold_line.h>
#include "test/node/drawn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shell_origami {
namespace {

/// Turned and shifted, so that the rounding of float32 is met.
Vector3 away(const Vector3& p) {
  const Eigen::AngleAxisd turn(0.7, Vector3(1, 2, 3).normalized());
  return turn * p + Vector3(0.3, -0.2, 0.1);
}

TEST(Coloring, StretchedPaperIsRedAndSqueezedPaperBlue) {
  for (const double strain : {1e-3, 1e-4, 5e-5, -5e-5, -1e-4, -1e-3}) {
    const Drawn drawn(paper(), [&](const Vector2& p) {
      return away({p.x() * std::sqrt(1 + 2 * strain), p.y(), 0});
    });
    for (const char* side : {"front", "back"}) {
      expectColour(drawn.colours(Coloring::kStrain, side), strain / SheetColours::kFullStrain, 0.1);
    }
    const auto colours = drawn.colours(Coloring::kStrain);
    EXPECT_TRUE(strain > 0 ? redness(colours[0]) > 0.3 : redness(colours[0]) < -0.2) << strain;
  }
}

TEST(Coloring, TheLargerOfStretchAndSqueezeIsShown) {
  const Drawn drawn(
      paper(), [](const Vector2& p) { return Vector3(p.x() * (1 + 4e-5), p.y() * (1 - 1e-4), 0); });
  expectColour(drawn.colours(Coloring::kStrain), -1, 0.1);
}

TEST(Coloring, FlatPaperIsPaleWhereverItLies) {
  for (const Coloring colouring : {Coloring::kStrain, Coloring::kCurvature}) {
    expectColour(Drawn(paper(), flat).colours(colouring), 0, 1e-3);
    const Drawn moved(paper(), [](const Vector2& p) { return away(flat(p)); });
    expectColour(moved.colours(colouring), 0, 0.05);
  }
}

TEST(Coloring, ACylinderShowsItsCurvature) {
  for (const double curvature : {10.0, -10.0}) {
    for (const double direction : {0.0, 0.4, 1.2, 2.5}) {
      const Vector2 along(std::cos(direction), std::sin(direction));
      const Drawn drawn(paper(), [&](const Vector2& p) {
        const double s = along.dot(p);
        const Vector2 level = p + (std::sin(curvature * s) / curvature - s) * along;
        return Vector3(level.x(), level.y(), (1 - std::cos(curvature * s)) / curvature);
      });
      for (const double k : SheetMeasures(drawn.sheet).curvatures(drawn.positions())) {
        EXPECT_NEAR(k / curvature, 1, 0.01) << direction;
      }
      // A valley is blue.
      const double value = -curvature * kWidth / SheetColours::kFullCurvature;
      expectColour(drawn.colours(Coloring::kCurvature), value, 0.02);
    }
  }
}

TEST(Coloring, AFoldIsNoCurvature) {
  Sheet folded = paper();
  makeFoldLine(folded, {Vector2(kWidth / 2, 0), Vector2(kWidth / 2, kHeight)});
  const Drawn drawn(folded, [](const Vector2& p) {
    const double beyond = std::max(0.0, p.x() - kWidth / 2);
    return Vector3(p.x() - beyond, p.y(), beyond);
  });
  expectColour(drawn.colours(Coloring::kCurvature), 0, 1e-2);
  expectColour(drawn.colours(Coloring::kStrain), 0, 0.05);
}

TEST(Coloring, PaperTellsItsSidesApart) {
  const Drawn drawn(paper(), flat);
  for (const auto& c : drawn.colours(Coloring::kPaper, "front")) EXPECT_GT(redness(c), 0.7);
  for (const auto& c : drawn.colours(Coloring::kPaper, "back")) EXPECT_LT(redness(c), 0.2);
}

TEST(Coloring, NonsenseHasColoursToo) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Drawn drawn(paper(), flat);
  drawn.state.positions[0] = Drawn::point({kNan, 0, 0});
  drawn.state.positions[3] = Drawn::point({1e30, -1e30, 1e30});
  auto& degenerate = drawn.sheet.triangles[20].vertex_indices;
  degenerate[1] = degenerate[0];
  drawn.sheet.flat_positions[degenerate[2]] = drawn.sheet.flat_positions[degenerate[0]];
  drawn.state.pressures.assign(drawn.state.positions.size(), 1e30F);
  drawn.state.pressures[0] = static_cast<float>(kNan);
  drawn.state.pressures[3] = -1e30F;
  for (const Coloring colouring : {Coloring::kStrain, Coloring::kCurvature, Coloring::kContact}) {
    const auto colours = drawn.colours(colouring);
    EXPECT_GT(colours.size(), 50u);
    for (const auto& c : colours) {
      EXPECT_TRUE(c.r >= 0 && c.r <= 1 && c.g >= 0 && c.g <= 1 && c.b >= 0 && c.b <= 1);
    }
  }
}

Drawn atHeight(double height) {
  return Drawn(paper(), [height](const Vector2& p) { return Vector3(p.x(), p.y(), height); });
}

TEST(Ground, IsBelowWhatTheSheetReachesWhenItFolds) {
  EXPECT_LT(groundBelow(atHeight(0).positions(), kWidth), -kWidth / 2);
  const Drawn upright(paper(), [](const Vector2& p) { return Vector3(p.y(), 0, p.x()); });
  const double ground = groundBelow(upright.positions(), kWidth);
  EXPECT_LT(ground, 0);
  EXPECT_GT(ground, -kWidth / 10);
}

TEST(Ground, PaperCastsItsShadowThere) {
  Drawn drawn = atHeight(0.1);
  drawn.sheet.ground = -0.25F;
  const Marker shadow = inNamespace(drawn.draw(), "shadow").at(0);
  ASSERT_EQ(shadow.points.size(), 3 * drawn.sheet.triangles.size());
  for (const auto& p : shadow.points) EXPECT_NEAR(p.z, -0.25, 1e-12);
  // The light comes from one side.
  const auto& corner = drawn.state.positions[drawn.sheet.triangles[0].vertex_indices[0]];
  EXPECT_NEAR(shadow.points[0].x, corner.x - 0.35 / 0.9 * 0.35, 1e-6);
}

TEST(Ground, WhatIsBelowItCastsNoShadow) {
  Drawn drawn(paper(),
              [](const Vector2& p) { return Vector3(p.x(), p.y(), p.x() - 0.4 * kWidth); });
  const std::size_t all = 3 * drawn.sheet.triangles.size();
  drawn.sheet.ground = 0;
  const std::size_t above = inNamespace(drawn.draw(), "shadow").at(0).points.size();
  EXPECT_GT(above, all / 3);
  EXPECT_LT(above, 2 * all / 3);
}

TEST(Ground, IsSeenAgainAndAgainByPaperThatFalls) {
  for (const double height : {-0.01, -0.24, -0.26, -0.7, -50.0}) {
    Drawn drawn = atHeight(height);
    drawn.sheet.ground = -0.25F;
    const double ground = groundUnder(drawn.positions(), kWidth, -0.25);
    EXPECT_LT(ground, height);
    EXPECT_GT(ground, height - 4.01 * kWidth);
    EXPECT_NEAR(std::remainder(ground + 0.25, 4 * kWidth), 0, 1e-9);
    EXPECT_EQ(inNamespace(drawn.draw(), "shadow").at(0).action, Marker::ADD) << height;
  }
}

TEST(Ground, LinesAreAtRoundPlacesAroundThePaper) {
  for (const double offset : {0.0, 0.004, 3.0}) {
    const Drawn drawn(paper(),
                      [&](const Vector2& p) { return Vector3(p.x() + offset, p.y() - offset, 0); });
    const Marker grid = groundGrid(drawn.positions(), kWidth, -0.2, {});
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const auto& p : grid.points) {
      EXPECT_NEAR(p.x / 0.05, std::round(p.x / 0.05), 1e-9);
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
    EXPECT_NEAR((low + high) / 2, offset + kWidth / 2, 0.025 + 1e-9);
  }
}

Drawn creased(double angle) {
  Sheet folded = paper();
  makeFoldLine(folded, {Vector2(kWidth / 2, 0), Vector2(kWidth / 2, kHeight)});
  Drawn drawn(folded, flat);
  drawn.sheet.creases.at(0).name = "middle";
  drawn.state.creases.at(0).angle = static_cast<float>(angle);
  return drawn;
}

TEST(Labels, CreasesHaveNamesAndAnglesOnDemand) {
  Drawn drawn = creased(-1.5);
  EXPECT_TRUE(inNamespace(drawn.draw(), "crease_labels").empty());
  EXPECT_EQ(inNamespace(drawn.draw({false, true}), "crease_labels").at(0).text, "middle  -86 deg");
  drawn.sheet.creases[0].name.clear();
  drawn.sheet.creases[0].id = 7;
  EXPECT_EQ(inNamespace(drawn.draw({false, true}), "crease_labels").at(0).text,
            "crease 7  -86 deg");
}

TEST(Labels, WhatIsNoLongerWantedIsDeletedOnce) {
  const Drawn drawn = creased(1);
  MarkerPainter painter({true, true}, Coloring::kPaper);
  painter.setSheet(drawn.sheet);
  const MarkerArray shown = painter.draw(drawn.state);
  EXPECT_EQ(inNamespace(shown, "vertex_ids").size(), drawn.state.positions.size());
  painter.choose({}, Coloring::kPaper);
  const MarkerArray deleted = painter.draw(drawn.state);
  for (const char* name : {"vertex_ids", "crease_labels"}) {
    EXPECT_EQ(inNamespace(deleted, name).size(), inNamespace(shown, name).size());
    for (const Marker& marker : inNamespace(deleted, name))
      EXPECT_EQ(marker.action, Marker::DELETE);
    EXPECT_TRUE(inNamespace(painter.draw(drawn.state), name).empty());
  }
}

TEST(Labels, OverstretchedPaperIsMarked) {
  Drawn drawn(paper(), flat);
  EXPECT_EQ(inNamespace(drawn.draw(), "warning").at(0).action, Marker::DELETE);
  drawn.state.max_strain = 0.12F;
  const Marker warning = inNamespace(drawn.draw(), "warning").at(0);
  EXPECT_EQ(warning.action, Marker::ADD);
  EXPECT_EQ(warning.text, "stretched by 12 %, further than paper bears");
  // As for names, and unlike the paper's orange: in red it could not be read on the front.
  EXPECT_LT(warning.color.r, 0.2);
  drawn.state.soft = true;
  EXPECT_EQ(inNamespace(drawn.draw(), "warning").at(0).action, Marker::DELETE);
}

TEST(Drawing, LooksTheSameWhileNothingMovesByMoreThanTheDistance) {
  const MarkerArray before = creased(1).draw({true, true});
  const auto moved = [&](double way) {
    Drawn drawn = creased(1);
    drawn.state.positions[5].z += static_cast<float>(way);
    return drawn.draw({true, true});
  };
  EXPECT_TRUE(looksTheSame(before, before, 0));
  EXPECT_TRUE(looksTheSame(before, moved(1e-6), 2e-6));
  EXPECT_FALSE(looksTheSame(before, moved(1e-5), 2e-6));
}

TEST(Drawing, LooksDifferentWithOtherColorsTextsAndPins) {
  const MarkerArray before = creased(1).draw({false, true});
  EXPECT_FALSE(looksTheSame(before, creased(1.02).draw({false, true}), 1e-3));
  EXPECT_FALSE(looksTheSame(before, creased(1).draw(), 1e-3));
  Drawn pinned = creased(1);
  pinned.state.pinned = {0};
  EXPECT_FALSE(looksTheSame(before, pinned.draw({false, true}), 1e-3));
  MarkerArray redder = before;
  redder.markers[0].colors[0].r += 0.1F;
  EXPECT_FALSE(looksTheSame(before, redder, 1e-3));
}

TEST(Camera, StaysWhilePaperFoldsAndFollowsItWhenItFalls) {
  CameraTarget target;
  const Vector3 start = target.follow(atHeight(0).positions(), kWidth);
  EXPECT_TRUE(start.isApprox(Vector3(kWidth / 2, kHeight / 2, 0), 1e-6));
  EXPECT_EQ(target.follow(atHeight(-0.03).positions(), kWidth), start);
  for (const double height : {-0.1, -1.0, -50.0}) {
    const Vector3 now = target.follow(atHeight(height).positions(), kWidth);
    EXPECT_NEAR(now.z() - height, 0.2 * kWidth, 1e-5);
    EXPECT_TRUE(now.head<2>().isApprox(start.head<2>()));
  }
  target.forget();
  EXPECT_NEAR(target.follow(atHeight(1).positions(), kWidth).z(), 1, 1e-6);
}

TEST(Camera, StandsWhereTheRecipeSaysOrBySize) {
  EXPECT_NEAR(viewOf(nullptr, 3).distance / viewOf(nullptr, 0.3).distance, 10, 1e-12);
  const Recipe silent = readRecipe({"yaml", "", "steps: []"});
  EXPECT_EQ(viewOf(&silent, 0.3).distance, viewOf(nullptr, 0.3).distance);
  const Recipe pattern = readRecipe({"yaml", "", "sheet: {pattern: crane.fold}"});
  EXPECT_LT(viewOf(&pattern, 0.3).distance, viewOf(nullptr, 0.3).distance);
  const Recipe recipe =
      readRecipe({"yaml", "", "view: {yaw_deg: 90, pitch_deg: 8, distance: 0.7}"});
  EXPECT_EQ(viewOf(&recipe, 0.3).distance, 0.7);
  EXPECT_NEAR(viewOf(&recipe, 0.3).yaw, M_PI / 2, 1e-12);
}

}  // namespace
}  // namespace shell_origami
