#include <shell_origami/base/parallel.h>
#include <shell_origami/contact/contact_iterate.h>

namespace shell_origami {

/// Returns the friction of a step that starts at the iterate.
std::shared_ptr<const ContactPotential::Friction> ContactPotential::frictionFrom(
    const ContactIterate& at) const {
  auto friction = std::make_shared<Friction>();
  friction->start = at.x;
  if (friction_ == 0) return friction;
  gatherChunks(at.contacts.size(), 64, friction->pairs, [&](const Chunk& chunk, auto& pairs) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Contact& contact = at.contacts[i];
      const double force = -forceOf(contact);
      // Edges that are nearly parallel have no common normal.
      const double coefficient = frictionOf(contact.pair);
      if (force <= 0 || coefficient == 0 || contact.mollifier.value < 1) continue;
      pairs.push_back(frictionPair(contact.pair, contact.closest, pointsOf(contact.pair, at.x),
                                   coefficient * force));
    }
  });
  return friction;
}

void ContactPotential::addFriction(const Positions& x, const Friction& friction,
                                   Positions& gradient) const {
  for (const FrictionPair& pair : friction.pairs) {
    const Vector3 s = slip(pair, friction.start, x);
    const double length = s.norm();
    if (length == 0) continue;
    const Vector3 force = pair.bound * smoothSlip(length, sticking_).first / length * s;
    const Eigen::Matrix<double, 12, 1> forces = pair.slip.transpose() * force;
    for (int k = 0; k < 4; ++k) gradient.col(pair.pair.vertices[k]) += forces.segment<3>(3 * k);
  }
}

void ContactPotential::addFrictionHessian(const Positions& x, const Friction& friction, int first,
                                          HessianBlocks& blocks) const {
  for (std::size_t i = 0; i < friction.pairs.size(); ++i) {
    if (!blocks.reach(first + static_cast<int>(i))) continue;
    const FrictionPair& pair = friction.pairs[i];
    const Eigen::Matrix3d across =
        pair.bound * slipHessian(slip(pair, friction.start, x), pair.normal, sticking_);
    blocks.add(first + static_cast<int>(i),
               Eigen::Matrix<double, 12, 12>(pair.slip.transpose() * across * pair.slip));
  }
}

}  // namespace shell_origami
