#include <shell_origami/dynamics/newton.h>

#include <shell_origami/base/timer.h>

#include <cmath>

namespace shell_origami {
namespace {

/// A step that an old factor gives and that is not this much shorter than the last is thrown away
/// for that of a new factor: solving again costs a tenth of a factorization, a bad step several.
constexpr double kShrinks = 0.2;
/// How many solves in a row may end at their first step by what is known of the second, and how
/// much shorter than the tolerance that must be.
constexpr int kUnchecked = 3;
constexpr double kSafety = 4;
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

SolverTimes& SolverTimes::operator+=(const SolverTimes& other) {
  symbolic += other.symbolic;
  assembly += other.assembly;
  numeric += other.numeric;
  solve += other.solve;
  search += other.search;
  return *this;
}

void Newton::setTopology(const Shell& shell, const std::vector<bool>& free) {
  unknown_count_ = 0;
  unknown_.assign(free.size(), -1);
  for (std::size_t v = 0; v < free.size(); ++v) {
    if (free[v]) unknown_[v] = unknown_count_++;
  }
  if (unknown_count_ == 0) return;
  const std::vector<int> order = eliminationOrder(VertexGraph(shell, unknown_, unknown_count_));
  std::vector<int> place(unknown_count_);
  for (int i = 0; i < unknown_count_; ++i) place[order[i]] = i;
  for (int& row : unknown_) {
    if (row >= 0) row = place[row];
  }
  matrix_ = BlockMatrix(shell, unknown_, unknown_count_);
  cholesky_.analyze(matrix_);
}

double Newton::objective(const Shell& shell, const Inertia& inertia, const Positions& x,
                         const std::vector<FoldAngle>& before,
                         std::vector<FoldAngle>& angles) const {
  const double distance =
      (x - inertia.anchor).colwise().squaredNorm().dot(shell.masses().transpose());
  return shell.energy(x, before, angles) + inertia.stiffness / 2 * distance;
}

/// False where x is no configuration that the paper can come to from `before`.
bool Newton::start(const Shell& shell, const Inertia& inertia, const Positions& before,
                   const Positions& x, NewtonResult& result) {
  const Timer timer(result.times.search);
  shell.foldAngles(before, angles_before_);
  shell.strains(before, strains_);
  factorized_ = false;
  value_ = objective(shell, inertia, x, angles_before_, angles_);
  return std::isfinite(value_);
}

bool Newton::assembleAndFactorize(const Shell& shell, const Inertia& inertia, const Positions& x,
                                  HessianKind kind, NewtonResult& result) {
  {
    const Timer timer(result.times.assembly);
    matrix_.setZero();
    shell.forEachHessian(x, angles_, angle_gradients_, strains_, kind,
                         [this](int stencil, const auto& block) { matrix_.add(stencil, block); });
    for (std::size_t v = 0; v < unknown_.size(); ++v) {
      if (unknown_[v] < 0) continue;
      matrix_.addToDiagonal(unknown_[v], inertia.stiffness * shell.masses()[v]);
    }
  }
  const Timer timer(result.times.numeric);
  ++result.factorizations;
  return cholesky_.factorize(matrix_);
}

/// The exact Hessian where the paper is bent, which the inertia mostly makes positive definite, and
/// where it is not the Gauss-Newton one: without its negative parts a Hessian converges slowly,
/// where paper is about to buckle not for hundreds of iterations.
bool Newton::factorize(const Shell& shell, const Inertia& inertia, const Positions& x,
                       NewtonResult& result) {
  factorized_ = assembleAndFactorize(shell, inertia, x, HessianKind::kExactWhereBent, result) ||
                assembleAndFactorize(shell, inertia, x, HessianKind::kGaussNewton, result);
  return factorized_;
}

/// The factor's step down the gradient into step_. Returns its largest displacement [m].
double Newton::solve(NewtonResult& result) {
  const Timer timer(result.times.solve);
  right_hand_side_.resize(matrix_.size());
  for (std::size_t v = 0; v < unknown_.size(); ++v) {
    if (unknown_[v] >= 0) right_hand_side_.segment<3>(3 * unknown_[v]) = -gradient_.col(v);
  }
  cholesky_.solve(right_hand_side_);
  for (std::size_t v = 0; v < unknown_.size(); ++v) {
    if (unknown_[v] >= 0) step_.col(v) = right_hand_side_.segment<3>(3 * unknown_[v]);
  }
  return std::sqrt(step_.colwise().squaredNorm().maxCoeff(&result.vertex));
}

/// Newton's step from x into step_, as far as hinges may turn. False when the matrix cannot be
/// factorized.
bool Newton::computeStep(const Shell& shell, const Inertia& inertia, const Positions& x,
                         NewtonResult& result) {
  ++result.iterations;
  {
    const Timer timer(result.times.assembly);
    shell.angleGradients(x, angle_gradients_);
    gradient_ = inertia.stiffness * (x - inertia.anchor) * shell.masses().asDiagonal();
    shell.addGradient(x, angles_, angle_gradients_, gradient_);
    for (std::size_t v = 0; v < unknown_.size(); ++v) {
      if (unknown_[v] < 0) gradient_.col(v).setZero();
    }
  }
  if (!gradient_.allFinite()) return false;
  step_.setZero(3, x.cols());
  const bool old = factorized_;
  if (!old && !factorize(shell, inertia, x, result)) return false;
  double length = solve(result);
  if (old && result.iterations == 2) memory_.contraction = length / result.last_step;
  if (old && !(length < kShrinks * result.last_step)) {
    if (!factorize(shell, inertia, x, result)) return false;
    length = solve(result);
  }
  result.last_step = length;
  const Timer timer(result.times.search);
  step_ *= shell.maxFeasibleStep(angles_, angle_gradients_, step_);
  shell.strainsAfter(x, step_, strains_);
  return step_.allFinite();
}

/// Whether the paper is within the tolerance once it has taken this step: because the step is that
/// short, or because the next would be, by what the second step of a solve was to the first when
/// last looked at (Hairer & Wanner, Solving Ordinary Differential Equations II, section IV.8).
bool Newton::isClose(const NewtonResult& result, double tolerance) {
  if (result.last_step <= tolerance) return true;
  const bool expected = result.iterations == 1 && memory_.unchecked < kUnchecked &&
                        kSafety * memory_.contraction * result.last_step <= tolerance;
  memory_.unchecked = expected ? memory_.unchecked + 1 : 0;
  return expected;
}

/// Shortens the step from the base until the objective falls enough, and leaves trial_ there.
bool Newton::backtrack(const Shell& shell, const Inertia& inertia) {
  double fraction = 1;
  for (int i = 0; i < kHalvings; ++i) {
    fraction /= 2;
    base_.step /= 2;
    trial_ = base_.x + base_.step;
    trial_value_ = objective(shell, inertia, trial_, base_.angles, trial_angles_);
    if (trial_value_ > enough(base_.value, fraction * base_.slope)) continue;
    shell.strainsAfter(base_.x, base_.step, strains_);
    return true;
  }
  return false;
}

void Newton::remember(const Positions& x) {
  base_.x = x;
  base_.step = step_;
  base_.angles = angles_;
  base_.value = value_;
  base_.slope = gradient_.cwiseProduct(step_).sum();
}

/// Goes on to the trial.
void Newton::advance(Positions& x) {
  x.swap(trial_);
  angles_.swap(trial_angles_);
  value_ = trial_value_;
}

NewtonResult Newton::minimize(const Shell& shell, const Inertia& inertia, const Positions& before,
                              double tolerance, int max_iterations, Positions& x) {
  NewtonResult result;
  if (!start(shell, inertia, before, x, result)) {
    const auto fault = shell.findInfeasibility(x, angles_before_);
    result.failure = fault ? fault->what : "the energy is not finite";
    if (fault) result.vertex = fault->vertex;
    return result;
  }
  result.converged = unknown_count_ == 0;
  bool uphill = false;  // x is one step beyond the base, and higher
  while (!result.converged) {
    if (result.iterations == max_iterations) {
      result.failure =
          "Newton's method did not converge in " + std::to_string(max_iterations) + " iterations";
      return result;
    }
    if (!computeStep(shell, inertia, x, result)) {
      result.failure = "the system matrix could not be factorized";
      return result;
    }
    const Timer timer(result.times.search);
    if (!uphill) remember(x);
    const bool close = isClose(result, tolerance);
    trial_ = x + step_;
    trial_value_ = objective(shell, inertia, trial_, angles_, trial_angles_);
    const bool fell = trial_value_ <= enough(base_.value, base_.slope);
    if (!fell) factorized_ = false;
    if (!fell && !uphill && !close && std::isfinite(trial_value_)) {
      uphill = true;
      advance(x);
      continue;
    }
    const bool found = fell || backtrack(shell, inertia);
    result.converged = close && (fell || !uphill);
    if (found) advance(x);
    else x = base_.x;
    if (!found && !result.converged) {
      result.failure = "the line search found no lower energy";
      return result;
    }
    uphill = false;
  }
  if (const auto fault = shell.findJump(angles_before_, angles_)) {
    result.converged = false;
    result.failure = fault->what;
    result.vertex = fault->vertex;
  }
  return result;
}

}  // namespace shell_origami
