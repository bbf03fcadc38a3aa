#include <shell_origami/energy/spring_potential.h>

#include <utility>

namespace shell_origami {

Vector3 Spring::forceAt(const Vector3& x) const {
  const Vector3 way = place - x;
  const double distance = way.norm();
  return distance <= reach() ? Vector3(stiffness * way) : Vector3(max_force / distance * way);
}

SpringPotential::SpringPotential(std::vector<Spring> springs) : springs_(std::move(springs)) {
  // One list in its life.
  stencils_.restart(1);
  for (const Spring& spring : springs_) stencils_.add(&spring.vertex, 1);
}

std::unique_ptr<Potential::Iterate> SpringPotential::makeIterate() const {
  return std::make_unique<Iterate>();
}

double SpringPotential::value(const Positions& x, const Iterate& /*from*/, Iterate& /*at*/) const {
  double sum = 0;
  for (const Spring& spring : springs_) {
    const double distance = (x.col(spring.vertex) - spring.place).norm();
    sum += distance <= spring.reach() ? spring.stiffness / 2 * distance * distance
                                      : spring.max_force * (distance - spring.reach() / 2);
  }
  return sum;
}

void SpringPotential::addGradient(const Positions& x, Iterate& /*at*/, Positions& gradient) const {
  for (const Spring& spring : springs_) {
    gradient.col(spring.vertex) -= spring.forceAt(x.col(spring.vertex));
  }
}

void SpringPotential::addHessian(const Positions& x, const Iterate& /*at*/, HessianKind /*kind*/,
                                 HessianBlocks& blocks) const {
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const Spring& spring = springs_[i];
    const Vector3 way = x.col(spring.vertex) - spring.place;
    const double distance = way.norm();
    Eigen::Matrix3d block = spring.stiffness * Eigen::Matrix3d::Identity();
    if (distance > spring.reach()) {
      const Vector3 along = way / distance;
      block =
          spring.max_force / distance * (Eigen::Matrix3d::Identity() - along * along.transpose());
    }
    blocks.add(static_cast<int>(i), block);
  }
}

}  // namespace shell_origami
