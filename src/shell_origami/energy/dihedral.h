/// \file
/// The fold angle of a hinge and its derivatives.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace shell_origami {

/// Four points of a hinge. The shared edge runs from x0 to x1; x2 lies left of it and x3 right,
/// seen from the front of the paper:
///
///          x2
///        /    \           .
///      x0 ---> x1
///        \    /           .
///          x3
///
/// The fold angle theta is the deviation from flat: 0 is flat; a valley, whose flaps rise towards
/// the front, is positive. It lies in [-pi, pi].
using HingePoints = std::array<Eigen::Vector3d, 4>;
using HingeGradient = Eigen::Matrix<double, 12, 1>;
using HingeHessian = Eigen::Matrix<double, 12, 12>;

/// A fold angle and the tangent of its half, which bending energies are made of: the points of a
/// hinge give that tangent with no more than a root. It is infinite where the hinge is shut.
struct FoldAngle {
  FoldAngle() = default;
  FoldAngle(double radians) : radians(radians), half_tangent(std::tan(radians / 2)) {}
  FoldAngle(double radians, double half_tangent) : radians(radians), half_tangent(half_tangent) {}

  double radians = 0;  ///< in [-pi, pi]
  double half_tangent = 0;
};

FoldAngle foldAngle(const HingePoints& x);

/// d theta / d (x0, x1, x2, x3). Tamstorf & Grinspun, Discrete bending forces and their Jacobians
/// (2013), section 3.
HingeGradient foldAngleGradient(const HingePoints& x);

/// d^2 theta / dx^2, by differentiating the gradient's closed form once more.
HingeHessian foldAngleHessian(const HingePoints& x);

/// phi = 2 tan(theta / 2), which goes to infinity at +-pi (Discrete Shells Origami, figure 11),
/// and its derivatives.
struct Phi {
  double value, first, second;
};
Phi phi(const FoldAngle& theta);

/// Deviation of a hinge from rest, of whose square its energy is a multiple, and its derivatives by
/// theta. Zero at rest.
using Bend = Phi;

/// A hinge of the sheet: phi(theta) - phi(rest) (Discrete Shells Origami, figure 11).
Bend hingeBend(const FoldAngle& theta, const FoldAngle& rest);

/// A crease: first derivative 1 at rest, so that a crease's stiffness means the same at every rest
/// angle. Towards the half turn on the side of its rest angle it goes as phi, divided by
/// phi'(rest); between rest and flat it is theta - rest; beyond flat it goes as phi again:
///
///        / (phi(theta) - phi(rest)) / phi'(rest)    theta >= rest
///   u = <  theta - rest                             0 <= theta <= rest
///        \ phi(theta) - rest                        theta <= 0        (for rest >= 0)
///
/// Twice continuously differentiable times its value. With the first line alone a crease at rest
/// at 170 degrees would pull with a hundredth of its stiffness once opened by 30 degrees: a fold
/// asked for at once would hardly start.
Bend creaseBend(const FoldAngle& theta, const FoldAngle& rest);

}  // namespace shell_origami
