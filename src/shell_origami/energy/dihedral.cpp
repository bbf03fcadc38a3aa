#include <shell_origami/energy/dihedral.h>

#include <shell_origami/base/geometry.h>

#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// One wing of the hinge: triangle p, q, r with the hinge edge p -> q and normal
/// n = (q - p) x (r - p). Raising r out of the plane turns the wing by |e| / |n| per metre.
struct Wing {
  Vector3d p, q, r;

  Vector3d edge() const { return q - p; }
  Vector3d normal() const { return edge().cross(r - p); }
  /// d(turn)/dr = |e| n / |n|^2.
  Vector3d turn() const {
    const Vector3d n = normal();
    return edge().norm() / n.squaredNorm() * n;
  }
  /// Returns the projection of r onto the edge: 0 at p, 1 at q.
  double foot() const { return edge().dot(r - p) / edge().squaredNorm(); }

  /// Derivatives of turn() with respect to p, q, r.
  std::array<Matrix3d, 3> turnJacobian() const {
    const Vector3d e = edge(), n = normal();
    const double length = e.norm(), n2 = n.squaredNorm();
    const Matrix3d by_normal = length / n2 * (Matrix3d::Identity() - 2 / n2 * n * n.transpose());
    const Matrix3d by_edge = n / n2 * e.transpose() / length;
    const Matrix3d dq = -by_normal * crossMatrix(r - p) + by_edge;
    const Matrix3d dr = by_normal * crossMatrix(e);
    return {-dq - dr, dq, dr};
  }
  /// Derivatives of foot() with respect to p, q, r.
  std::array<Vector3d, 3> footGradient() const {
    const Vector3d e = edge(), d = r - p;
    const double e2 = e.squaredNorm(), s = foot();
    const Vector3d dq = (d - 2 * s * e) / e2, dr = e / e2;
    return {-dq - dr, dq, dr};
  }
};

Wing left(const HingePoints& x) { return {x[0], x[1], x[2]}; }
Wing right(const HingePoints& x) { return {x[1], x[0], x[3]}; }

/// Adds one wing's share of the Hessian. `at` are the hinge's indices of p, q, r.
void addWing(const Wing& wing, const std::array<int, 3>& at, HingeHessian& hessian) {
  const Vector3d turn = wing.turn();
  const auto turn_jacobian = wing.turnJacobian();
  const auto foot_gradient = wing.footGradient();
  const double s = wing.foot();
  for (int k = 0; k < 3; ++k) {
    const Matrix3d foot_part = turn * foot_gradient[k].transpose();
    hessian.block<3, 3>(3 * at[2], 3 * at[k]) += turn_jacobian[k];
    hessian.block<3, 3>(3 * at[1], 3 * at[k]) -= s * turn_jacobian[k] + foot_part;
    hessian.block<3, 3>(3 * at[0], 3 * at[k]) -= (1 - s) * turn_jacobian[k] - foot_part;
  }
}

}  // namespace

FoldAngle foldAngle(const HingePoints& x) {
  const Vector3d e = x[1] - x[0];
  const Vector3d n1 = e.cross(x[2] - x[0]), n2 = (x[3] - x[1]).cross(e);
  const double sine = n2.cross(n1).dot(e), cosine = n1.dot(n2) * e.norm();
  const double one = std::sqrt(sine * sine + cosine * cosine);
  if (one == 0) return {};  // a wing without area
  // Of two forms of the same, that which subtracts nothing.
  const double half_tangent = cosine < 0 ? (one - cosine) / sine : sine / (one + cosine);
  return {2 * std::atan(half_tangent), half_tangent};
}

HingeGradient foldAngleGradient(const HingePoints& x) {
  const Vector3d e = x[1] - x[0], a = x[2] - x[0], b = x[3] - x[1];
  const Vector3d n1 = e.cross(a), n2 = b.cross(e);
  const double e2 = e.squaredNorm(), length = std::sqrt(e2);
  const Vector3d ta = length / n1.squaredNorm() * n1, tb = length / n2.squaredNorm() * n2;
  const double foot_a = e.dot(a) / e2, foot_b = -e.dot(b) / e2;  // from x0, from x1
  HingeGradient gradient;
  gradient.segment<3>(0) = (foot_a - 1) * ta - foot_b * tb;
  gradient.segment<3>(3) = -foot_a * ta + (foot_b - 1) * tb;
  gradient.segment<3>(6) = ta;
  gradient.segment<3>(9) = tb;
  return gradient;
}

HingeHessian foldAngleHessian(const HingePoints& x) {
  HingeHessian hessian = HingeHessian::Zero();
  addWing(left(x), {0, 1, 2}, hessian);
  addWing(right(x), {1, 0, 3}, hessian);
  return hessian;
}

Phi phi(const FoldAngle& theta) {
  const double tangent = theta.half_tangent, secant2 = 1 + tangent * tangent;
  return {2 * tangent, secant2, secant2 * tangent};
}

Bend hingeBend(const FoldAngle& theta, const FoldAngle& rest) {
  const Phi p = phi(theta);
  return {p.value - phi(rest).value, p.first, p.second};
}

Bend creaseBend(const FoldAngle& theta, const FoldAngle& rest) {
  // Mirrored so that rest >= 0.
  const double sign = rest.radians < 0 ? -1 : 1;
  const double turned = sign * theta.radians, at_rest = sign * rest.radians;
  if (turned >= 0 && turned <= at_rest) return {theta.radians - rest.radians, 1, 0};
  const Phi p = phi(theta);
  if (turned < 0) return {p.value - rest.radians, p.first, p.second};
  const Phi r = phi(rest);
  return {(p.value - r.value) / r.first, p.first / r.first, p.second / r.first};
}

}  // namespace shell_origami
