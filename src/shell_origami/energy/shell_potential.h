/// \file
/// The shell as one term of the objective.
#pragma once

#include <shell_origami/energy/potential.h>
#include <shell_origami/energy/shell.h>

#include <vector>

namespace shell_origami {

/// A shell with the rest state and the gravity that it has now.
class ShellPotential : public Potential {
  Shell shell_;

 public:
  ShellPotential(const Sheet& sheet, const Material& material, const Vector3& gravity)
      : shell_(sheet, material), rest(shell_.restState()), gravity(gravity) {}

  const Shell& shell() const { return shell_; }

  RestState rest;
  Vector3 gravity;  ///< [m/s^2]

  double membraneEnergy(const Positions& x) const { return shell_.membraneEnergy(x, rest); }
  double bendingEnergy(const Positions& x) const { return shell_.bendingEnergy(x, rest); }
  double gravityEnergy(const Positions& x) const { return shell_.gravityEnergy(x, gravity); }
  /// Adds dW/dx [N], of gravity too.
  void addGradient(const Positions& x, Positions& gradient) const;

  std::unique_ptr<Iterate> makeIterate() const override;
  void start(const Positions& x, Iterate& at) const override;
  double value(const Positions& x, const Iterate& from, Iterate& at) const override;
  std::optional<Infeasibility> findInfeasibility(const Positions& x,
                                                 const Iterate& from) const override;
  void addGradient(const Positions& x, Iterate& at, Positions& gradient) const override;
  const Stencils& stencils(const Iterate& at) const override;
  void addHessian(const Positions& x, const Iterate& at, HessianKind kind,
                  HessianBlocks& blocks) const override;
  double maxFeasibleStep(const Positions& x, Iterate& at, const Positions& step) const override;
  void predict(const Positions& x, const Positions& along, const Positions& displacement,
               Iterate& at) const override;
  void redirect(const Positions& x, const Iterate& at, const Positions& along,
                Positions& gradient) const override;
  std::optional<Infeasibility> findJump(const Iterate& from, const Iterate& to) const override;
};

}  // namespace shell_origami
