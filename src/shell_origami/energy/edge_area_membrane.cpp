#include <shell_origami/energy/edge_area_membrane.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The corners at the ends of the edge opposite corner k.
int from(int k) { return (k + 1) % 3; }
int to(int k) { return (k + 2) % 3; }

Vector3d edge(const TrianglePoints& x, int k) { return x[to(k)] - x[from(k)]; }

Vector3d normal(const TrianglePoints& x) { return (x[1] - x[0]).cross(x[2] - x[0]); }

/// d(area)/dx: each corner pulls across its opposite edge.
MembraneGradient areaGradient(const TrianglePoints& x) {
  const Vector3d n = normal(x).normalized();
  MembraneGradient gradient;
  for (int k = 0; k < 3; ++k) gradient.segment<3>(3 * k) = n.cross(edge(x, k)) / 2;
  return gradient;
}

/// d^2(area)/dx^2. The normal N = sum_k x_k x x_(k+1) changes by d x (x_(k+1) - x_(k+2)) as corner
/// k moves by d.
MembraneHessian areaHessian(const TrianglePoints& x) {
  const Vector3d big = normal(x);
  const double length = big.norm();
  const Vector3d n = big / length;
  Eigen::Matrix<double, 3, 9> turn;
  for (int k = 0; k < 3; ++k) turn.block<3, 3>(0, 3 * k) = crossMatrix(edge(x, k));
  MembraneHessian hessian =
      turn.transpose() * (Matrix3d::Identity() - n * n.transpose()) * turn / (2 * length);
  for (int k = 0; k < 3; ++k) {
    const Matrix3d half = -crossMatrix(n) / 2;
    hessian.block<3, 3>(3 * k, 3 * from(k)) += half;
    hessian.block<3, 3>(3 * from(k), 3 * k) += half.transpose();
  }
  return hessian;
}

}  // namespace

EdgeAreaMembrane::EdgeAreaMembrane(const std::array<Vector2, 3>& flat, const Material& material)
    : area_(doubleArea(flat[0], flat[1], flat[2]) / 2) {
  for (int k = 0; k < 3; ++k) {
    edges_[k] = flat[to(k)] - flat[from(k)];
    lengths_[k] = edges_[k].norm();
  }
  const double mu = material.membraneMu(), lambda = material.membraneLambda();
  edge_stiffness_ = area_ * 4 / 3 * mu;
  area_stiffness_ = area_ * std::max(0.0, (lambda - mu) / 2);
}

double EdgeAreaMembrane::areaRatio(const TrianglePoints& x) const {
  return normal(x).norm() / 2 / area_;
}

MembraneStrain EdgeAreaMembrane::strain(const TrianglePoints& x) const {
  MembraneStrain strain;
  for (int k = 0; k < 3; ++k) strain[k] = edge(x, k).norm() / lengths_[k] - 1;
  strain[3] = areaRatio(x) - 1;
  return strain;
}

MembraneStrain EdgeAreaMembrane::strainAfter(const TrianglePoints& x, const TrianglePoints& along,
                                             const TrianglePoints& displacement) const {
  MembraneStrain after = strain(x);
  const MembraneGradient swell = areaGradient(along) / area_;
  for (int k = 0; k < 3; ++k) {
    after[k] += edge(along, k).normalized().dot(edge(displacement, k)) / lengths_[k];
    after[3] += swell.segment<3>(3 * k).dot(displacement[k]);
  }
  return after;
}

MembraneStrain EdgeAreaMembrane::strainOf(const GreenStrain& green) const {
  const Eigen::Matrix2d metric = metricOf(green);
  MembraneStrain strain;
  for (int k = 0; k < 3; ++k) {
    strain[k] = std::sqrt(edges_[k].dot(metric * edges_[k])) / lengths_[k] - 1;
  }
  strain[3] = std::sqrt(metric.determinant()) - 1;
  return strain;
}

double EdgeAreaMembrane::energy(const TrianglePoints& x, const MembraneStrain& rest) const {
  const MembraneStrain s = strain(x) - rest;
  return edge_stiffness_ * s.head<3>().squaredNorm() + area_stiffness_ * s[3] * s[3];
}

MembraneGradient EdgeAreaMembrane::gradient(const TrianglePoints& x,
                                            const MembraneStrain& rest) const {
  const MembraneStrain s = strain(x) - rest;
  MembraneGradient gradient = 2 * area_stiffness_ * s[3] / area_ * areaGradient(x);
  for (int k = 0; k < 3; ++k) {
    const Vector3d e = edge(x, k);
    const double length = e.norm();
    const Vector3d pull = 2 * edge_stiffness_ * s[k] / lengths_[k] / length * e;
    gradient.segment<3>(3 * to(k)) += pull;
    gradient.segment<3>(3 * from(k)) -= pull;
  }
  return gradient;
}

MembraneHessian EdgeAreaMembrane::hessian(const TrianglePoints& x, const MembraneStrain& strain,
                                          bool projected) const {
  const MembraneGradient g = areaGradient(x) / area_;
  MembraneHessian hessian = 2 * area_stiffness_ * g * g.transpose();
  if (!projected) hessian += 2 * area_stiffness_ * strain[3] / area_ * areaHessian(x);
  for (int k = 0; k < 3; ++k) {
    const Vector3d e = edge(x, k);
    const double length = e.norm(), stiffness = 2 * edge_stiffness_ / lengths_[k] / lengths_[k];
    const Matrix3d along = e * e.transpose() / (length * length);
    double across = strain[k] * lengths_[k] / length;
    if (projected) across = std::max(0.0, across);
    const Matrix3d block = stiffness * (along + across * (Matrix3d::Identity() - along));
    for (int i : {from(k), to(k)}) {
      for (int j : {from(k), to(k)}) {
        if (i == j) hessian.block<3, 3>(3 * i, 3 * j) += block;
        else hessian.block<3, 3>(3 * i, 3 * j) -= block;
      }
    }
  }
  return hessian;
}

}  // namespace shell_origami
