#include <shell_origami/contact/barrier.h>

#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

/// Below it the barrier is a parabola: paper that was loaded may lie closer than any motion brings
/// it, at an argument of 0 or less.
constexpr double kSteepest = 1e-5;

}  // namespace

Derivatives logBarrier(double s) {
  if (s >= 1) return {};
  if (s < kSteepest) {
    const Derivatives at = logBarrier(kSteepest);
    const double below = s - kSteepest;
    return {at.value + below * at.first + below * below / 2 * at.second,
            at.first + below * at.second, at.second};
  }
  const double log = std::log(s), open = s - 1;
  return {-open * open * log, -2 * open * log - open * open / s,
          -2 * log - 4 * open / s + open * open / (s * s)};
}

Mollifier mollifier(const PairPoints& x, double limit) {
  const Vector3 e1 = x[1] - x[0], e2 = x[3] - x[2];
  const Vector3 normal = e1.cross(e2);
  const double r = normal.squaredNorm() / limit;
  if (r >= 1) return {};
  Mollifier result;
  result.value = r * (2 - r);
  // d |e1 x e2|^2 = 2 (e2 x n) . de1 + 2 (n x e1) . de2
  const double factor = 2 * (2 - 2 * r) / limit;
  const Vector3 by_first = factor * e2.cross(normal), by_second = factor * normal.cross(e1);
  result.gradient = {-by_first, by_first, -by_second, by_second};
  return result;
}

}  // namespace shell_origami
