#include <shell_origami/energy/dihedral.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;

/// A hinge bent by theta, its wings' apexes at given feet and heights, turned somehow in space.
HingePoints bentHinge(double theta, double foot2, double height2, double foot3, double height3) {
  HingePoints x;
  x[0] = {0, 0, 0};
  x[1] = {1.3, 0, 0};
  x[2] = {foot2, height2, 0};
  x[3] = {foot3, -height3 * std::cos(theta), height3 * std::sin(theta)};
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.5, -0.1, 0.7, 0.4).normalized().toRotationMatrix();
  for (auto& p : x) p = turn * p + Eigen::Vector3d(0.3, -2, 1);
  return x;
}

HingePoints moved(HingePoints x, int i, double d) {
  x[i / 3][i % 3] += d;
  return x;
}

void expectDerivatives(const HingePoints& x, double scale) {
  // Central differences of step h err by h^2 f''' / 6 plus rounding / h.
  const double h = 1e-6 * scale;
  const HingeGradient gradient = foldAngleGradient(x);
  const HingeHessian hessian = foldAngleHessian(x);
  HingeGradient numeric;
  HingeHessian numeric_hessian;
  for (int i = 0; i < 12; ++i) {
    numeric[i] = (foldAngle(moved(x, i, h)).radians - foldAngle(moved(x, i, -h)).radians) / (2 * h);
    numeric_hessian.col(i) =
        (foldAngleGradient(moved(x, i, h)) - foldAngleGradient(moved(x, i, -h))) / (2 * h);
  }
  EXPECT_LT((gradient - numeric).norm(), 1e-7 * gradient.norm());
  EXPECT_LT((hessian - numeric_hessian).norm(), 1e-7 * hessian.norm());
  EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12 * hessian.norm());
}

class DihedralTest : public testing::TestWithParam<double> {};

TEST_P(DihedralTest, ValleyIsPositive) {
  for (const double sign : {1.0, -1.0}) {
    const double theta = sign * GetParam() * kDegree;
    const FoldAngle angle = foldAngle(bentHinge(theta, 0.5, 1, 0.7, 0.8));
    EXPECT_NEAR(angle.radians, theta, 1e-12);
    // d tan(theta / 2) / d theta = (1 + tan^2) / 2 magnifies the rounding of the points.
    const double tangent = std::tan(theta / 2);
    EXPECT_NEAR(angle.half_tangent, tangent, 1e-12 * (1 + tangent * tangent));
  }
}

TEST_P(DihedralTest, DerivativesMatchFiniteDifferences) {
  for (const double sign : {1.0, -1.0}) {
    const double theta = sign * GetParam() * kDegree;
    expectDerivatives(bentHinge(theta, 0.5, 1, 0.7, 0.8), 1);
    expectDerivatives(bentHinge(theta, -0.4, 1, 2.1, 0.8), 1);
  }
}

TEST_P(DihedralTest, DerivativesHoldOnSlivers) {
  for (const double sign : {1.0, -1.0}) {
    const double theta = sign * GetParam() * kDegree;
    expectDerivatives(bentHinge(theta, 0.5, 0.01, 0.7, 0.8), 0.01);
    expectDerivatives(bentHinge(theta, 0.01, 0.02, 1.29, 0.01), 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, DihedralTest,
                         testing::Values(1, 10, 30, 45, 60, 89, 90, 91, 120, 150, 170, 178, 179));

TEST(Dihedral, TurningAndShiftingTheWholeHingeChangesNothing) {
  const HingePoints x = bentHinge(2.1, 0.5, 1, 0.7, 0.8);
  const HingeGradient gradient = foldAngleGradient(x);
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
  for (int k = 0; k < 4; ++k) {
    force += gradient.segment<3>(3 * k);
    torque += x[k].cross(Eigen::Vector3d(gradient.segment<3>(3 * k)));
  }
  EXPECT_LT(force.norm(), 1e-13);
  EXPECT_LT(torque.norm(), 1e-13);
}

TEST(Dihedral, ShutFlatIsAHalfTurnAndAWingWithoutAreaIsFlat) {
  const HingePoints shut{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 2, 0}}};
  EXPECT_DOUBLE_EQ(std::abs(foldAngle(shut).radians), M_PI);
  const HingePoints thin{{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.5, -1, 0}}};
  EXPECT_EQ(foldAngle(thin).radians, 0);
  EXPECT_EQ(foldAngle(thin).half_tangent, 0);
}

TEST(Dihedral, PhiGrowsWithoutBoundTowardsAHalfTurn) {
  EXPECT_DOUBLE_EQ(phi(0).value, 0);
  EXPECT_NEAR(phi(1e-3).value, 1e-3, 1e-9);
  EXPECT_GT(phi(179.99 * kDegree).value, 1e4);
  const double h = 1e-6;
  for (const double theta : {-2.9, -1.0, 0.3, 2.0, 3.0}) {
    const Phi p = phi(theta);
    EXPECT_NEAR((phi(theta + h).value - phi(theta - h).value) / (2 * h) / p.first, 1, 1e-7);
    EXPECT_NEAR((phi(theta + h).first - phi(theta - h).first) / (2 * h) / p.second, 1, 1e-7);
  }
}

}  // namespace
}  // namespace shell_origami
