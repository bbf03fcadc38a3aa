#include <shell_origami/energy/membrane.h>

#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

/// The nearest positive semidefinite matrix.
Eigen::Matrix2d clampToTension(const Eigen::Matrix2d& s) {
  const double mean = (s(0, 0) + s(1, 1)) / 2, half = (s(0, 0) - s(1, 1)) / 2;
  const double radius = std::hypot(half, s(0, 1));
  if (mean - radius >= 0) return s;
  if (mean + radius <= 0) return Eigen::Matrix2d::Zero();
  // One eigenvalue is positive: keep its part, (s - low I) (mean + radius) / (2 radius).
  return (mean + radius) / (2 * radius) * (s - (mean - radius) * Eigen::Matrix2d::Identity());
}

Eigen::Matrix2d matrixOf(const MembraneStrain& strain) {
  Eigen::Matrix2d e;
  e << strain[0], strain[2], strain[2], strain[1];
  return e;
}

}  // namespace

Eigen::Matrix2d greenStrain(const Eigen::Matrix<double, 3, 2>& f) {
  return (f.transpose() * f - Eigen::Matrix2d::Identity()) / 2;
}

Eigen::Matrix2d metricOf(const GreenStrain& green) {
  Eigen::Matrix2d metric;
  metric << 1 + 2 * green[0], 2 * green[2], 2 * green[2], 1 + 2 * green[1];
  return metric;
}

MembraneElement::MembraneElement(const std::array<Vector2, 3>& flat, const Material& material) {
  const double area2 = doubleArea(flat[0], flat[1], flat[2]);
  for (int k = 0; k < 3; ++k) {
    const Vector2 edge = flat[(k + 2) % 3] - flat[(k + 1) % 3];
    shape_.row(k) = Eigen::RowVector2d(-edge.y(), edge.x()) / area2;
  }
  lambda_ = area2 / 2 * material.membraneLambda();
  mu_ = area2 / 2 * material.membraneMu();
}

MembraneElement::Deformation MembraneElement::deformation(const TrianglePoints& x) const {
  // Differences first: a shape function's gradients sum to zero.
  return (x[1] - x[0]) * shape_.row(1) + (x[2] - x[0]) * shape_.row(2);
}

Eigen::Matrix2d MembraneElement::stress(const Eigen::Matrix2d& strain) const {
  return lambda_ * strain.trace() * Eigen::Matrix2d::Identity() + 2 * mu_ * strain;
}

double MembraneElement::energy(const TrianglePoints& x, const MembraneStrain& rest) const {
  const Eigen::Matrix2d strain = greenStrain(deformation(x)) - matrixOf(rest);
  return lambda_ / 2 * strain.trace() * strain.trace() + mu_ * strain.squaredNorm();
}

MembraneGradient MembraneElement::gradient(const TrianglePoints& x,
                                           const MembraneStrain& rest) const {
  const Deformation f = deformation(x);
  const Deformation force = f * stress(greenStrain(f) - matrixOf(rest));
  MembraneGradient gradient;
  gradient.segment<3>(3) = force * shape_.row(1).transpose();
  gradient.segment<3>(6) = force * shape_.row(2).transpose();
  gradient.segment<3>(0) = -gradient.segment<3>(3) - gradient.segment<3>(6);
  return gradient;
}

MembraneStrain MembraneElement::strain(const TrianglePoints& x) const {
  const Eigen::Matrix2d e = greenStrain(deformation(x));
  return {e(0, 0), e(1, 1), e(0, 1), 0};
}

MembraneStrain MembraneElement::strainAfter(const TrianglePoints& x, const TrianglePoints& along,
                                            const TrianglePoints& displacement) const {
  const Deformation df = deformation(displacement);
  const Eigen::Matrix2d e = greenStrain(deformation(x)),
                        turned = deformation(along).transpose() * df;
  return {e(0, 0) + turned(0, 0), e(1, 1) + turned(1, 1),
          e(0, 1) + (turned(0, 1) + turned(1, 0)) / 2, 0};
}

// Corners 1 and 2 only: the shape functions' gradients sum to zero, so that the rows and columns of
// corner 0 are what makes those of the whole vanish.
MembraneHessian MembraneElement::hessian(const TrianglePoints& x, const MembraneStrain& strain,
                                         bool projected) const {
  const Deformation f = deformation(x);
  const Eigen::Matrix2d own = stress(matrixOf(strain));
  const Eigen::Matrix2d s = projected ? clampToTension(own) : own;
  const Eigen::Matrix3d ff = mu_ * f * f.transpose();
  const Eigen::Matrix3d fb = f * shape_.transpose();  // column k: F b_k
  const auto block = [&](int i, int j) -> Eigen::Matrix3d {
    const Eigen::RowVector2d bi = shape_.row(i), bj = shape_.row(j);
    Eigen::Matrix3d block = lambda_ * fb.col(i) * fb.col(j).transpose() +
                            mu_ * fb.col(j) * fb.col(i).transpose() + bi.dot(bj) * ff;
    block.diagonal().array() += (bi * s).dot(bj);
    return block;
  };
  const Eigen::Matrix3d h11 = block(1, 1), h22 = block(2, 2), h21 = block(2, 1);
  const Eigen::Matrix3d h10 = -h11 - h21.transpose(), h20 = -h21 - h22;
  MembraneHessian hessian;
  hessian << -h10 - h20, h10.transpose(), h20.transpose(),  //
      h10, h11, h21.transpose(),                            //
      h20, h21, h22;
  return hessian;
}

double MembraneElement::areaRatio(const TrianglePoints& x) const {
  const Deformation f = deformation(x);
  return f.col(0).cross(f.col(1)).norm();
}

}  // namespace shell_origami
