#include <shell_origami/dynamics/newton.h>

#include <shell_origami/base/timer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shell_origami {
namespace {

/// An old factor serves where its steps, shrinking as they do, come within the tolerance in so many
/// more: each costs a fifth of a factorization at 2,000 triangles, a seventh at 10,000, and a new
/// factor takes some as well.
constexpr int kMostSolves = 5;
/// Where forces may jump, steps do not go on to shrink as they did. There an old factor's step must
/// be this much shorter than the last: with the test above a sheet that slid stopped too early.
constexpr double kShrinks = 0.2;
/// How many solves in a row may end at their first step by what is known of the second, and how
/// much shorter than the tolerance that must be.
constexpr int kUnchecked = 3;
constexpr double kSafety = 4;
/// A step of which less than this part is permitted is replaced.
constexpr double kBlocked = 0.5;
/// Sufficient decrease of the line search (Armijo), and how often it halves the step.
constexpr double kDecrease = 1e-4;
constexpr int kHalvings = 25;
/// Rounding in the objective, relative to it: a rise below this is none.
constexpr double kRounding = 1e-13;

/// Returns the largest value of the objective that the line search accepts after a step whose
/// first-order change is `slope`.
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

SolverTimes& SolverTimes::operator-=(const SolverTimes& other) {
  symbolic -= other.symbolic;
  assembly -= other.assembly;
  numeric -= other.numeric;
  solve -= other.solve;
  search -= other.search;
  return *this;
}

void Newton::setFree(const std::vector<bool>& free, int first_body) {
  free_ = free;
  first_body_ = first_body;
  system_.setFree(free);
  objective_.reset();
}

bool Newton::assembleAndFactorize(const Positions& x, HessianKind kind, NewtonResult& result) {
  const std::vector<const Stencils*>& stencils = objective_.stencils();
  {
    const Timer timer(result.times.symbolic);
    const int before = system_.analyses();
    const bool prepared = system_.prepare(stencils);
    result.analyses += system_.analyses() - before;
    if (!prepared) return false;
  }
  {
    const Timer timer(result.times.assembly);
    system_.setZero();
    if (arriving_) motion_.forces.setZero(3, x.cols());
    for (std::size_t i = 0; i < stencils.size(); ++i) {
      objective_.addHessian(
          i, x, kind, arriving_ ? system_.blocks(i, *stencils[i], motion_) : system_.blocks(i));
    }
    system_.addToDiagonal(objective_.inertiaStiffness(), objective_.masses());
  }
  const Timer timer(result.times.numeric);
  ++result.factorizations;
  return system_.factorize();
}

/// The exact Hessian, which the inertia mostly makes positive definite, and where it is not the
/// convex one: without its negative parts a Hessian converges slowly, where paper is about to
/// buckle not for hundreds of iterations.
bool Newton::factorize(const Positions& x, NewtonResult& result) {
  factor_x_ = x;
  factorized_ = assembleAndFactorize(x, HessianKind::kExact, result) ||
                assembleAndFactorize(x, HessianKind::kConvex, result);
  return factorized_;
}

void Newton::setHeldZero(Positions& gradient) const {
  for (std::size_t v = 0; v < free_.size(); ++v) {
    if (!free_[v]) gradient.col(v).setZero();
  }
}

/// Computes the factor's step down the gradient into step_, and its largest displacement [m].
bool Newton::solve(const Positions& gradient, NewtonResult& result) {
  const Timer timer(result.times.solve);
  if (arriving_) {
    if (!system_.solve(gradient + motion_.forces, step_)) return false;
    step_.rightCols(bodies_.cols()) = motion_.displacements.rightCols(bodies_.cols());
  } else if (!system_.solve(gradient, step_)) {
    return false;
  }
  result.last_step = std::sqrt(step_.colwise().squaredNorm().maxCoeff(&result.vertex));
  result.error = result.last_step;
  return true;
}

/// The same with a factor of an earlier iterate. Where that serves no longer there is none
/// afterwards. The error is what is left of steps that go on to shrink as they do (Hairer & Wanner,
/// Solving Ordinary Differential Equations II, section IV.8).
bool Newton::solveWithOldFactor(const Positions& x, double tolerance, NewtonResult& result) {
  const double before = result.last_step;
  {
    const Timer timer(result.times.assembly);
    redirected_ = gradient_;
    objective_.redirect(x, factor_x_, redirected_);
    setHeldZero(redirected_);
  }
  if (!solve(redirected_, result)) return false;
  const double ratio = result.last_step / before, left = ratio / (1 - ratio);
  if (result.iterations == 2) state_.contraction = ratio;
  const bool soon = left * std::pow(ratio, kMostSolves - 1) * result.last_step <= tolerance;
  factorized_ = objective_.rough() ? ratio < kShrinks : ratio < 1 && soon;
  result.error = result.last_step * std::max(1.0, left);
  return true;
}

/// Newton's step from x into step_, as far as the potentials permit. False when the matrix cannot
/// be factorized.
bool Newton::computeStep(const Positions& x, double tolerance, NewtonResult& result) {
  ++result.iterations;
  {
    const Timer timer(result.times.assembly);
    objective_.gradient(x, gradient_);
    setHeldZero(gradient_);
    result.gradient_norm = gradient_.norm();
  }
  if (!std::isfinite(result.gradient_norm)) return false;
  step_.setZero(3, x.cols());
  if (factorized_ && !solveWithOldFactor(x, tolerance, result)) return false;
  if (!factorized_ && (!factorize(x, result) || !solve(gradient_, result))) return false;
  const Timer timer(result.times.search);
  const double part = objective_.maxFeasibleStep(x, step_);
  step_ *= part < kBlocked ? avoidImpacts(x, part, result) : part;
  return step_.allFinite();
}

/// Replaces a step of which the potentials permit only this part by one that stops at what it would
/// run into, so that all impacts of a step are met in one iteration and not each in its own.
/// Returns the part of that step that is permitted.
double Newton::avoidImpacts(const Positions& x, double part, NewtonResult& result) {
  blocked_ = step_;
  anticipated_ = gradient_;
  if (!objective_.anticipate(x, step_, anticipated_)) return part;
  setHeldZero(anticipated_);
  gradient_.swap(anticipated_);
  const double length = result.last_step;
  const bool solved = factorize(x, result) && solve(gradient_, result);
  gradient_.swap(anticipated_);
  factorized_ = false;  // the factor is that of the impacts as well
  if (solved && (arriving_ || gradient_.cwiseProduct(step_).sum() < 0)) {
    return objective_.maxFeasibleStep(x, step_);
  }
  step_ = blocked_;
  result.last_step = result.error = length;
  return part;
}

/// Whether the paper is within the tolerance once it has taken this step: because the step is that
/// short, or because the next would be, by what the second step of a solve was to the first when
/// last looked at.
bool Newton::isClose(const NewtonResult& result, double tolerance) {
  if (result.error <= tolerance) return true;
  const bool expected = !arriving_ && result.iterations == 1 && state_.unchecked < kUnchecked &&
                        kSafety * state_.contraction * result.last_step <= tolerance;
  state_.unchecked = expected ? state_.unchecked + 1 : 0;
  return expected;
}

/// Shortens the step from the base until the objective falls enough, and goes there.
bool Newton::backtrack(bool uphill) {
  double fraction = 1;
  for (int i = 0; i < kHalvings; ++i) {
    fraction /= 2;
    base_.step /= 2;
    trial_ = base_.x + base_.step;
    const double value =
        uphill ? objective_.tryFromBase(trial_) : objective_.tryFromCurrent(trial_);
    if (value > enough(base_.value, fraction * base_.slope)) continue;
    objective_.accept(base_.x, base_.along, base_.step);
    return true;
  }
  return false;
}

void Newton::remember(const Positions& x) {
  base_.x = x;
  base_.along = factor_x_;
  base_.step = step_;
  base_.value = objective_.value();
  base_.slope = gradient_.cwiseProduct(step_).sum();
}

double Newton::potentialChange(const Positions& before, const Positions& x) {
  return objective_.potentialChange(before, x);
}

/// Says whether bodies have still to move from x, and where to.
bool Newton::findArriving(const Positions& x) {
  const auto count = bodies_.cols();
  if (count == 0 || bodies_ == x.rightCols(count)) return false;
  motion_.displacements.setZero(3, x.cols());
  motion_.displacements.rightCols(count) = bodies_ - x.rightCols(count);
  return true;
}

/// Takes the step that is permitted, with the bodies. Returns false where there is none.
bool Newton::advanceBodies(Positions& x) {
  const auto count = bodies_.cols();
  const bool whole = step_.rightCols(count) == motion_.displacements.rightCols(count);
  factorized_ = false;
  for (int i = 0; i < kHalvings; ++i, step_ /= 2) {
    trial_ = x + step_;
    if (whole && i == 0) trial_.rightCols(count) = bodies_;
    if (!std::isfinite(objective_.tryFromCurrent(trial_))) continue;
    objective_.accept(x, factor_x_, step_);
    x.swap(trial_);
    return true;
  }
  return false;
}

/// Begins at x, or, where potentials stopped some vertices on the way there and so stretched the
/// paper, where it was before, if that is lower.
bool Newton::begin(const Positions& before, Positions& x) {
  trial_ = x;
  bodies_ = x.rightCols(x.cols() - first_body_);
  bool reached = objective_.begin(before, x);
  if (reached && trial_ == x) return true;
  if (bodies_ != before.rightCols(bodies_.cols())) {
    // Paper is in the way of bodies: they begin where they were.
    trial_.rightCols(bodies_.cols()) = before.rightCols(bodies_.cols());
    x = trial_;
    reached = objective_.begin(before, x);
    if (reached && trial_ == x) return true;
  }
  const double value = reached ? objective_.value() : std::numeric_limits<double>::infinity();
  base_.x = before;
  for (std::size_t v = 0; v < free_.size(); ++v) {
    if (!free_[v]) base_.x.col(v) = trial_.col(v);
  }
  if (objective_.begin(before, base_.x) && objective_.value() < value) {
    x = base_.x;
    return true;
  }
  return reached && objective_.begin(before, x);
}

NewtonResult Newton::minimize(const Potentials& potentials, const Eigen::VectorXd& masses,
                              const Inertia& inertia, const Positions& before, double tolerance,
                              int max_iterations, Positions& x) {
  NewtonResult result;
  objective_.use(potentials, masses, &inertia);
  factorized_ = false;
  {
    const Timer timer(result.times.search);
    if (!begin(before, x)) {
      const auto infeasibility = objective_.findInfeasibility(x);
      result.failure = infeasibility ? infeasibility->what : "the energy is not finite";
      if (infeasibility) result.vertex = infeasibility->vertex;
      return result;
    }
  }
  arriving_ = findArriving(x);
  result.converged = !system_.hasUnknowns() && !arriving_;
  bool uphill = false;  // x is one step beyond the base, and higher
  while (!result.converged) {
    if (result.iterations == max_iterations) {
      result.failure =
          "Newton's method did not converge in " + std::to_string(max_iterations) + " iterations";
      return result;
    }
    if (!computeStep(x, tolerance, result)) {
      result.failure = "the system matrix could not be factorized";
      return result;
    }
    const Timer timer(result.times.search);
    if (arriving_) {
      if (!advanceBodies(x)) {
        result.failure = "a body does not get past the paper";
        return result;
      }
      arriving_ = findArriving(x);
      continue;
    }
    if (!uphill) remember(x);
    const bool close = isClose(result, tolerance);
    trial_ = x + step_;
    const double value = objective_.tryFromCurrent(trial_);
    const bool fell = value <= enough(base_.value, base_.slope);
    if (!fell) factorized_ = false;
    if (!fell && !uphill && !close && std::isfinite(value)) {
      uphill = true;
      objective_.keepAsBase();
      objective_.accept(x, factor_x_, step_);
      x.swap(trial_);
      continue;
    }
    if (fell) objective_.accept(x, factor_x_, step_);
    const bool found = fell || backtrack(uphill);
    // Where forces may jump, as where paper touches, the last solve tells nothing of this one.
    const bool known = result.error <= tolerance || !objective_.rough();
    result.converged = close && known && (fell || !uphill);
    if (found) x.swap(trial_);
    else x = base_.x;
    if (!found && !result.converged) {
      result.failure = "the line search found no lower energy";
      return result;
    }
    uphill = false;
  }
  // Where the factor had to be renewed, paper snaps, buckles or touches: the next solve is another.
  if (result.factorizations > 1) state_ = {};
  if (const auto jump = objective_.findJump()) {
    result.converged = false;
    result.failure = jump->what;
    result.vertex = jump->vertex;
  }
  return result;
}

}  // namespace shell_origami
