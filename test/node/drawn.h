/// \file
/// Sheets and states made by hand, as messages have them, and what is drawn of them.
#pragma once

#include <shell_origami/node/draw/markers.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/sheet.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace shell_origami {

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
    MarkerPainter painter({}, colouring);
    painter.setSheet(sheet);
    EXPECT_TRUE(painter.fits(state));
    for (const auto& marker : painter.draw(state).markers) {
      if (marker.ns == side) return marker.colors;
    }
    return {};
  }

  visualization_msgs::MarkerArray draw(const MarkerOptions& options = {},
                                       Coloring colouring = Coloring::kPaper) const {
    MarkerPainter painter(options, colouring);
    painter.setSheet(sheet);
    return painter.draw(state);
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

inline Sheet paper() { return Sheet(triangulateRectangle(kWidth, kHeight, 0.02)); }

inline Vector3 flat(const Vector2& p) { return {p.x(), p.y(), 0}; }

/// How much redder than blue: 0.11 for the back of paper, 1 for red, negative for blue. Light,
/// which makes a colour darker, does not change it.
inline double redness(const std_msgs::ColorRGBA& c) { return (c.r - c.b) / std::max(c.r, c.b); }

inline double redness(double value) { return redness(diverging(value)); }

inline void expectColour(const std::vector<std_msgs::ColorRGBA>& colours, double value,
                         double tolerance) {
  EXPECT_GT(colours.size(), 50u);
  for (const auto& c : colours) EXPECT_NEAR(redness(c), redness(value), tolerance);
}

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

inline std::vector<Marker> inNamespace(const MarkerArray& array, const std::string& name) {
  std::vector<Marker> result;
  for (const Marker& marker : array.markers) {
    if (marker.ns == name) result.push_back(marker);
  }
  return result;
}

}  // namespace shell_origami
