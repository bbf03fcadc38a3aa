/// \file
/// The objective of an implicit step, through which every new configuration is reached.
#pragma once

#include <shell_origami/energy/potential.h>

#include <memory>
#include <optional>
#include <vector>

namespace shell_origami {

using Potentials = std::vector<const Potential*>;

/// The inertia of a step: stiffness / 2 |x - anchor|^2 weighted by the lumped masses.
struct Inertia {
  double stiffness = 0;  ///< [1/s^2]
  Positions anchor;      ///< [m]
};

/// The sum of potentials and inertia, with what the potentials keep of four configurations:
///   before   where the paper was last in equilibrium, known to be feasible
///   current  where the search is
///   trial    where the search tries to go
///   base     where it went on from when it forgave a step uphill
/// The paper changes its configuration through here alone: to the start of a search by begin(),
/// then by trials that are accepted. Each of them is looked at by every potential first.
class Objective {
 public:
  /// Says that the mesh or the potentials' meaning changed: nothing is kept.
  void reset() { terms_.clear(); }

  /// Uses these potentials and this inertia from here on. `inertia` and `masses` [kg], one a
  /// vertex, must live until the search ends; without inertia the sum is that of the potentials.
  void use(const Potentials& potentials, const Eigen::VectorXd& masses, const Inertia* inertia);

  /// Makes `before` the configuration from which the others are reached. \pre it is feasible
  void start(const Positions& before);
  /// Makes x current, reached from `before`, as far as the potentials let its vertices go. Returns
  /// false where one does not permit it at all.
  bool begin(const Positions& before, Positions& x);
  /// Writes the gradient [N] at the configuration that start() was given.
  void startGradient(const Positions& before, Positions& gradient);
  /// Says why x cannot be reached from that configuration; nothing where it can.
  std::optional<Infeasibility> findInfeasibility(const Positions& x) const;

  double value() const { return value_; }  ///< current [J]
  /// Writes the gradient [N] at the current configuration x.
  void gradient(const Positions& x, Positions& gradient);
  /// Changes the gradient at the current configuration x for a step by the Hessian at `along`.
  void redirect(const Positions& x, const Positions& along, Positions& gradient) const;
  /// Returns what a potential keeps of the current configuration. \pre it is one of the sum's
  Potential::Iterate& current(const Potential& potential);
  /// The potentials' stencils at the current configuration, valid until the next call.
  const std::vector<const Stencils*>& stencils();
  /// Adds the potential's blocks at the current configuration x. \pre gradient(x) was called
  void addHessian(std::size_t potential, const Positions& x, HessianKind kind,
                  HessianBlocks blocks) const;
  double inertiaStiffness() const { return inertia_ ? inertia_->stiffness : 0; }
  const Eigen::VectorXd& masses() const { return *masses_; }
  /// Returns the part of a step that every potential permits from the current configuration x.
  double maxFeasibleStep(const Positions& x, const Positions& step);
  /// Lets the potentials look for what a whole step from the current configuration x would run
  /// into. Returns whether there is any, which addHessian() then takes into account, and adds its
  /// gradient.
  bool anticipate(const Positions& x, const Positions& step, Positions& gradient);
  /// Whether a potential's forces at the current configuration may jump within a step.
  bool rough() const;

  /// Makes x the trial, reached from the current configuration. Returns its value [J], infinite
  /// where it is infeasible.
  double tryFromCurrent(const Positions& x);
  double tryFromBase(const Positions& x);
  /// Makes the trial, which is at x + displacement, the current configuration. The displacement
  /// was found with the Hessian at `along`.
  void accept(const Positions& x, const Positions& along, const Positions& displacement);
  /// Returns by how much the potentials at the current configuration x are above those at `before`
  /// [J]. The trial is lost.
  double potentialChange(const Positions& before, const Positions& x);
  /// Keeps the current configuration as the base; the next call must be accept().
  void keepAsBase();

  /// Says where the whole way, from `before` to the current configuration, went too far for a step.
  std::optional<Infeasibility> findJump() const;

 private:
  struct Term {
    const Potential* potential;
    std::unique_ptr<Potential::Iterate> before, base, current, trial;
  };
  using Place = std::unique_ptr<Potential::Iterate> Term::*;

  double evaluate(const Positions& x, Place from, Place at) const;
  double inertiaAt(const Positions& x) const;
  void gradientAt(const Positions& x, Place at, Positions& gradient);

  std::vector<Term> terms_;
  std::vector<const Stencils*> stencils_;
  const Eigen::VectorXd* masses_ = nullptr;
  const Inertia* inertia_ = nullptr;
  double value_ = 0, trial_value_ = 0;
  Positions zero_;
};

}  // namespace shell_origami
