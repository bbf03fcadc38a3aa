/// Closest points of vertices and faces and of two edges, and the distance's derivatives, against
/// computations that share no formula with them.
#include <shell_origami/contact/distance.h>
#include "test/contact/reference.h"
#include "verify/dual.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <map>

namespace shell_origami {
namespace {

constexpr std::array<PairKind, 2> kKinds{PairKind::kVertexFace, PairKind::kEdgeEdge};

PairPoints randomPair(Random& random) {
  PairPoints x;
  for (Vector3& p : x) p = random.inCube(1);
  return x;
}

/// The points that the closest points lie between, as bits.
int regionOf(const std::array<double, 4>& weights) {
  int region = 0;
  for (int i = 0; i < 4; ++i) region |= (weights[i] != 0) << i;
  return region;
}

/// How far the distance is off [m].
double distanceError(PairKind kind, const PairPoints& x) {
  return static_cast<double>(
      std::abs(closestPoints(kind, x).distance - longClosest(kind, x).distance));
}

TEST(ClosestPoints, AreTheClosestOfAllFeatures) {
  Random random(1);
  std::array<std::map<int, int>, 2> regions;
  for (int i = 0; i < 200000; ++i) {
    const PairKind kind = kKinds[i % 2];
    const PairPoints x = randomPair(random);
    const ClosestPoints closest = closestPoints(kind, x);
    const LongClosest expected = longClosest(kind, x);
    ++regions[i % 2][regionOf(closest.weights)];
    // Rounding of some five operations on lengths of 2, and of weights where faces are narrow and
    // edges all but parallel; 5e-16 and 4e-14 are measured.
    ASSERT_NEAR(closest.distance, static_cast<double>(expected.distance), 2e-15) << i;
    for (int k = 0; k < 4; ++k) {
      ASSERT_NEAR(closest.weights[k], static_cast<double>(expected.weights[k]), 1e-13) << i;
    }
  }
  EXPECT_EQ(regions[0].size(), 7u) << "the inside, three sides and three corners";
  EXPECT_EQ(regions[1].size(), 9u) << "the insides, an end and an inside, two ends";
  for (const auto& of_kind : regions) {
    for (const auto& [region, count] : of_kind) EXPECT_GT(count, 1000) << region;
  }
}

TEST(ClosestPoints, AreWeightedMeansOfTheirPrimitives) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const PairKind kind = kKinds[i % 2];
    PairPoints x = randomPair(random);
    if (i % 3 == 0) x[3] = x[2] + random.between(-1, 1) * (x[1] - x[2]);
    if (i % 5 == 0) x[1] = x[0];
    const ClosestPoints closest = closestPoints(kind, x);
    double first = 0, second = 0;
    Vector3 difference = Vector3::Zero();
    for (int k = 0; k < 4; ++k) {
      const double w = closest.weights[k];
      const bool of_first = k < firstSize(kind);
      EXPECT_GE(of_first ? w : -w, 0) << i;
      (of_first ? first : second) += w;
      difference += w * x[k];
    }
    // The rounding of two additions of numbers up to 1, and of three of lengths up to 2.
    EXPECT_NEAR(first, 1, 4e-16);
    EXPECT_NEAR(second, -1, 4e-16);
    EXPECT_LT((closest.difference - difference).norm(), 1.5e-15);
    EXPECT_EQ(closest.distance, closest.difference.norm());
  }
}

/// A face that is as wide as `width`, and a point that far above its plane or beside it.
PairPoints narrowFace(Random& random, double width, double height) {
  PairPoints x = randomPair(random);
  const Vector3 along = x[2] - x[1];
  x[3] = x[1] + random.between(-1, 2) * along + width * random.direction();
  const double s = random.between(0, 0.5), t = random.between(0, 0.5);
  const Vector3 beside = along.cross(random.direction()).normalized();
  x[0] = x[1] + s * along + t * (x[3] - x[1]) + height * beside;
  return x;
}

/// Two edges that are parallel but for `width`, and as far from each other as `height`.
PairPoints narrowEdges(Random& random, double width, double height) {
  PairPoints x = randomPair(random);
  const Vector3 along = x[1] - x[0];
  x[2] = x[0] + random.between(-1, 1) * along + height * random.direction();
  x[3] = x[2] + random.between(-2, 2) * along + width * random.direction();
  return x;
}

TEST(ClosestPoints, AreExactAsFacesCollapseAndEdgesBecomeParallel) {
  Random random(3);
  for (const double width : {1e-2, 1e-4, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-16, 0.0}) {
    for (const double height : {1.0, 1e-3, 1e-6}) {
      double of_faces = 0, of_edges = 0;
      for (int i = 0; i < 2000; ++i) {
        of_faces = std::max(
            of_faces, distanceError(PairKind::kVertexFace, narrowFace(random, width, height)));
        of_edges = std::max(of_edges,
                            distanceError(PairKind::kEdgeEdge, narrowEdges(random, width, height)));
      }
      EXPECT_LT(of_edges, 2e-15) << width << " " << height;
      // In which region of a narrow face a point is, is found up to the rounding over the squared
      // width: the point is taken for one that is up to the lesser of the width and the rounding
      // over it away, 1e-8 where these are equal. 2.3e-10 is measured.
      EXPECT_LT(of_faces, width > 1e-5 ? 2e-15 : 1e-9) << width << " " << height;
    }
  }
}

TEST(ClosestPoints, OfPrimitivesWithoutLength) {
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const PairKind kind = kKinds[i % 2];
    PairPoints x = randomPair(random);
    if (kind == PairKind::kEdgeEdge) {
      if (i % 6 != 1) x[1] = x[0];
      if (i % 6 != 3) x[3] = x[2];
    } else if (i % 4 == 0) {
      x[3] = x[2] = x[1];
    } else {
      x[1 + i % 3] = x[1 + (i + 1) % 3];
    }
    EXPECT_LT(distanceError(kind, x), 1e-15) << i;
  }
}

TEST(ClosestPoints, AreTheSameFarFromTheOrigin) {
  Random random(5);
  const double grid = std::ldexp(1, -40);
  const auto snapped = [&](double value) { return grid * std::round(value / grid); };
  for (int i = 0; i < 20000; ++i) {
    const PairKind kind = kKinds[i % 2];
    PairPoints near = randomPair(random), far;
    const Vector3 place(512, -256, 1024);
    for (int k = 0; k < 4; ++k) {
      near[k] = (0.01 * near[k]).unaryExpr(snapped);
      far[k] = near[k] + place;
    }
    const ClosestPoints a = closestPoints(kind, near), b = closestPoints(kind, far);
    ASSERT_EQ(a.weights, b.weights);
    ASSERT_EQ(a.difference, b.difference);
  }
}

using Dual12 = Dual<12>;
using DualPoint = DualVector<12>;

Dual12 length(const DualPoint& a) { return sqrt(dot(a, a)); }

/// The distance of the points, lines and planes through those of the points that the closest points
/// lie between.
Dual12 distanceOf(PairKind kind, const std::array<double, 4>& weights, const PairPoints& x) {
  std::array<std::vector<DualPoint>, 2> used;
  for (int i = 0; i < 4; ++i) {
    if (weights[i] == 0) continue;
    DualPoint point;
    for (int k = 0; k < 3; ++k) point[k] = Dual12::variable(x[i][k], 3 * i + k);
    used[i < firstSize(kind) ? 0 : 1].push_back(point);
  }
  if (used[0].size() > used[1].size()) used[0].swap(used[1]);
  const auto& [a, b] = used;
  const DualPoint r = b[0] - a[0];
  if (b.size() == 1) return length(r);
  const DualPoint u = b[1] - b[0];
  if (a.size() == 1 && b.size() == 2) return length(crossProduct(r, u)) / length(u);
  const DualPoint normal = crossProduct(u, a.size() == 2 ? a[1] - a[0] : b[2] - b[0]);
  const Dual12 signed_distance = dot(r, normal) / length(normal);
  return signed_distance.value < 0 ? -signed_distance : signed_distance;
}

TEST(ClosestPoints, DerivativesAgreeInAllRegions) {
  Random random(6);
  std::array<std::map<int, int>, 2> regions;
  double value_error = 0, gradient_error = 0, hessian_error = 0;
  for (int i = 0; i < 20000; ++i) {
    const PairKind kind = kKinds[i % 2];
    const PairPoints x = randomPair(random);
    const ClosestPoints closest = closestPoints(kind, x);
    const Dual12 expected = distanceOf(kind, closest.weights, x);
    ++regions[i % 2][regionOf(closest.weights)];
    Eigen::Matrix<double, 12, 1> gradient;
    for (int k = 0; k < 4; ++k) {
      gradient.segment<3>(3 * k) = closest.weights[k] * closest.direction();
    }
    const Eigen::Matrix<double, 12, 12> hessian = distanceHessian(x, kind, closest);
    const auto grow = [](double& largest, double error) { largest = std::max(largest, error); };
    grow(value_error, std::abs(closest.distance - expected.value));
    grow(gradient_error, (gradient - expected.gradient).norm() / expected.gradient.norm());
    grow(hessian_error, (hessian - expected.hessian).norm() / expected.hessian.norm());
  }
  EXPECT_EQ(regions[0].size(), 7u);
  EXPECT_EQ(regions[1].size(), 9u);
  // Rounding over the sine of the narrowest face or of the edges closest to parallel, once for each
  // derivative, and twice that for the second. Measured are 9e-16, 1.8e-13 and 9e-11.
  EXPECT_LT(value_error, 4e-15);
  EXPECT_LT(gradient_error, 1e-12);
  EXPECT_LT(hessian_error, 5e-10);
}

}  // namespace
}  // namespace shell_origami
