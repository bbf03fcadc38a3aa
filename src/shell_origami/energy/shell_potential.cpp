#include <shell_origami/energy/shell_potential.h>

#include <limits>

namespace shell_origami {
namespace {

struct ShellIterate : Potential::Iterate {
  std::vector<FoldAngle> angles;
  std::vector<double> energies;                ///< of triangles and hinges [J]
  std::vector<HingeGradient> angle_gradients;  ///< of iterates whose gradient was asked for
  /// Those that the displacement to here predicted to first order, which the stress in the
  /// geometric stiffness is made of.
  std::vector<MembraneStrain> strains;
};

const ShellIterate& of(const Potential::Iterate& at) {
  return static_cast<const ShellIterate&>(at);
}
ShellIterate& of(Potential::Iterate& at) { return static_cast<ShellIterate&>(at); }

}  // namespace

std::unique_ptr<Potential::Iterate> ShellPotential::makeIterate() const {
  return std::make_unique<ShellIterate>();
}

void ShellPotential::start(const Positions& x, Iterate& at) const {
  shell_.foldAngles(x, of(at).angles);
}

double ShellPotential::value(const Positions& x, const Iterate& from, Iterate& at) const {
  double energy = gravityEnergy(x);
  const bool feasible =
      shell_.addEnergy(x, rest, of(from).angles, of(at).angles, of(at).energies, energy);
  return feasible ? energy : std::numeric_limits<double>::infinity();
}

std::optional<Infeasibility> ShellPotential::findInfeasibility(const Positions& x,
                                                               const Iterate& from) const {
  return shell_.findInfeasibility(x, of(from).angles);
}

void ShellPotential::addGradient(const Positions& x, Iterate& at, Positions& gradient) const {
  shell_.angleGradients(x, of(at).angle_gradients);
  gradient.leftCols(shell_.masses().size()).noalias() -= gravity * shell_.masses().transpose();
  shell_.addGradient(x, rest, of(at).angles, of(at).angle_gradients, gradient);
}

void ShellPotential::addGradient(const Positions& x, Positions& gradient) const {
  ShellIterate at;
  start(x, at);
  addGradient(x, at, gradient);
}

const Stencils& ShellPotential::stencils(const Iterate& /*at*/) const { return shell_.stencils(); }

void ShellPotential::addHessian(const Positions& x, const Iterate& at, HessianKind kind,
                                HessianBlocks& blocks) const {
  const ShellIterate& own = of(at);
  shell_.addHessian(x, rest, own.angles, own.angle_gradients, own.strains, kind, blocks);
}

double ShellPotential::maxFeasibleStep(const Positions& /*x*/, Iterate& at,
                                       const Positions& step) const {
  return shell_.maxFeasibleStep(of(at).angles, of(at).angle_gradients, step);
}

void ShellPotential::predict(const Positions& x, const Positions& along,
                             const Positions& displacement, Iterate& at) const {
  shell_.strainsAfter(x, along, displacement, of(at).strains);
}

void ShellPotential::redirect(const Positions& x, const Iterate& at, const Positions& along,
                              Positions& gradient) const {
  shell_.redirect(x, along, rest, of(at).strains, gradient);
}

std::optional<Infeasibility> ShellPotential::findJump(const Iterate& from,
                                                      const Iterate& to) const {
  return shell_.findJump(of(from).angles, of(to).angles);
}

}  // namespace shell_origami
