#include <shell_origami/dynamics/integrator.h>

#include <shell_origami/dynamics/backward_euler.h>
#include <shell_origami/dynamics/newmark.h>
#include <shell_origami/dynamics/symplectic_euler.h>

namespace shell_origami {

double kineticEnergy(const Positions& velocities, const Eigen::VectorXd& masses) {
  return velocities.colwise().squaredNorm().dot(masses.transpose()) / 2;
}

const std::map<std::string, IntegratorKind>& integratorNames() {
  static const std::map<std::string, IntegratorKind> names{
      {"newmark", IntegratorKind::kNewmark},
      {"backward_euler", IntegratorKind::kBackwardEuler},
      {"symplectic_euler", IntegratorKind::kSymplecticEuler}};
  return names;
}

std::unique_ptr<Integrator> makeIntegrator(const SolverConfig& config, ImplicitSolver& solver) {
  switch (config.integrator) {
    case IntegratorKind::kBackwardEuler: return std::make_unique<BackwardEuler>(solver);
    case IntegratorKind::kSymplecticEuler: return std::make_unique<SymplecticEuler>();
    case IntegratorKind::kNewmark: break;
  }
  return std::make_unique<Newmark>(config, solver);
}

}  // namespace shell_origami
