#include "shell/membrane.h"

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
  return (mean + radius) / (2 * radius) *
         (s - (mean - radius) * Eigen::Matrix2d::Identity());
}

}  // namespace

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

Eigen::Matrix2d MembraneElement::stress(const Deformation& f) const {
  const Eigen::Matrix2d strain = (f.transpose() * f - Eigen::Matrix2d::Identity()) / 2;
  return lambda_ * strain.trace() * Eigen::Matrix2d::Identity() + 2 * mu_ * strain;
}

double MembraneElement::energy(const TrianglePoints& x) const {
  const Deformation f = deformation(x);
  const Eigen::Matrix2d strain = (f.transpose() * f - Eigen::Matrix2d::Identity()) / 2;
  return lambda_ / 2 * strain.trace() * strain.trace() + mu_ * strain.squaredNorm();
}

MembraneGradient MembraneElement::gradient(const TrianglePoints& x) const {
  const Deformation f = deformation(x);
  const Deformation force = f * stress(f);
  MembraneGradient gradient;
  for (int k = 0; k < 3; ++k) gradient.segment<3>(3 * k) = force * shape_.row(k).transpose();
  return gradient;
}

MembraneHessian MembraneElement::hessian(const TrianglePoints& x, bool projected) const {
  const Deformation f = deformation(x);
  const Eigen::Matrix2d s = projected ? clampToTension(stress(f)) : stress(f);
  const Eigen::Matrix3d ff = f * f.transpose();
  const Eigen::Matrix3d fb = f * shape_.transpose();  // column k: F b_k
  MembraneHessian hessian;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Eigen::RowVector2d bi = shape_.row(i), bj = shape_.row(j);
      Eigen::Matrix3d block = lambda_ * fb.col(i) * fb.col(j).transpose() +
                              mu_ * fb.col(j) * fb.col(i).transpose() + mu_ * bi.dot(bj) * ff;
      block.diagonal().array() += (bi * s).dot(bj);
      hessian.block<3, 3>(3 * i, 3 * j) = block;
    }
  }
  return hessian;
}

double MembraneElement::areaRatio(const TrianglePoints& x) const {
  const Deformation f = deformation(x);
  return f.col(0).cross(f.col(1)).norm();
}

}  // namespace shell_origami
