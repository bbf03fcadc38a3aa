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

/// Moves trial_ along step_ until the objective falls enough. Returns the fraction of the step,
/// or 0 when there is none.
double Newton::search(const Shell& shell, const Inertia& inertia, const Positions& x) {
  const double start = objective(shell, inertia, x);
  const double slope = gradient_.cwiseProduct(step_).sum();
  double fraction = shell.safeStep(x, angles_, step_);
  for (int i = 0; i < kHalvings; ++i, fraction /= 2) {
    trial_ = x + fraction * step_;
    const double rounding = kRounding * std::abs(start);
    if (objective(shell, inertia, trial_) <= start + kDecrease * fraction * slope + rounding) {
      return fraction;
    }
  }
  return 0;
}

NewtonResult Newton::minimize(const Shell& shell, const Inertia& inertia, double tolerance,
                              int max_iterations, Positions& x) {
  NewtonResult result;
  if (unknown_count_ == 0) {
    result.converged = true;
    return result;
  }
  while (result.iterations < max_iterations) {
    ++result.iterations;
    shell.foldAngles(x, angles_);
    const bool patient = result.iterations <= kPatience;
    result.factorizations += patient ? 1 : 2;
    if (!patient && direction(shell, inertia, x, HessianKind::kExact)) --result.factorizations;
    else if (!direction(shell, inertia, x, HessianKind::kGaussNewton)) {
      result.failure = "the system matrix could not be factorized";
      return result;
    }
    result.last_step = std::sqrt(step_.colwise().squaredNorm().maxCoeff(&result.vertex));
    const double fraction = search(shell, inertia, x);
    if (fraction > 0) x.swap(trial_);
    if (result.last_step <= tolerance) {
      result.converged = true;
      return result;
    }
    if (fraction == 0) {
      result.failure = "the line search found no lower energy";
      return result;
    }
  }
  result.failure = "Newton's method did not converge in " + std::to_string(max_iterations) +
                   " iterations";
  return result;
}

}  // namespace shell_origami
