#include <shell_origami/contact/surface.h>

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

constexpr int kSphereDivisions = 4;
constexpr int kCylinderSides = 96;

Positions columnsOf(const std::vector<Vector3>& points) {
  Positions columns(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(i) = points[i];
  return columns;
}

/// Each triangle into four, with the new corners at distance 1 from the origin.
void divideUnitSphere(std::vector<Vector3>& points, std::vector<Triangle>& faces) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] =
        middles.emplace(std::minmax(a, b), static_cast<int>(points.size()));
    if (is_new) points.push_back((points[a] + points[b]).normalized());
    return place->second;
  };
  std::vector<Triangle> divided;
  for (const auto& [a, b, c] : faces) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    divided.insert(divided.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  faces = std::move(divided);
}

}  // namespace

Surface planePatch(const Vector3& center, double size) {
  // The corners of an equilateral triangle whose inscribed circle has the radius `size`.
  const double half = std::sqrt(3.0) * size;
  Positions vertices(3, 3);
  vertices.col(0) = center + Vector3(-half, -size, 0);
  vertices.col(1) = center + Vector3(half, -size, 0);
  vertices.col(2) = center + Vector3(0, 2 * size, 0);
  vertices.row(2).setZero();
  return {vertices, {{0, 1, 2}}, true};
}

Surface boxSurface(const Vector3& size) {
  Positions vertices(3, 8);
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    vertices.col(i) = corner.cwiseProduct(size) / 2;
  }
  return {vertices,
          {{0, 2, 1},
           {1, 2, 3},
           {4, 5, 6},
           {5, 7, 6},
           {0, 1, 4},
           {1, 5, 4},
           {2, 6, 3},
           {3, 6, 7},
           {0, 4, 2},
           {2, 4, 6},
           {1, 3, 5},
           {3, 7, 5}}};
}

Surface sphereSurface(double radius) {
  // Of an octahedron.
  std::vector<Vector3> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                              {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < kSphereDivisions; ++i) divideUnitSphere(points, faces);
  return {radius * columnsOf(points), faces};
}

Surface cylinderSurface(double radius, double length) {
  Positions vertices(3, 2 * kCylinderSides);
  std::vector<Triangle> faces;
  for (int i = 0; i < kCylinderSides; ++i) {
    const double angle = 2 * M_PI * i / kCylinderSides;
    const Vector3 side(radius * std::cos(angle), radius * std::sin(angle), 0);
    vertices.col(2 * i) = side - Vector3(0, 0, length / 2);
    vertices.col(2 * i + 1) = side + Vector3(0, 0, length / 2);
    const int low = 2 * i, high = low + 1;
    const int next_low = (low + 2) % (2 * kCylinderSides), next_high = next_low + 1;
    faces.push_back({low, next_low, high});
    faces.push_back({high, next_low, next_high});
    if (i == 0 || i == kCylinderSides - 1) continue;
    faces.push_back({0, next_low, low});
    faces.push_back({1, high, next_high});
  }
  return {vertices, faces};
}

bool contains(const Surface& surface, const Vector3& point) {
  double sum = 0;  // of half the solid angles
  for (const auto& [i, j, k] : surface.faces) {
    const Vector3 a = surface.vertices.col(i) - point, b = surface.vertices.col(j) - point,
                  c = surface.vertices.col(k) - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum > M_PI;
}

}  // namespace shell_origami
