#include <shell_origami/energy/edge_area_membrane.h>
#include <shell_origami/energy/membrane.h>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace shell_origami {
namespace {

const std::array<Vector2, 3> kFlat{Vector2(0.01, 0.02), Vector2(0.02, 0.021), Vector2(0.013, 0.03)};

TrianglePoints inSpace(double stretch) {
  TrianglePoints x;
  for (int k = 0; k < 3; ++k) {
    x[k] = {stretch * kFlat[k].x(), kFlat[k].y() / stretch, 0.3 * kFlat[k].x()};
  }
  return x;
}

TrianglePoints moved(TrianglePoints x, int i, double d) {
  x[i / 3][i % 3] += d;
  return x;
}

const MembraneStrain kUnset = MembraneStrain::Zero();
/// A triangle at rest in this strain.
const GreenStrain kSet(0.02, -0.05, 0.03);

constexpr double kStretches[] = {0.6, 0.9, 0.999, 1.05, 1.4};

/// What every membrane promises.
template <class Element>
class MembraneTest : public testing::Test {};
using Membranes = testing::Types<MembraneElement, EdgeAreaMembrane>;
TYPED_TEST_SUITE(MembraneTest, Membranes);

TYPED_TEST(MembraneTest, DerivativesMatchFiniteDifferences) {
  Material material;
  material.poisson_ratio = 0.4;  // above 1/3 the area term counts
  const TypeParam element(kFlat, material);
  const MembraneStrain rest = element.strainOf(kSet);
  for (const double stretch : kStretches) {
    const TrianglePoints x = inSpace(stretch);
    const double h = 1e-8;  // a millionth of the triangle's size
    const MembraneGradient gradient = element.gradient(x, rest);
    const MembraneHessian hessian = element.hessian(x, element.strain(x) - rest, false);
    MembraneGradient numeric;
    MembraneHessian numeric_hessian;
    for (int i = 0; i < 9; ++i) {
      numeric[i] =
          (element.energy(moved(x, i, h), rest) - element.energy(moved(x, i, -h), rest)) / (2 * h);
      numeric_hessian.col(i) =
          (element.gradient(moved(x, i, h), rest) - element.gradient(moved(x, i, -h), rest)) /
          (2 * h);
    }
    EXPECT_LT((gradient - numeric).norm(), 1e-6 * gradient.norm()) << stretch;
    EXPECT_LT((hessian - numeric_hessian).norm(), 1e-6 * hessian.norm()) << stretch;
  }
}

TYPED_TEST(MembraneTest, ProjectedHessianIsPositiveSemidefinite) {
  const TypeParam element(kFlat, {});
  for (const double stretch : kStretches) {
    const TrianglePoints x = inSpace(stretch);
    const MembraneHessian hessian = element.hessian(x, element.strain(x), true);
    const Eigen::SelfAdjointEigenSolver<MembraneHessian> eigen(hessian);
    EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-12 * eigen.eigenvalues().maxCoeff()) << stretch;
  }
}

TYPED_TEST(MembraneTest, StrainAfterADisplacementIsRightToFirstOrder) {
  const TypeParam element(kFlat, {});
  const TrianglePoints x = inSpace(1.05);
  std::vector<double> errors;
  for (const double size : {1e-4, 1e-5}) {
    TrianglePoints step, after;
    for (int k = 0; k < 3; ++k) {
      step[k] = size * Eigen::Vector3d(1 - k, 0.4 * k, k * k - 1);
      after[k] = x[k] + step[k];
    }
    errors.push_back((element.strainAfter(x, x, step) - element.strain(after)).norm());
  }
  EXPECT_NEAR(errors[0] / errors[1], 100, 5);
}

TYPED_TEST(MembraneTest, RigidMotionsCostNothing) {
  const TypeParam element(kFlat, {});
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.5, -0.1, 0.7, 0.4).normalized().toRotationMatrix();
  TrianglePoints x;
  for (int k = 0; k < 3; ++k) {
    x[k] = turn * Eigen::Vector3d(kFlat[k].x(), kFlat[k].y(), 0) + Eigen::Vector3d(1, 2, 3);
  }
  // Rounding of coordinates near 1 against a triangle of 0.01, times E t A.
  EXPECT_LT(element.energy(x, kUnset), 1e-22);
  EXPECT_NEAR(element.areaRatio(x), 1, 1e-12);
}

TYPED_TEST(MembraneTest, ASetTriangleRestsInItsStrain) {
  const TypeParam element(kFlat, {});
  Eigen::Matrix2d stretch;  // its own square root of the metric: no shape is lost to rotation
  stretch << 1.1, 0.04, 0.04, 0.93;
  const Eigen::Matrix2d green = (stretch * stretch - Eigen::Matrix2d::Identity()) / 2;
  const MembraneStrain rest = element.strainOf({green(0, 0), green(1, 1), green(0, 1)});
  TrianglePoints x;
  for (int k = 0; k < 3; ++k) x[k] << stretch * kFlat[k], 0;
  EXPECT_LT((element.strain(x) - rest).norm(), 1e-13);
  // Rounding of strains of 0.1, against a triangle strained so from flat.
  EXPECT_LT(element.energy(x, rest), 1e-24 * element.energy(x, kUnset));
  EXPECT_LT(element.gradient(x, rest).norm(), 1e-12 * element.gradient(x, kUnset).norm());
}

TEST(Membrane, UniaxialTensionPullsWithYoungsModulus) {
  // Stretched by e and contracted by nu e across, only the stress E e along remains.
  const Material material;
  const MembraneElement element(kFlat, material);
  const double e = 1e-6;
  TrianglePoints x;
  for (int k = 0; k < 3; ++k) {
    x[k] = {(1 + e) * kFlat[k].x(), (1 - material.poisson_ratio * e) * kFlat[k].y(), 0};
  }
  const double volume = doubleArea(kFlat[0], kFlat[1], kFlat[2]) / 2 * material.thickness;
  EXPECT_NEAR(element.energy(x, kUnset) / (volume * material.youngs_modulus * e * e / 2), 1, 1e-5);
}

TEST(Membrane, AnEquilateralTriangleOfEdgesAndAreaIsThePlaneStressMaterial) {
  Material material;
  material.poisson_ratio = 0.4;
  const std::array<Vector2, 3> flat{Vector2(0, 0), Vector2(0.01, 0),
                                    Vector2(0.005, 0.005 * std::sqrt(3.0))};
  const MembraneElement expected(flat, material);
  const EdgeAreaMembrane element(flat, material);
  const double e = 1e-6;
  Eigen::Matrix2d stretch;
  for (const auto& [xx, yy, xy] : {std::array<double, 3>{1, 0, 0}, {0.3, -1, 0}, {0, 0, 1}}) {
    stretch << 1 + e * xx, e * xy, e * xy, 1 + e * yy;
    TrianglePoints x;
    for (int k = 0; k < 3; ++k) {
      x[k].setZero();
      x[k].head<2>() = stretch * flat[k];
    }
    EXPECT_NEAR(element.energy(x, kUnset) / expected.energy(x, kUnset), 1, 1e-5);
  }
}

}  // namespace
}  // namespace shell_origami
