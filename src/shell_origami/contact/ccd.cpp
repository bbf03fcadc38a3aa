#include <shell_origami/contact/ccd.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

/// The search ends where the distance is above that to keep by this part of that, and by this part
/// of what it was above it at first, or after so many planes.
constexpr double kNearEnough = 0.2, kUsedUp = 0.05;
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

/// The first time from 0 to 1 at which c + b t + a t^2 falls to zero; 1 where it does not.
/// \pre c > 0
double firstZero(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return 1;
  const double denominator = std::sqrt(discriminant) - b;
  return denominator > 2 * c ? 2 * c / denominator : 1;
}

/// The part of the motion from `from` to `to` during which a plane whose normal turns from `first`
/// to `last` keeps the primitives `kept` apart. On its way the normal is no longer than 1, so that
/// their distance is at least their gap along it.
double separatedPart(const Vector3& first, const Vector3& last, double kept, PairKind kind,
                     const PairPoints& from, const PairPoints& to) {
  const Vector3 turn = last - first;
  double part = 1;
  for (int i = 0; i < firstSize(kind); ++i) {
    for (int j = firstSize(kind); j < 4; ++j) {
      const Vector3 apart = from[i] - from[j], change = to[i] - to[j] - apart;
      const double room = first.dot(apart) - kept;
      if (!(room > 0)) return 0;
      const double falls = first.dot(change) + turn.dot(apart);
      part = std::min(part, firstZero(turn.dot(change), falls, room));
    }
  }
  return part;
}

}  // namespace

double feasiblePart(PairKind kind, const PairPoints& before, const PairPoints& after,
                    const KeptDistance& kept) {
  const PairPoints from = seenFromFirst(before), to = seenFromFirst(after);
  PairPoints x = from;
  double part = 0, ahead = 1;  // done, and looked ahead at, of what is left
  double target = 0, near = 0;
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
      near = target + std::min(kNearEnough * target, kUsedUp * (gap - target));
    }
    if (i > 0 && gap <= near) return part;
    const double end = gapAlong(direction, kind, to);
    if (end >= target) return 1;
    // The gap is a concave function of time: a minimum of linear ones less a maximum of such.
    double advance = (gap - target) / (gap - end);
    // Primitives that turn together need a plane that turns with them.
    const PairPoints later = pointsAt(ahead, x, to);
    const ClosestPoints closest_later = closestPoints(kind, later);
    if (gap > target && closest_later.distance > 0 &&
        closest_later.direction().dot(direction) > 0) {
      const double free =
          separatedPart(direction, closest_later.direction(), target, kind, x, later);
      if (free == 1 && ahead == 1) return 1;
      advance = std::max(advance, free * ahead);
      ahead = free == 1 ? std::min(1.0, 4 * ahead) : ahead / 2;
    }
    if (!(advance > 0)) return part;
    part += (1 - part) * advance;
    x = pointsAt(part, from, to);
  }
  return part;
}

}  // namespace shell_origami
