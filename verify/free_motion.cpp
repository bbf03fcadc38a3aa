#include "verify/free_motion.h"

#include <stdexcept>

namespace shell_origami {
namespace {

/// Neither rest angles nor held vertices change.
class Unchanged : public BoundaryConditions {
 public:
  void applyAt(double, Positions&) override {}
  bool constant() const override { return true; }
};

}  // namespace

Material softBoard() {
  Material material;
  material.youngs_modulus = 2e6;
  material.thickness = 5e-3;
  return material;
}

FreeMotion::FreeMotion(const Sheet& sheet, const Material& material, const SolverConfig& solver,
                       const Positions& positions, const Positions& velocities,
                       const std::vector<std::int64_t>& held)
    : shell_(sheet, material, Vector3::Zero()),
      motion_{positions, velocities, Positions::Zero(3, positions.cols())},
      stepper_(solver) {
  Positions gradient = Positions::Zero(3, positions.cols());
  shell_.addGradient(positions, gradient);
  motion_.accelerations = -gradient * shell().masses().cwiseInverse().asDiagonal();
  std::vector<bool> free(positions.cols(), true);
  for (std::int64_t v : held) {
    free[v] = false;
    motion_.velocities.col(v).setZero();
    motion_.accelerations.col(v).setZero();
  }
  stepper_.setFree(free);
}

void FreeMotion::step() {
  Unchanged conditions;
  const StepReport report = stepper_.step({&shell_}, shell().masses(), 0, conditions, motion_);
  if (report.retries > 0) throw std::runtime_error("a step of free motion had to be cut");
}

double FreeMotion::kineticEnergy() const {
  return motion_.velocities.colwise().squaredNorm().dot(shell().masses().transpose()) / 2;
}

double FreeMotion::elasticEnergy() const {
  return shell_.membraneEnergy(motion_.positions) + shell_.bendingEnergy(motion_.positions);
}

}  // namespace shell_origami
