// Sheets and states made by hand are drawn; what the colours of their triangles tell is looked at.
#include <shell_origami/node/draw/markers.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace shell_origami {
namespace {

constexpr double kWidth = 0.2, kHeight = 0.1;

/// A paper that lies where `place` puts its flat points, as messages have it.
struct Drawn {
  msg::Sheet sheet;
  msg::SheetState state;

  Drawn(const Sheet& paper, const std::function<Vector3(const Vector2&)>& place) {
    state.header.frame_id = "world";
    for (const Vector2& p : paper.flatPositions()) {
      sheet.flat_positions.push_back(point({p.x(), p.y(), 0}));
      state.positions.push_back(point(place(p)));
    }
    for (const Triangle& t : paper.triangles()) {
      sheet.triangles.emplace_back();
      for (int k = 0; k < 3; ++k) {
        sheet.triangles.back().vertex_indices[k] = static_cast<std::uint32_t>(t[k]);
      }
    }
    for (const Crease& crease : paper.creases()) {
      sheet.creases.emplace_back();
      sheet.creases.back().vertices.assign(crease.vertices.begin(), crease.vertices.end());
      state.creases.emplace_back();
    }
  }

  static geometry_msgs::Point32 point(const Vector3& p) {
    geometry_msgs::Point32 result;
    result.x = static_cast<float>(p.x());
    result.y = static_cast<float>(p.y());
    result.z = static_cast<float>(p.z());
    return result;
  }

  /// The colours of a side of the paper.
  std::vector<std_msgs::ColorRGBA> colours(Coloring colouring,
                                           const std::string& side = "front") const {
    MarkerPainter painter(false, colouring);
    painter.setSheet(sheet);
    EXPECT_TRUE(painter.fits(state));
    for (const auto& marker : painter.draw(state).markers) {
      if (marker.ns == side) return marker.colors;
    }
    return {};
  }

  Positions positions() const {
    Positions x(3, state.positions.size());
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
      const auto& p = state.positions[i];
      x.col(static_cast<Eigen::Index>(i)) << p.x, p.y, p.z;
    }
    return x;
  }
};

Sheet paper() { return Sheet(triangulateRectangle(kWidth, kHeight, 0.02)); }

Vector3 flat(const Vector2& p) { return {p.x(), p.y(), 0}; }

/// Turned and shifted, so that the rounding of float32 is met.
Vector3 away(const Vector3& p) {
  const Eigen::AngleAxisd turn(0.7, Vector3(1, 2, 3).normalized());
  return turn * p + Vector3(0.3, -0.2, 0.1);
}

/// How much redder than blue: 0.11 for the back of paper, 1 for red, negative for blue. Light,
/// which makes a colour darker, does not change it.
double redness(const std_msgs::ColorRGBA& c) { return (c.r - c.b) / std::max(c.r, c.b); }

double redness(double value) { return redness(diverging(value)); }

void expectColour(const std::vector<std_msgs::ColorRGBA>& colours, double value, double tolerance) {
  EXPECT_GT(colours.size(), 50u);
  for (const auto& c : colours) EXPECT_NEAR(redness(c), redness(value), tolerance);
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
  for (const Coloring colouring : {Coloring::kStrain, Coloring::kCurvature}) {
    const auto colours = drawn.colours(colouring);
    EXPECT_GT(colours.size(), 50u);
    for (const auto& c : colours) {
      EXPECT_TRUE(c.r >= 0 && c.r <= 1 && c.g >= 0 && c.g <= 1 && c.b >= 0 && c.b <= 1);
    }
  }
}

}  // namespace
}  // namespace shell_origami
