#include "bench/contact_limit.h"

#include <shell_origami/base/timer.h>
#include <shell_origami/contact/contact_potential.h>
#include <shell_origami/dynamics/objective.h>
#include <shell_origami/linear/stencil_system.h>
#include "bench/run.h"

#include <stdexcept>

namespace shell_origami {
namespace {

constexpr int kRepetitions = 3;

template <class Work>
double medianTime(Work&& work) {
  std::vector<double> times(kRepetitions);
  for (double& time : times) {
    const Timer timer(time);
    work();
  }
  return median(times);
}

StencilSystem systemOf(const Simulation& simulation) {
  std::vector<bool> free(simulation.sheet().vertexCount(), true);
  for (int v : simulation.pinned()) free[v] = false;
  StencilSystem system;
  system.setFree(free);
  return system;
}

}  // namespace

ContactLimit measureContactLimit(const Simulation& simulation) {
  const Positions& x = simulation.positions();
  const ContactPotential contact(simulation.sheet(), contactParameters(simulation.config()));
  const Potentials potentials{&simulation.shell(), &contact};
  const Eigen::VectorXd& masses = simulation.shell().shell().masses();
  Objective objective;
  objective.use(potentials, masses, nullptr);
  Positions at = x, gradient, step = Positions::Zero(3, x.cols());
  objective.begin(x, at);
  objective.gradient(x, gradient);
  StencilSystem system = systemOf(simulation);
  const std::vector<const Stencils*>& stencils = objective.stencils();
  system.prepare(stencils);
  const auto assemble = [&](HessianKind kind) {
    system.setZero();
    for (std::size_t i = 0; i < stencils.size(); ++i) {
      objective.addHessian(i, x, kind, system.blocks(i));
    }
    const double dt = simulation.config().solver.time_step;
    system.addToDiagonal(1 / (dt * dt), masses);
  };
  assemble(HessianKind::kExact);
  if (!system.factorize()) assemble(HessianKind::kConvex);
  ContactLimit limit;
  bool solved = true;
  limit.numeric = medianTime([&] { solved &= system.factorize(); });
  limit.solve = medianTime([&] { solved &= system.solve(gradient, step); });
  if (!solved) throw std::runtime_error("the step's matrix is not positive definite");
  const auto iterate = contact.makeIterate();
  contact.start(x, *iterate);  // finds the candidates, which are kept
  limit.candidates = medianTime([&] { contact.start(x, *iterate); });
  return limit;
}

}  // namespace shell_origami
