#include "test/acceptance/flat_fold.h"

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

/// FlatFold::tolerance as a part of the sheet's size. Lines of recipes and patterns are rounded at
/// the seventh digit at worst; layers that people fold onto each other overlap by millimeters.
constexpr double kTolerance = 1e-4;
/// How far a vertex may be off in one of its triangles, as a part of the sheet's size: a tenth of
/// the tolerance.
constexpr double kCloses = 1e-5;

/// The convex hull, by Andrew's monotone chain.
Polygon hullOf(std::vector<Vector2> points) {
  std::sort(points.begin(), points.end(), [](const Vector2& a, const Vector2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Polygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Vector2& p : points) {
      while (hull.size() >= start + 2 && doubleArea(*(hull.end() - 2), hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

void checkClosing(const Sheet& sheet, const Positions& x) {
  for (const Edge& edge : sheet.edges()) {
    const auto [a, b] = edge.vertices;
    const Vector2& p = sheet.flatPositions()[a];
    const double flat = (p - sheet.flatPositions()[b]).norm();
    if (std::abs((x.col(a) - x.col(b)).norm() - flat) > kCloses * sheet.size()) {
      reject("panels do not close at (", p.x(), ", ", p.y(), ") of the flat sheet");
    }
  }
}

FlatPanel makePanel(const std::vector<int>& triangles, const Sheet& sheet, const FlatFold& fold) {
  FlatPanel panel{triangles, {}, {}, false};
  std::vector<Vector2> points;
  double area = 0;
  for (int t : triangles) {
    const auto [a, b, c] = sheet.triangles()[t];
    points.insert(points.end(), {fold.vertices[a], fold.vertices[b], fold.vertices[c]});
    area += doubleArea(fold.vertices[a], fold.vertices[b], fold.vertices[c]) / 2;
  }
  panel.front_up = area > 0;
  panel.outline = hullOf(points);
  if (areaOf(panel.outline) - std::abs(area) > fold.tolerance * sheet.size()) {
    const Vector2 place = sheet.triangulation().centroid(triangles.front());
    reject("the panel at (", place.x(), ", ", place.y(), ") of the flat sheet is not convex");
  }
  panel.core = clip(panel.outline, panel.outline, fold.tolerance);
  return panel;
}

}  // namespace

FlatFold foldFlat(const Sheet& sheet, const std::vector<double>& crease_angles) {
  for (double angle : crease_angles) {
    if (angle != 0 && std::abs(angle) != M_PI) {
      reject("a crease folds by ", angle, ", but must be shut (-pi or pi) or flat (0)");
    }
  }
  const Positions x = foldRigidly(sheet, crease_angles);
  checkClosing(sheet, x);
  FlatFold fold{{}, {}, {}, kTolerance * sheet.size()};
  for (int v = 0; v < sheet.vertexCount(); ++v) fold.vertices.push_back(x.col(v).head<2>());
  const auto shut = [&](const Edge& edge) {
    return edge.crease >= 0 && crease_angles[edge.crease] != 0;
  };
  const std::vector<int> panels =
      connectedTriangles(sheet, [&](const Edge& edge) { return !shut(edge); });
  std::vector<std::vector<int>> triangles(*std::max_element(panels.begin(), panels.end()) + 1);
  for (std::size_t t = 0; t < panels.size(); ++t) triangles[panels[t]].push_back(t);
  for (const auto& own : triangles) fold.panels.push_back(makePanel(own, sheet, fold));
  for (const Edge& edge : sheet.edges()) {
    if (edge.onBorder() || !shut(edge)) continue;
    const auto [a, b] = edge.vertices;
    fold.edges.push_back({{panels[edge.triangles[0]], panels[edge.triangles[1]]},
                          {fold.vertices[a], fold.vertices[b]},
                          edge.crease,
                          crease_angles[edge.crease] > 0});
  }
  return fold;
}

double areaOf(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return twice / 2;
}

Polygon clip(Polygon polygon, const Polygon& convex, double inset) {
  for (std::size_t i = 0; i < convex.size() && !polygon.empty(); ++i) {
    const Vector2& a = convex[i];
    const Vector2 along = (convex[(i + 1) % convex.size()] - a).normalized();
    const auto depth = [&](const Vector2& p) { return cross(along, p - a) - inset; };
    Polygon kept;
    for (std::size_t j = 0; j < polygon.size(); ++j) {
      const Vector2 &p = polygon[j], &q = polygon[(j + 1) % polygon.size()];
      const double at_p = depth(p), at_q = depth(q);
      if (at_p >= 0) kept.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
        kept.push_back(p + at_p / (at_p - at_q) * (q - p));
      }
    }
    polygon = std::move(kept);
  }
  return polygon;
}

double lengthInside(const Segment& segment, const Polygon& convex) {
  const Polygon inside = clip({segment[0], segment[1]}, convex);
  double length = 0;
  for (const Vector2& p : inside) length = std::max(length, (p - inside.front()).norm());
  return length;
}

}  // namespace shell_origami
