/// \file
/// The state that a ContactPotential stores for one configuration. Only its own sources include
/// this.
#pragma once

#include <shell_origami/contact/contact_potential.h>
#include <shell_origami/contact/friction.h>

#include <memory>
#include <vector>

namespace shell_origami {

/// The contacts at the start of a step, and the positions then.
struct ContactPotential::Friction {
  Positions start;
  std::vector<FrictionPair> pairs;
};

struct ContactPotential::ContactIterate : Potential::Iterate {
  Positions x;
  std::shared_ptr<const Candidates> candidates;  ///< which cover x
  std::vector<double> gaps;                      ///< of each candidate, a lower bound [m]
  std::vector<Contact> contacts;                 ///< closer than kNear reaches, in their order
  std::shared_ptr<const Friction> friction;      ///< since the start of the step
  std::vector<Impact> impacts;  ///< that a step would run into, until the next gradient
  Stencils stencils;
};

}  // namespace shell_origami
