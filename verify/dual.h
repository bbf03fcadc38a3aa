/// \file
/// Forward-mode automatic differentiation to second order.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace shell_origami {

/// A value with its gradient and Hessian by N variables.
template <int N>
struct Dual {
  using Gradient = Eigen::Matrix<double, N, 1>;
  using Hessian = Eigen::Matrix<double, N, N>;

  double value = 0;
  Gradient gradient = Gradient::Zero();
  Hessian hessian = Hessian::Zero();

  Dual() = default;
  Dual(double constant) : value(constant) {}  // NOLINT: constants mix with variables
  static Dual variable(double value, int index) {
    Dual x(value);
    x.gradient[index] = 1;
    return x;
  }

  /// Returns a function of this, given its value and its two derivatives here.
  Dual chain(double f, double first, double second) const {
    Dual y(f);
    y.gradient = first * gradient;
    y.hessian = first * hessian + second * gradient * gradient.transpose();
    return y;
  }
  Dual operator-() const { return chain(-value, -1, 0); }
};

template <int N>
Dual<N> operator+(const Dual<N>& a, const Dual<N>& b) {
  Dual<N> y(a.value + b.value);
  y.gradient = a.gradient + b.gradient;
  y.hessian = a.hessian + b.hessian;
  return y;
}

template <int N>
Dual<N> operator*(const Dual<N>& a, const Dual<N>& b) {
  Dual<N> y(a.value * b.value);
  y.gradient = a.value * b.gradient + b.value * a.gradient;
  const typename Dual<N>::Hessian mixed = a.gradient * b.gradient.transpose();
  y.hessian = a.value * b.hessian + b.value * a.hessian + mixed + mixed.transpose();
  return y;
}

template <int N>
Dual<N> operator-(const Dual<N>& a, const Dual<N>& b) {
  return a + (-b);
}

template <int N>
Dual<N> operator/(const Dual<N>& a, const Dual<N>& b) {
  const double inverse = 1 / b.value;
  return a * b.chain(inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
}

template <int N>
Dual<N> sqrt(const Dual<N>& x) {
  const double root = std::sqrt(x.value);
  return x.chain(root, 0.5 / root, -0.25 / (root * x.value));
}

template <int N>
Dual<N> tan(const Dual<N>& x) {
  const double tangent = std::tan(x.value), secant2 = 1 + tangent * tangent;
  return x.chain(tangent, secant2, 2 * tangent * secant2);
}

/// The angle of (x, y) from the axis of x: the arc tangent of the smaller over the larger one.
template <int N>
Dual<N> atan2(const Dual<N>& y, const Dual<N>& x) {
  const auto arctangent = [](const Dual<N>& t, double angle) {
    const double slope = 1 / (1 + t.value * t.value);
    return t.chain(angle, slope, -2 * t.value * slope * slope);
  };
  const double angle = std::atan2(y.value, x.value);
  if (std::abs(x.value) > std::abs(y.value)) return arctangent(y / x, angle);
  Dual<N> result = -arctangent(x / y, 0);
  result.value = angle;
  return result;
}

/// Points in space whose coordinates are the variables, in their order.
template <int N>
using DualVector = std::array<Dual<N>, 3>;

template <int N>
DualVector<N> operator-(const DualVector<N>& a, const DualVector<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <int N>
DualVector<N> scaled(const DualVector<N>& a, const Dual<N>& by) {
  return {a[0] * by, a[1] * by, a[2] * by};
}

template <int N>
Dual<N> dot(const DualVector<N>& a, const DualVector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <int N>
DualVector<N> crossProduct(const DualVector<N>& a, const DualVector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace shell_origami
