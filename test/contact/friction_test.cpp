#include <shell_origami/contact/friction.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace shell_origami {
namespace {

constexpr double kSticking = 1e-6;

Positions columns(const PairPoints& x) {
  Positions positions(3, 4);
  for (int k = 0; k < 4; ++k) positions.col(k) = x[k];
  return positions;
}

/// Two primitives 50 um apart, of either kind, at seeded places.
class Friction : public testing::TestWithParam<std::tuple<PairKind, int>> {
 protected:
  Friction() : kind_(std::get<0>(GetParam())), random_(std::get<1>(GetParam())) {
    std::uniform_real_distribution<double> some(-1e-3, 1e-3);
    const auto shift = [&] { return Vector3(some(random_), some(random_), 0.02 * some(random_)); };
    if (kind_ == PairKind::kVertexFace) {
      x_ = {Vector3(0, 0, 5e-5), Vector3(-0.005, -0.004, 0), Vector3(0.006, -0.003, 0),
            Vector3(0, 0.007, 0)};
    } else {
      x_ = {Vector3(-0.005, 0, 5e-5), Vector3(0.006, 0, 5e-5), Vector3(0.001, -0.004, 0),
            Vector3(0, 0.007, 0)};
    }
    for (int k = 1; k < 4; ++k) x_[k] += shift();
    pair_ = frictionPair({kind_, {0, 1, 2, 3}, 1e-4}, closestPoints(kind_, x_), x_, 0.3);
  }

  PairKind kind_;
  std::mt19937 random_;
  PairPoints x_;
  FrictionPair pair_;
};

// A rotation by an angle a changes the slip at second order, by a^2 / 2 of the 10 mm that the pair
// is large.
TEST_P(Friction, RigidMotionIsNoSlip) {
  const Positions start = columns(x_);
  std::normal_distribution<double> some;
  for (int i = 0; i < 20; ++i) {
    const double angle = 1e-4;
    const Vector3 axis = Vector3(some(random_), some(random_), some(random_)).normalized();
    Positions moved = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * start;
    moved.colwise() += 0.01 * axis;
    EXPECT_LT(slip(pair_, start, moved).norm(), 0.01 * angle * angle);
  }
}

// By virtual work, then, its forces have neither sum nor moment; without the turn of the gap the
// moment would be the force times the gap.
TEST_P(Friction, GivesNoForceAndNoTorqueToTheWhole) {
  const Vector3 force = pair_.bound * pair_.normal.unitOrthogonal();
  const Eigen::Matrix<double, 12, 1> forces = pair_.slip.transpose() * force;
  Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
  for (int k = 0; k < 4; ++k) {
    sum += forces.segment<3>(3 * k);
    moment += x_[k].cross(Vector3(forces.segment<3>(3 * k)));
  }
  EXPECT_LT(sum.norm(), 1e-15);
  EXPECT_LT(moment.norm(), 1e-10 * pair_.bound * 5e-5 + 1e-17);
}

TEST_P(Friction, SlipIsThatOfLayersThatSlide) {
  const Positions start = columns(x_);
  Positions moved = start;
  const Vector3 way = 1e-5 * pair_.normal.unitOrthogonal();
  for (int k = 0; k < firstSize(kind_); ++k) moved.col(k) += way;
  EXPECT_LT((slip(pair_, start, moved) - way).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Friction,
                         testing::Combine(testing::Values(PairKind::kVertexFace,
                                                          PairKind::kEdgeEdge),
                                          testing::Range(1, 6)));

TEST(SmoothSlip, DerivativesAreThoseOfTheValue) {
  for (const double part : {0.1, 0.5, 0.9, 1.0, 1.5, 20.0}) {
    const double s = part * kSticking, h = 1e-4 * kSticking;
    const Derivatives f = smoothSlip(s, kSticking);
    const double first =
        (smoothSlip(s + h, kSticking).value - smoothSlip(s - h, kSticking).value) / (2 * h);
    const double second =
        (smoothSlip(s + h, kSticking).first - smoothSlip(s - h, kSticking).first) / (2 * h);
    EXPECT_NEAR(f.first, first, 1e-7) << part;
    // Its second derivative has a kink at the end of sticking.
    EXPECT_NEAR(f.second * kSticking, second * kSticking, part == 1 ? 1e-4 : 1e-7) << part;
  }
  EXPECT_DOUBLE_EQ(smoothSlip(3 * kSticking, kSticking).first, 1) << "the force is at its bound";
}

TEST(SmoothSlip, HessianIsThatOfItsForce) {
  const Vector3 normal = Vector3::UnitZ();
  for (const double part : {0.3, 0.8, 4.0}) {
    const Vector3 s = part * kSticking * Vector3(0.6, -0.8, 0);
    const Eigen::Matrix3d hessian = slipHessian(s, normal, kSticking);
    const auto force = [](const Vector3& at) {
      return Vector3(smoothSlip(at.norm(), kSticking).first * at.normalized());
    };
    for (int i = 0; i < 2; ++i) {
      const Vector3 h = 1e-4 * kSticking * Vector3::Unit(i);
      const Vector3 numeric = (force(s + h) - force(s - h)) / (2 * h.norm());
      EXPECT_LT((hessian.col(i) - numeric).norm() * kSticking, 1e-7) << part;
    }
  }
}

}  // namespace
}  // namespace shell_origami
