#include <shell_origami/dynamics/objective.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shell_origami {

void Objective::use(const Potentials& potentials, const Eigen::VectorXd& masses,
                    const Inertia* inertia) {
  masses_ = &masses;
  inertia_ = inertia;
  const bool same = std::equal(terms_.begin(), terms_.end(), potentials.begin(), potentials.end(),
                               [](const Term& t, const Potential* p) { return t.potential == p; });
  if (same) return;
  terms_.clear();
  for (const Potential* p : potentials) {
    terms_.push_back({p, p->makeIterate(), p->makeIterate(), p->makeIterate(), p->makeIterate()});
  }
}

double Objective::evaluate(const Positions& x, Place from, Place at) const {
  double sum = 0;
  for (const Term& term : terms_) {
    sum += term.potential->value(x, *(term.*from), *(term.*at));
    if (!std::isfinite(sum)) return std::numeric_limits<double>::infinity();
  }
  return sum + inertiaAt(x);
}

double Objective::inertiaAt(const Positions& x) const {
  if (!inertia_) return 0;
  const double distance = (x - inertia_->anchor).colwise().squaredNorm().dot(masses_->transpose());
  return inertia_->stiffness / 2 * distance;
}

double Objective::potentialChange(const Positions& before, const Positions& x) {
  const double start = evaluate(before, &Term::before, &Term::trial);
  return (value_ - start) - (inertiaAt(x) - inertiaAt(before));
}

void Objective::start(const Positions& before) {
  for (Term& term : terms_) term.potential->start(before, *term.before);
}

bool Objective::begin(const Positions& before, Positions& x) {
  start(before);
  for (Term& term : terms_) term.potential->filterStart(before, *term.before, x);
  value_ = evaluate(x, &Term::before, &Term::current);
  if (!std::isfinite(value_)) return false;
  // As if nothing had moved since the last equilibrium, whose stress is the best guess.
  zero_.setZero(3, x.cols());
  for (Term& term : terms_) term.potential->predict(before, before, zero_, *term.current);
  return true;
}

std::optional<Infeasibility> Objective::findInfeasibility(const Positions& x) const {
  for (const Term& term : terms_) {
    if (const auto found = term.potential->findInfeasibility(x, *term.before)) return found;
  }
  return std::nullopt;
}

void Objective::startGradient(const Positions& before, Positions& gradient) {
  gradientAt(before, &Term::before, gradient);
}

void Objective::gradient(const Positions& x, Positions& gradient) {
  gradientAt(x, &Term::current, gradient);
}

void Objective::redirect(const Positions& x, const Positions& along, Positions& gradient) const {
  for (const Term& term : terms_) {
    term.potential->redirect(x, *term.current, along, gradient);
  }
}

Potential::Iterate& Objective::current(const Potential& potential) {
  return *std::find_if(terms_.begin(), terms_.end(), [&](const Term& term) {
            return term.potential == &potential;
          })->current;
}

void Objective::gradientAt(const Positions& x, Place at, Positions& gradient) {
  if (inertia_) {
    gradient = inertia_->stiffness * (x - inertia_->anchor) * masses_->asDiagonal();
  } else {
    gradient.setZero(3, x.cols());
  }
  for (Term& term : terms_) term.potential->addGradient(x, *(term.*at), gradient);
}

const std::vector<const Stencils*>& Objective::stencils() {
  stencils_.clear();
  for (const Term& term : terms_) stencils_.push_back(&term.potential->stencils(*term.current));
  return stencils_;
}

void Objective::addHessian(std::size_t potential, const Positions& x, HessianKind kind,
                           HessianBlocks blocks) const {
  const Term& term = terms_[potential];
  term.potential->addHessian(x, *term.current, kind, blocks);
}

double Objective::maxFeasibleStep(const Positions& x, const Positions& step) {
  double part = 1;
  for (Term& term : terms_) {
    part = std::min(part, term.potential->maxFeasibleStep(x, *term.current, step));
  }
  return part;
}

bool Objective::anticipate(const Positions& x, const Positions& step, Positions& gradient) {
  bool any = false;
  for (Term& term : terms_) any |= term.potential->anticipate(x, *term.current, step);
  if (!any) return false;
  for (const Term& term : terms_) term.potential->addAnticipated(x, *term.current, gradient);
  return true;
}

bool Objective::rough() const {
  return std::any_of(terms_.begin(), terms_.end(),
                     [](const Term& term) { return term.potential->rough(*term.current); });
}

double Objective::tryFromCurrent(const Positions& x) {
  return trial_value_ = evaluate(x, &Term::current, &Term::trial);
}

double Objective::tryFromBase(const Positions& x) {
  return trial_value_ = evaluate(x, &Term::base, &Term::trial);
}

void Objective::accept(const Positions& x, const Positions& along, const Positions& displacement) {
  for (Term& term : terms_) {
    term.potential->predict(x, along, displacement, *term.trial);
    term.current.swap(term.trial);
  }
  value_ = trial_value_;
}

void Objective::keepAsBase() {
  for (Term& term : terms_) term.base.swap(term.current);
}

std::optional<Infeasibility> Objective::findJump() const {
  for (const Term& term : terms_) {
    if (const auto found = term.potential->findJump(*term.before, *term.current)) return found;
  }
  return std::nullopt;
}

}  // namespace shell_origami
