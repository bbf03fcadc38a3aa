#include <shell_origami/contact/distance.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shell_origami {
namespace {

/// The weights' sum is zero: differences of points keep far from the origin what these would lose.
ClosestPoints between(const PairPoints& x, const std::array<double, 4>& weights) {
  const Vector3 difference =
      weights[1] * (x[1] - x[0]) + weights[2] * (x[2] - x[0]) + weights[3] * (x[3] - x[0]);
  return {weights, difference, difference.norm()};
}

/// Parameter of the point of a segment of this squared length that is closest to a point whose
/// product with it, from its start, is `along`.
double closestOn(double squared_length, double along) {
  return squared_length > 0 ? std::clamp(along / squared_length, 0.0, 1.0) : 0;
}

/// Of the closest points of the three sides the one closest to x[0].
std::array<double, 4> vertexSideWeights(const PairPoints& x) {
  std::array<double, 4> closest{};
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int i = 1 + k, j = 1 + (k + 1) % 3;
    const Vector3 side = x[j] - x[i];
    const double t = closestOn(side.squaredNorm(), side.dot(x[0] - x[i]));
    std::array<double, 4> weights{1, 0, 0, 0};
    weights[i] = t - 1;
    weights[j] = -t;
    const double distance = between(x, weights).distance;
    if (!(distance < smallest)) continue;
    smallest = distance;
    closest = weights;
  }
  return closest;
}

/// Below this squared sine of an angle a face has all but collapsed, and the place on it that its
/// normal tells may be any.
constexpr double kCollapsed = 1e-12;

/// Of a point across from the inside of a narrow face, as far as the sums by which that was found
/// are exact: they lose twice as many digits as these weights do.
std::array<double, 4> narrowFaceWeights(const PairPoints& x) {
  const Vector3 ab = x[2] - x[1], ac = x[3] - x[1], ap = x[0] - x[1];
  const Vector3 normal = ab.cross(ac);
  const double area = normal.squaredNorm();
  const double v = ap.cross(ac).dot(normal) / area, w = ab.cross(ap).dot(normal) / area;
  const std::array<double, 4> inside{1, v + w - 1, -v, -w};
  const bool valid = v >= 0 && w >= 0 && v + w <= 1;
  const bool collapsed = !(area > kCollapsed * ab.squaredNorm() * ac.squaredNorm());
  if (valid && !collapsed) return inside;
  const std::array<double, 4> side = vertexSideWeights(x);
  return valid && between(x, inside).distance < between(x, side).distance ? inside : side;
}

/// Below this squared sine of their angle products of sides are too inexact: of 5.7 degrees, where
/// they lose two digits. Cross products, which lose half as many, take longer.
constexpr double kNarrow = 1e-2;

/// Sorts by the region of the face's plane in which p is: of a corner, of a side, or the inside.
std::array<double, 4> vertexFaceWeights(const PairPoints& x) {
  const Vector3 &p = x[0], &a = x[1], &b = x[2], &c = x[3];
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, -1, 0, 0};
  const Vector3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {1, 0, -1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) {
    const double v = d1 / (d1 - d3);
    return {1, v - 1, -v, 0};
  }
  const Vector3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {1, 0, 0, -1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) {
    const double w = d2 / (d2 - d6);
    return {1, w - 1, 0, -w};
  }
  const double va = d3 * d6 - d5 * d4;
  const double bc = (d4 - d3) + (d5 - d6);
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0 && bc > 0) {
    const double w = (d4 - d3) / bc;
    return {1, 0, w - 1, -w};
  }
  const double sum = va + vb + vc;
  if (!(sum > kNarrow * ab.squaredNorm() * ac.squaredNorm())) return narrowFaceWeights(x);
  const double v = vb / sum, w = vc / sum;
  return {1, v + w - 1, -v, -w};
}

std::array<double, 4> edgeEdgeWeights(const PairPoints& x) {
  const Vector3 d1 = x[1] - x[0], d2 = x[3] - x[2], r = x[0] - x[2];
  const double a = d1.squaredNorm(), e = d2.squaredNorm();
  const double b = d1.dot(d2), c = d1.dot(r), f = d2.dot(r);
  double denominator = a * e - b * b, numerator = b * f - c * e;
  if (denominator < kNarrow * a * e) {
    const Vector3 normal = d1.cross(d2);
    denominator = normal.squaredNorm();
    numerator = d2.cross(r).dot(normal);
  }
  // Of parallel edges any point serves as long as the other one is the closest to it.
  double s = denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0;
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0 || e == 0) {
    t = 0;
    s = closestOn(a, -c);
  } else if (t > 1) {
    t = 1;
    s = closestOn(a, b - c);
  }
  return {1 - s, s, t - 1, -t};
}

}  // namespace

namespace {

/// Part of a face's size below which distances are taken along its normal: rounding of the weights
/// would tilt the difference by up to 1e-16 over that part.
constexpr double kNearFace = 1e-6;

/// Replaces the difference by its part along the normal where it is short and the point is across
/// from the inside of the face, so that the face, however large, lies on one side of the plane
/// through its closest point.
ClosestPoints straightened(const PairPoints& x, const ClosestPoints& closest) {
  const auto& w = closest.weights;
  if (w[1] == 0 || w[2] == 0 || w[3] == 0) return closest;
  const Vector3 ab = x[2] - x[1], ac = x[3] - x[1];
  if (!(closest.distance < kNearFace * ab.norm())) return closest;
  const Vector3 across = ab.cross(ac);
  // The normal of a narrow face is no more exact than the difference.
  if (!(across.squaredNorm() > kNarrow * ab.squaredNorm() * ac.squaredNorm())) return closest;
  const Vector3 normal = across.normalized();
  const double along = normal.dot(x[0] - x[1]);
  return {w, along * normal, std::abs(along)};
}

}  // namespace

ClosestPoints closestPoints(PairKind kind, const PairPoints& x) {
  if (kind == PairKind::kVertexFace) return straightened(x, between(x, vertexFaceWeights(x)));
  return between(x, edgeEdgeWeights(x));
}

namespace {

/// The derivatives of the weights by the parameters along which the closest points are free to
/// move.
std::vector<std::array<double, 4>> freeDirections(PairKind kind,
                                                  const std::array<double, 4>& weights) {
  std::vector<std::array<double, 4>> directions;
  const auto slide = [&](int from, int to, double sign) {
    std::array<double, 4> direction{};
    direction[from] = -sign;
    direction[to] = sign;
    directions.push_back(direction);
  };
  const auto used = [&](int i) { return weights[i] != 0; };
  if (kind == PairKind::kEdgeEdge) {
    if (used(0) && used(1)) slide(0, 1, 1);
    if (used(2) && used(3)) slide(2, 3, -1);
    return directions;
  }
  for (int first = 1, i = 2; i < 4; ++i) {
    if (!used(first)) first = i;
    else if (used(i)) slide(first, i, -1);
  }
  return directions;
}

}  // namespace

// With E = r . r / 2, r = sum w_i x_i and the parameters b of the weights at their optimum,
//   E_xx = W^T W - B^T (T^T T)^-1 B,   T_j = dr/db_j,   B_j = T_j . W + r . dW/db_j,
// and the distance d = sqrt(2 E) has d_xx = (E_xx - d_x d_x^T) / d.
Eigen::Matrix<double, 12, 12> distanceHessian(const PairPoints& x, PairKind kind,
                                              const ClosestPoints& closest) {
  const auto& w = closest.weights;
  Eigen::Matrix<double, 3, 12> weights;
  for (int i = 0; i < 4; ++i) {
    weights.middleCols<3>(3 * i) = w[i] * Eigen::Matrix3d::Identity();
  }
  const Vector3 direction = closest.direction();
  const Eigen::Matrix<double, 12, 1> gradient = weights.transpose() * direction;
  Eigen::Matrix<double, 12, 12> hessian =
      weights.transpose() * weights - gradient * gradient.transpose();
  const auto directions = freeDirections(kind, w);
  const int count = static_cast<int>(directions.size());
  if (count > 0) {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 2> tangents(3, count);
    Eigen::Matrix<double, Eigen::Dynamic, 12, 0, 2, 12> mixed(count, 12);
    for (int j = 0; j < count; ++j) {
      const auto& c = directions[j];
      tangents.col(j) = c[0] * x[0] + c[1] * x[1] + c[2] * x[2] + c[3] * x[3];
      for (int i = 0; i < 4; ++i) {
        mixed.block<1, 3>(j, 3 * i) =
            (w[i] * tangents.col(j) + c[i] * closest.difference).transpose();
      }
    }
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2> metric =
        tangents.transpose() * tangents;
    hessian -= mixed.transpose() * metric.inverse() * mixed;
  }
  return hessian / closest.distance;
}

}  // namespace shell_origami
