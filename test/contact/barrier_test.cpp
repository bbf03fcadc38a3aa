/// The barrier and the mollifier of parallel edges, and their derivatives.
#include <shell_origami/contact/barrier.h>
#include "test/contact/reference.h"
#include "verify/dual.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

TEST(LogBarrier, HasTheDerivativesOfItsDefinition) {
  for (double s = 1e-5; s < 1; s *= 1.1) {
    const Dual<1> x = Dual<1>::variable(s, 0), open = x - Dual<1>(1);
    const Dual<1> expected = -(open * open * x.chain(std::log(s), 1 / s, -1 / (s * s)));
    const shell_origami::Derivatives barrier = logBarrier(s);
    // Rounding of ten operations; the terms have one sign, so that nothing cancels.
    const auto near = [](double value) { return 2e-15 * std::abs(value); };
    EXPECT_NEAR(barrier.value, expected.value, near(expected.value)) << s;
    EXPECT_NEAR(barrier.first, expected.gradient[0], near(expected.gradient[0])) << s;
    EXPECT_NEAR(barrier.second, expected.hessian(0), near(expected.hessian(0))) << s;
    EXPECT_GT(barrier.value, 0);
    EXPECT_LT(barrier.first, 0);
    EXPECT_GT(barrier.second, 0) << "convex";
  }
}

TEST(LogBarrier, EndsSmoothly) {
  for (const double s : {1.0, std::nextafter(1.0, 2.0), 1.5, 1e3}) {
    const shell_origami::Derivatives barrier = logBarrier(s);
    EXPECT_EQ(barrier.value, 0);
    EXPECT_EQ(barrier.first, 0);
    EXPECT_EQ(barrier.second, 0);
  }
  // b = (1 - s)^3 to lowest order.
  for (const double open : {1e-2, 1e-4, 1e-8, 1e-12}) {
    const shell_origami::Derivatives barrier = logBarrier(1 - open);
    const double relative = 2 * open + 4e-16 / open;  // the next order, and the rounding of 1 - s
    EXPECT_NEAR(barrier.value, std::pow(open, 3), relative * std::pow(open, 3));
    EXPECT_NEAR(barrier.first, -3 * open * open, relative * 3 * open * open);
    EXPECT_NEAR(barrier.second, 6 * open, relative * 6 * open);
  }
}

TEST(LogBarrier, GrowsAsWhatItKeepsApartComesCloser) {
  double before = 0;
  for (double s = 0.9; s > 1e-15; s /= 10) {
    const double value = logBarrier(s).value;
    EXPECT_GT(value, before);
    before = value;
  }
  EXPECT_NEAR(before, -std::log(1e-5), 3);
}

TEST(LogBarrier, PushesAwayWhatLiesCloserThanItMayCome) {
  // From 1e-5 on a parabola with the same value and derivatives there.
  const shell_origami::Derivatives edge = logBarrier(1e-5);
  for (const double s : {0.99e-5, 1e-300, 0.0, -1e-3, -1.0}) {
    const double below = s - 1e-5;
    const shell_origami::Derivatives barrier = logBarrier(s);
    EXPECT_DOUBLE_EQ(barrier.value, edge.value + below * (edge.first + below * edge.second / 2));
    EXPECT_DOUBLE_EQ(barrier.first, edge.first + below * edge.second);
    EXPECT_EQ(barrier.second, edge.second);
    EXPECT_GT(barrier.value, edge.value);
    EXPECT_LT(barrier.first, edge.first);
  }
}

/// The mollifier's definition.
Dual<12> mollifierOf(const PairPoints& points, double limit) {
  std::array<DualVector<12>, 4> x;
  for (int i = 0; i < 12; ++i) x[i / 3][i % 3] = Dual<12>::variable(points[i / 3][i % 3], i);
  const DualVector<12> normal = crossProduct(x[1] - x[0], x[3] - x[2]);
  const Dual<12> r = dot(normal, normal) / Dual<12>(limit);
  return r.value >= 1 ? Dual<12>(1) : r * (Dual<12>(2) - r);
}

/// Edges of lengths 0.9 to 1.3 with this angle between them.
PairPoints edgesAt(Random& random, double angle) {
  const Eigen::Matrix3d turn = random.rotation();
  const double first = random.between(0.9, 1.3), second = random.between(0.9, 1.3);
  PairPoints x{Vector3::Zero(), first * Vector3::UnitX(), random.inCube(0.1), Vector3::Zero()};
  x[3] = x[2] + second * Vector3(std::cos(angle), std::sin(angle), 0);
  for (Vector3& p : x) p = turn * p;
  return x;
}

TEST(Mollifier, HasTheGradientOfItsDefinition) {
  Random random(1);
  const double limit = kParallel;  // of flat lengths of 1
  for (const double angle : {1e-6, 1e-4, 1e-2, 0.02, 0.03, 0.1, 1.0, 3.13, 3.1415}) {
    for (int i = 0; i < 200; ++i) {
      const PairPoints x = edgesAt(random, angle);
      const Mollifier result = mollifier(x, limit);
      const Dual<12> expected = mollifierOf(x, limit);
      // The rounding of the edges over the sine of their angle, in a product that has it twice.
      const double rounding = 1e-15 / std::sin(angle);
      EXPECT_NEAR(result.value, expected.value, rounding * expected.value) << angle;
      Eigen::Matrix<double, 12, 1> gradient;
      for (int k = 0; k < 4; ++k) gradient.segment<3>(3 * k) = result.gradient[k];
      EXPECT_LE((gradient - expected.gradient).norm(), rounding * expected.gradient.norm())
          << angle;
      EXPECT_EQ(result.value == 1, expected.value == 1);
    }
  }
}

TEST(Mollifier, VanishesForParallelEdgesAndEndsSmoothly) {
  const auto edges = [](double sine) {
    return PairPoints{Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 0, 1), Vector3(1, sine, 1)};
  };
  const Mollifier parallel = mollifier(edges(0), kParallel);
  EXPECT_EQ(parallel.value, 0);
  for (const Vector3& g : parallel.gradient) EXPECT_EQ(g, Vector3::Zero());
  const double end = std::sqrt(kParallel);
  for (const double part : {1e-3, 1e-5}) {
    const Mollifier before = mollifier(edges(end * (1 - part)), kParallel);
    // With r = (1 - part)^2 the value is 1 - (1 - r)^2 and the slope by the sine 4 (1 - r) r /
    // sine.
    EXPECT_NEAR(before.value, 1 - 4 * part * part, 5 * std::pow(part, 3));
    EXPECT_NEAR(before.gradient[3].y(), 8 * part / end, 20 * part * part / end);
    const Mollifier after = mollifier(edges(end * (1 + part)), kParallel);
    EXPECT_EQ(after.value, 1);
    for (const Vector3& g : after.gradient) EXPECT_EQ(g, Vector3::Zero());
  }
}

}  // namespace
}  // namespace shell_origami
