#include <shell_origami/contact/ccd.h>

#include <algorithm>

namespace shell_origami {
namespace {

/// The search ends within this factor of the distance to keep, or after so many planes.
constexpr double kNearEnough = 1.2;
constexpr int kMostPlanes = 64;

/// The distance of two primitives along a direction; negative where they overlap.
double gapAlong(const Vector3& direction, PairKind kind, const PairPoints& x) {
  const int first = firstSize(kind);
  double near = direction.dot(x[0]), far = direction.dot(x[first]);
  for (int i = 1; i < first; ++i) near = std::min(near, direction.dot(x[i]));
  for (int i = first + 1; i < 4; ++i) far = std::max(far, direction.dot(x[i]));
  return near - far;
}

/// Points as seen from their first one: rounding is then as small as the primitives, wherever they
/// are.
PairPoints seenFromFirst(const PairPoints& x) {
  return {Vector3::Zero(), x[1] - x[0], x[2] - x[0], x[3] - x[0]};
}

PairPoints pointsAt(double t, const PairPoints& from, const PairPoints& to) {
  PairPoints x;
  for (int i = 0; i < 4; ++i) x[i] = from[i] + t * (to[i] - from[i]);
  return x;
}

}  // namespace

double feasiblePart(PairKind kind, const PairPoints& before, const PairPoints& after,
                    const KeptDistance& kept) {
  const PairPoints from = seenFromFirst(before), to = seenFromFirst(after);
  double part = 0;
  PairPoints x = from;
  double target = 0;
  for (int i = 0; i < kMostPlanes; ++i) {
    const ClosestPoints closest = closestPoints(kind, x);
    if (!(closest.distance > 0)) return part;
    // The gap along the plane's normal as the corners have it, so that rounding cannot help it.
    const Vector3 direction = closest.direction();
    const double gap = gapAlong(direction, kind, x);
    // Of a collapsed face rounding may take another point for the closest one.
    if (!(gap > 0)) return part;
    if (i == 0) {
      target = std::min(gap, std::max(kept.least, std::min(kept.part * gap, kept.enough)));
    }
    if (i > 0 && gap <= kNearEnough * target) return part;
    const double end = gapAlong(direction, kind, to);
    if (end >= target) return 1;
    // The gap is a concave function of time: a minimum of linear ones less a maximum of such.
    const double advance = (gap - target) / (gap - end);
    if (!(advance > 0)) return part;
    part += (1 - part) * advance;
    x = pointsAt(part, from, to);
  }
  return part;
}

}  // namespace shell_origami
