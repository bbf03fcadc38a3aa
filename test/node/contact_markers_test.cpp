// Contact is drawn: the pressure of layers as colors and as a text, and the points at which they
// touch.
#include "test/node/drawn.h"

#include <limits>

namespace shell_origami {
namespace {

/// Flat paper whose vertices right of `from` press with the pressure.
Drawn pressed(double pressure, double from = 0) {
  Drawn drawn(paper(), flat);
  for (const auto& p : drawn.sheet.flat_positions) {
    drawn.state.pressures.push_back(p.x >= from ? static_cast<float>(pressure) : 0);
  }
  return drawn;
}

TEST(Coloring, PressureIsRedOnBothSides) {
  for (const double part : {0.0, 0.25, 0.5, 1.0, 7.0}) {
    const Drawn drawn = pressed(part * SheetColours::kFullPressure);
    for (const char* side : {"front", "back"}) {
      expectColour(drawn.colours(Coloring::kContact, side), part, 1e-6);
    }
  }
  EXPECT_GT(redness(pressed(SheetColours::kFullPressure).colours(Coloring::kContact)[0]), 0.7);
}

TEST(Coloring, PressureIsShownWhereItIs) {
  const Drawn drawn = pressed(SheetColours::kFullPressure, kWidth / 2);
  const auto colours = drawn.colours(Coloring::kContact);
  ASSERT_EQ(colours.size(), drawn.sheet.triangles.size());
  for (std::size_t i = 0; i < colours.size(); ++i) {
    double mean = 0;
    for (const std::uint32_t v : drawn.sheet.triangles[i].vertex_indices) {
      mean += drawn.state.pressures[v] / SheetColours::kFullPressure / 3;
    }
    EXPECT_NEAR(redness(colours[i]), redness(mean), 1e-6);
  }
}

TEST(Coloring, PressuresThatWereNotRecordedLeaveThePaperItsColours) {
  const Drawn drawn(paper(), flat);
  EXPECT_EQ(drawn.colours(Coloring::kContact), drawn.colours(Coloring::kPaper));
  EXPECT_FALSE(drawn.colours(Coloring::kContact) == pressed(0).colours(Coloring::kContact));
}

TEST(Coloring, PressuresOfAnotherSheetDoNotFit) {
  Drawn drawn = pressed(1);
  MarkerPainter painter({}, Coloring::kContact);
  painter.setSheet(drawn.sheet);
  EXPECT_TRUE(painter.fits(drawn.state));
  drawn.state.pressures.pop_back();
  EXPECT_FALSE(painter.fits(drawn.state));
}

TEST(Labels, ThePressureIsTold) {
  EXPECT_TRUE(inNamespace(pressed(240).draw(), "pressure").empty());
  const auto told = [](const Drawn& drawn) {
    return inNamespace(drawn.draw({}, Coloring::kContact), "pressure").at(0);
  };
  EXPECT_EQ(told(pressed(240, kWidth / 2)).text, "pressed with up to 240 Pa, red from 500 Pa");
  EXPECT_EQ(told(pressed(0)).text, "pressed with up to 0 Pa, red from 500 Pa");
  EXPECT_EQ(told(Drawn(paper(), flat)).text, "no pressures are recorded");
  EXPECT_GT(told(pressed(240)).pose.position.z, 0);
}

/// Flat paper with contact points of these forces in a row [N].
Drawn touching(const std::vector<double>& forces) {
  Drawn drawn(paper(), flat);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    drawn.state.contact_points.emplace_back();
    drawn.state.contact_points.back().position =
        Drawn::point({0.01 * static_cast<double>(i), 0.02, 0.03});
    drawn.state.contact_points.back().force.z = forces[i];
  }
  return drawn;
}

TEST(ContactPoints, AreBallsOnDemandTheDarkerTheHarderTheyPush) {
  constexpr double kFull = MarkerPainter::kFullForce;
  const Drawn drawn = touching({0, kFull / 2, kFull, 3 * kFull});
  EXPECT_EQ(inNamespace(drawn.draw(), "contact_points").at(0).action, Marker::DELETE);
  const Marker balls = inNamespace(drawn.draw({false, false, true}), "contact_points").at(0);
  EXPECT_EQ(balls.action, Marker::ADD);
  EXPECT_EQ(balls.type, Marker::SPHERE_LIST);
  ASSERT_EQ(balls.points.size(), 8u);
  ASSERT_EQ(balls.colors.size(), 8u);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &below = balls.points[2 * i], &above = balls.points[2 * i + 1];
    for (const auto& p : {below, above}) {
      EXPECT_NEAR(p.x, 0.01 * static_cast<double>(i), 1e-6);
      EXPECT_NEAR(p.y, 0.02, 1e-6);
    }
    EXPECT_NEAR((below.z + above.z) / 2, 0.03, 1e-6);
    EXPECT_NEAR(above.z - below.z, i == 0 ? 0 : 2 * kWidth / 150, 1e-6);
    EXPECT_EQ(balls.colors[2 * i], balls.colors[2 * i + 1]);
    EXPECT_EQ(balls.colors[2 * i].a, 1);
  }
  EXPECT_GT(balls.colors[0].g, balls.colors[2].g + 0.3);
  EXPECT_GT(balls.colors[2].g, balls.colors[4].g + 0.3);
  EXPECT_EQ(balls.colors[4], balls.colors[6]);
}

TEST(ContactPoints, OfNonsenseHaveColors) {
  const Drawn drawn = touching({std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300});
  const Marker balls = inNamespace(drawn.draw({false, false, true}), "contact_points").at(0);
  EXPECT_EQ(balls.colors.size(), 6u);
  for (const auto& c : balls.colors) {
    EXPECT_TRUE(c.r >= 0 && c.r <= 1 && c.g >= 0 && c.g <= 1 && c.b >= 0 && c.b <= 1);
  }
}

TEST(ContactPoints, PaperThatTouchesNothingHasNone) {
  const MarkerArray drawn = touching({}).draw({false, false, true});
  EXPECT_EQ(inNamespace(drawn, "contact_points").at(0).action, Marker::DELETE);
}

}  // namespace
}  // namespace shell_origami
