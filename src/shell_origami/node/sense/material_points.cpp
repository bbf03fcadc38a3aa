#include <shell_origami/node/sense/material_points.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace shell_origami {
namespace {

/// By how much a point on an edge may seem to lie outside, in barycentric coordinates.
constexpr double kRounding = 1e-9;

struct Lattice {
  Vector2 origin;
  double spacing;

  /// Half a spacing away from the left and the lower border, on which points would be lost by
  /// rounding.
  Vector2 point(int column, int row) const {
    return origin + spacing * Vector2(column + 0.5, row + 0.5);
  }
  /// The column or row of the first point at or after a coordinate.
  int firstAt(double coordinate, int axis) const {
    return static_cast<int>(std::ceil((coordinate - origin[axis]) / spacing - 0.5 - kRounding));
  }
};

/// A point of the lattice in one of the triangles in which it lies.
struct LatticeHit {
  int row, column;
  Triangulation::Location place;

  bool samePoint(const LatticeHit& other) const {
    return row == other.row && column == other.column;
  }
  /// Of the triangles of one point, the one in which it lies deepest comes first.
  bool before(const LatticeHit& other) const {
    const double depth = place.weights.minCoeff(), other_depth = other.place.weights.minCoeff();
    return std::make_tuple(row, column, -depth, place.triangle) <
           std::make_tuple(other.row, other.column, -other_depth, other.place.triangle);
  }
};

/// Of four digits: the last bits of the area depend on the triangles, and must not move the points.
double latticeSpacing(double area, double count) {
  const double wanted = std::sqrt(area / count);
  const double unit = std::pow(10, std::floor(std::log10(wanted)) - 3);
  return std::round(wanted / unit) * unit;
}

void hitTriangle(const Lattice& lattice, const Sheet& sheet, int triangle,
                 std::vector<LatticeHit>& hits) {
  const Triangle& corners = sheet.triangles()[triangle];
  const Vector2& a = sheet.flatPositions()[corners[0]];
  const Vector2& b = sheet.flatPositions()[corners[1]];
  const Vector2& c = sheet.flatPositions()[corners[2]];
  const double area = doubleArea(a, b, c);
  const Vector2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const double slack = kRounding * lattice.spacing;
  for (int row = lattice.firstAt(low.y(), 1);; ++row) {
    if (lattice.point(0, row).y() > high.y() + slack) break;
    for (int column = lattice.firstAt(low.x(), 0);; ++column) {
      const Vector2 p = lattice.point(column, row);
      if (p.x() > high.x() + slack) break;
      const Vector3 weights =
          Vector3(doubleArea(p, b, c), doubleArea(a, p, c), doubleArea(a, b, p)) / area;
      if (weights.minCoeff() >= -kRounding) hits.push_back({row, column, {triangle, weights}});
    }
  }
}

}  // namespace

std::vector<MaterialPoint> sampleSheet(const Sheet& sheet, double count) {
  Lattice lattice{sheet.flatPositions().front(), latticeSpacing(sheet.area(), count)};
  for (const Vector2& p : sheet.flatPositions()) lattice.origin = lattice.origin.cwiseMin(p);
  std::vector<LatticeHit> hits;
  for (int t = 0; t < static_cast<int>(sheet.triangles().size()); ++t) {
    hitTriangle(lattice, sheet, t, hits);
  }
  std::sort(hits.begin(), hits.end(),
            [](const LatticeHit& a, const LatticeHit& b) { return a.before(b); });
  const auto end =
      std::unique(hits.begin(), hits.end(),
                  [](const LatticeHit& a, const LatticeHit& b) { return a.samePoint(b); });
  std::vector<MaterialPoint> points;
  for (auto hit = hits.begin(); hit != end; ++hit) {
    points.push_back({lattice.point(hit->column, hit->row), hit->place});
  }
  return points;
}

Vector3 inSpace(const MaterialPoint& point, const Sheet& sheet, const Positions& positions) {
  const auto& [a, b, c] = sheet.triangles()[point.place.triangle];
  const Vector3& w = point.place.weights;
  return w[0] * positions.col(a) + w[1] * positions.col(b) + w[2] * positions.col(c);
}

}  // namespace shell_origami
