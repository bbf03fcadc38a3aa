#include "dynamics/newton.h"

#include <cmath>

namespace shell_origami {
namespace {

/// After this many iterations the exact Hessian takes the Gauss-Newton one's place, wherever it is
/// positive definite (the inertia mostly makes it so): where paper is about to buckle, a Hessian
/// without its negative parts needed hundreds of iterations.
constexpr int kPatience = 3;
/// Sufficient decrease of the line search (Armijo), and how often it halves the step.
constexpr double kDecrease = 1e-4;
constexpr int kHalvings = 25;
/// Rounding in the objective, relative to it: a rise below this is none.
constexpr double kRounding = 1e-13;

/// What a step must bring the objective down to: `slope` is its first-order change.
double enough(double start, double slope) {
  return start + kDecrease * slope + kRounding * std::abs(start);
}

}  // namespace

void Newton::setTopology(const Shell& shell, const std::vector<bool>& free) {
  unknown_count_ = 0;
  unknown_.assign(free.size(), -1);
  for (std::size_t v = 0; v < free.size(); ++v) {
    if (free[v]) unknown_[v] = unknown_count_++;
  }
  matrix_ = SystemMatrix(shell, unknown_, unknown_count_);
  if (unknown_count_ > 0) cholesky_.analyze(matrix_);
}

double Newton::objective(const Shell& shell, const Inertia& inertia, const Positions& x) const {
  const double distance =
      (x - inertia.anchor).colwise().squaredNorm().dot(shell.masses().transpose());
  return shell.energy(x, angles_) + inertia.stiffness / 2 * distance;
}

/// Newton's step from x into step_. False when the matrix cannot be factorized.
bool Newton::direction(const Shell& shell, const Inertia& inertia, const Positions& x,
                       HessianKind kind) {
  gradient_ = inertia.stiffness * (x - inertia.anchor) * shell.masses().asDiagonal();
  shell.addGradient(x, angles_, gradient_);
  matrix_.setZero();
  shell.forEachHessian(x, angles_, kind,
                       [this](int stencil, const auto& block) { matrix_.add(stencil, block); });
  right_hand_side_.resize(matrix_.size());
  for (std::size_t v = 0; v < unknown_.size(); ++v) {
    if (unknown_[v] < 0) continue;
    matrix_.addToDiagonal(unknown_[v], inertia.stiffness * shell.masses()[v]);
    right_hand_side_.segment<3>(3 * unknown_[v]) = -gradient_.col(v);
  }
  if (!right_hand_side_.allFinite() || !cholesky_.factorize(matrix_)) return false;
  cholesky_.solve(right_hand_side_);
  step_.setZero(3, x.cols());
  for (std::size_t v = 0; v < unknown_.size(); ++v) {
    if (unknown_[v] >= 0) step_.col(v) = right_hand_side_.segment<3>(3 * unknown_[v]);
    else gradient_.col(v).setZero();
  }
  return step_.allFinite();
}

/// Newton's step from x, by the Hessian that suits this iteration.
bool Newton::computeStep(const Shell& shell, const Inertia& inertia, const Positions& x,
                         NewtonResult& result) {
  shell.foldAngles(x, angles_);
  ++result.iterations;
  ++result.factorizations;
  bool found = result.iterations > kPatience &&
               direction(shell, inertia, x, HessianKind::kExact);
  if (!found) {
    if (result.iterations > kPatience) ++result.factorizations;
    found = direction(shell, inertia, x, HessianKind::kGaussNewton);
  }
  if (!found) return false;
  result.last_step = std::sqrt(step_.colwise().squaredNorm().maxCoeff(&result.vertex));
  step_ *= shell.safeStep(x, angles_, step_);
  return true;
}

/// Shortens the step from the base until the objective falls enough, and leaves trial_ there.
bool Newton::backtrack(const Shell& shell, const Inertia& inertia) {
  angles_ = base_.angles;
  double fraction = 0.5;
  for (int i = 0; i < kHalvings; ++i, fraction /= 2) {
    trial_ = base_.x + fraction * base_.step;
    const double value = objective(shell, inertia, trial_);
    if (value <= enough(base_.value, fraction * base_.slope)) return true;
  }
  return false;
}

NewtonResult Newton::minimize(const Shell& shell, const Inertia& inertia, double tolerance,
                              int max_iterations, Positions& x) {
  NewtonResult result;
  if (unknown_count_ == 0) {
    result.converged = true;
    return result;
  }
  bool uphill = false;  // x is one step beyond the base, and higher
  while (result.iterations < max_iterations) {
    if (!computeStep(shell, inertia, x, result)) {
      result.failure = "the system matrix could not be factorized";
      return result;
    }
    if (!uphill) {
      base_ = {x, step_, angles_, objective(shell, inertia, x),
               gradient_.cwiseProduct(step_).sum()};
    }
    const bool close = result.last_step <= tolerance;
    trial_ = x + step_;
    const double value = objective(shell, inertia, trial_);
    const bool fell = value <= enough(base_.value, base_.slope);
    if (!fell && !uphill && !close && std::isfinite(value)) {
      uphill = true;
      x.swap(trial_);
      continue;
    }
    const bool found = fell || backtrack(shell, inertia);
    x = found ? trial_ : base_.x;
    if (close && (fell || !uphill)) {
      result.converged = true;
      return result;
    }
    if (!found) {
      result.failure = "the line search found no lower energy";
      return result;
    }
    uphill = false;
  }
  result.failure = "Newton's method did not converge in " + std::to_string(max_iterations) +
                   " iterations";
  return result;
}

}  // namespace shell_origami
