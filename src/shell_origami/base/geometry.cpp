#include <shell_origami/base/geometry.h>

#include <algorithm>

namespace shell_origami {

double distanceToSegment(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double s = length2 > 0 ? std::clamp(ab.dot(p - a) / length2, 0.0, 1.0) : 0.0;
  return (a + s * ab - p).norm();
}

bool polygonContains(const std::vector<Vector2>& polygon, const Vector2& p, double tolerance) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2 &a = polygon[i], &b = polygon[j];
    if (distanceToSegment(p, a, b) <= tolerance) return true;
    const bool straddles = (a.y() > p.y()) != (b.y() > p.y());
    if (straddles && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace shell_origami
