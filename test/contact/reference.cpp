#include "test/contact/reference.h"

#include <CGAL/MP_Float.h>
#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

using Points = std::array<Long3, 4>;

class Closest {
 public:
  explicit Closest(const Points& x) : x_(x) {}

  void offer(const std::array<Long, 4>& weights) {
    // Relative to one of them, so that far from the origin nothing is lost.
    Long3 difference = Long3::Zero();
    for (int i = 1; i < 4; ++i) difference += weights[i] * (x_[i] - x_[0]);
    const Long distance = difference.norm();
    if (best_.distance <= distance) return;
    best_ = {distance, difference, weights};
  }
  /// Offers the ends and, where the foot of point p is on it, the inside of the segment a, b. The
  /// point has the given sign among the weights.
  void offerSegment(int p, int a, int b, Long sign) {
    offerPoints(p, a, sign);
    offerPoints(p, b, sign);
    const Long3 along = x_[b] - x_[a];
    const Long t = along.dot(x_[p] - x_[a]) / along.squaredNorm();
    if (!(t > 0 && t < 1)) return;
    std::array<Long, 4> weights{};
    weights[p] = sign;
    weights[a] = -sign * (1 - t);
    weights[b] = -sign * t;
    offer(weights);
  }
  const LongClosest& best() const { return best_; }

 private:
  void offerPoints(int p, int a, Long sign) {
    std::array<Long, 4> weights{};
    weights[p] = sign;
    weights[a] = -sign;
    offer(weights);
  }

  const Points& x_;
  LongClosest best_{HUGE_VALL, Long3::Zero(), {}};
};

void offerInsideOfFace(const Points& x, Closest& closest) {
  const Long3 u = x[2] - x[1], v = x[3] - x[1], r = x[0] - x[1], normal = u.cross(v);
  const Long area = normal.squaredNorm();
  const Long second = r.cross(v).dot(normal) / area, third = u.cross(r).dot(normal) / area;
  if (second > 0 && third > 0 && second + third < 1) {
    closest.offer({1, second + third - 1, -second, -third});
  }
}

void offerInsideOfEdges(const Points& x, Closest& closest) {
  const Long3 u = x[1] - x[0], v = x[3] - x[2], r = x[2] - x[0], normal = u.cross(v);
  const Long area = normal.squaredNorm();
  const Long s = r.cross(v).dot(normal) / area, t = r.cross(u).dot(normal) / area;
  if (s > 0 && s < 1 && t > 0 && t < 1) closest.offer({1 - s, s, t - 1, -t});
}

using Exact = CGAL::MP_Float;

/// A bound on the rounding of some ten operations in long double, relative to the sum of the
/// terms' magnitudes.
const Long kRounding = std::ldexp(1.0L, -60);

/// Whether two points keep their order along a direction between two times.
class Order {
 public:
  Order(const Vector3& direction, const Vector3& a_from, const Vector3& b_from, const Vector3& a_to,
        const Vector3& b_to)
      : direction_(direction), from_{a_from, b_from}, to_{a_to, b_to} {
    for (int k = 0; k < 3; ++k) {
      const Long d = direction[k];
      const Long start = d * (static_cast<Long>(a_from[k]) - b_from[k]);
      const Long end = d * (static_cast<Long>(a_to[k]) - b_to[k]);
      start_ += start;
      end_ += end;
      size_ += std::abs(start) + std::abs(end);
    }
  }
  bool holdsAt(double t) const {
    const Long value = (1 - static_cast<Long>(t)) * start_ + t * end_;
    if (value > kRounding * size_) return true;
    if (value < -kRounding * size_) return false;
    Exact start(0), end(0);
    for (int k = 0; k < 3; ++k) {
      start = start + Exact(direction_[k]) * (Exact(from_[0][k]) - Exact(from_[1][k]));
      end = end + Exact(direction_[k]) * (Exact(to_[0][k]) - Exact(to_[1][k]));
    }
    return CGAL::is_positive((Exact(1) - Exact(t)) * start + Exact(t) * end);
  }

 private:
  Vector3 direction_;
  std::array<Vector3, 2> from_, to_;
  Long start_ = 0, end_ = 0, size_ = 0;
};

bool separates(const Vector3& direction, PairKind kind, const PairPoints& from,
               const PairPoints& to, double begin, double end) {
  for (int i = 0; i < firstSize(kind); ++i) {
    for (int j = firstSize(kind); j < 4; ++j) {
      const Order order(direction, from[i], from[j], to[i], to[j]);
      if (!order.holdsAt(begin) || !order.holdsAt(end)) return false;
    }
  }
  return true;
}

Points pointsAt(double t, const PairPoints& from, const PairPoints& to) {
  Points x;
  for (int i = 0; i < 4; ++i) {
    x[i] = (1 - static_cast<Long>(t)) * from[i].cast<Long>() + t * to[i].cast<Long>();
  }
  return x;
}

/// The directions of the closest points and, where these are within rounding, across the plane of
/// the face or the edges.
bool someDirectionSeparates(PairKind kind, const PairPoints& from, const PairPoints& to,
                            double begin, double end) {
  for (const double t : {begin + (end - begin) / 2, begin, end}) {
    const Points x = pointsAt(t, from, to);
    const LongClosest closest = longClosest(kind, x);
    const Vector3 direction = (closest.difference / closest.distance).cast<double>();
    if (separates(direction, kind, from, to, begin, end)) return true;
    const Long3 normal = kind == PairKind::kVertexFace ? Long3((x[2] - x[1]).cross(x[3] - x[1]))
                                                       : Long3((x[1] - x[0]).cross(x[3] - x[2]));
    const Vector3 across = normal.normalized().cast<double>();
    if (separates(across, kind, from, to, begin, end)) return true;
    if (separates(-across, kind, from, to, begin, end)) return true;
  }
  return false;
}

/// Parts of a motion that are looked at before it is given up; proofs of motions that keep apart
/// take 81 at most.
constexpr int kMostParts = 300;

bool provedBetween(PairKind kind, const PairPoints& from, const PairPoints& to, double begin,
                   double end, int& parts) {
  if (++parts > kMostParts) return false;
  if (someDirectionSeparates(kind, from, to, begin, end)) return true;
  const double middle = begin + (end - begin) / 2;
  return provedBetween(kind, from, to, begin, middle, parts) &&
         provedBetween(kind, from, to, middle, end, parts);
}

}  // namespace

LongClosest longClosest(PairKind kind, const std::array<Long3, 4>& x) {
  Closest closest(x);
  if (kind == PairKind::kVertexFace) {
    for (int k = 0; k < 3; ++k) closest.offerSegment(0, 1 + k, 1 + (k + 1) % 3, 1);
    offerInsideOfFace(x, closest);
  } else {
    for (int k = 0; k < 2; ++k) {
      closest.offerSegment(k, 2, 3, 1);
      closest.offerSegment(2 + k, 0, 1, -1);
    }
    offerInsideOfEdges(x, closest);
  }
  return closest.best();
}

LongClosest longClosest(PairKind kind, const PairPoints& x) {
  return longClosest(
      kind, Points{x[0].cast<Long>(), x[1].cast<Long>(), x[2].cast<Long>(), x[3].cast<Long>()});
}

bool provedApart(PairKind kind, const PairPoints& from, const PairPoints& to, double part) {
  int parts = 0;
  return provedBetween(kind, from, to, 0, part, parts);
}

Vector3 Random::inCube(double size) {
  return {between(-size, size), between(-size, size), between(-size, size)};
}

Vector3 Random::direction() {
  for (;;) {
    const Vector3 v = inCube(1);
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

Eigen::Matrix3d Random::rotation() {
  return Eigen::AngleAxisd(between(0, 2 * M_PI), direction()).toRotationMatrix();
}

}  // namespace shell_origami
