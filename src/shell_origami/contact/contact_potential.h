/// \file
/// Paper that cannot pass through itself: a barrier between what comes close, and the guard that
/// every motion passes.
#pragma once

#include <shell_origami/contact/barrier.h>
#include <shell_origami/contact/candidates.h>
#include <shell_origami/energy/potential.h>

#include <vector>

namespace shell_origami {

struct ContactConfig {
  bool enabled = false;
  double distance = 5e-5;  ///< within which paper begins to push, d^ [m]
};

/// Two primitives that are close, and their barrier.
struct Contact {
  ContactPair pair;
  ClosestPoints closest;
  Derivatives barrier;  ///< of the distance over the reach
  Mollifier mollifier;
};

/// Two primitives that a step would bring together, with their closest points at that time.
struct Impact {
  ContactPair pair;
  ClosestPoints closest;
};

/// Incremental Potential Contact (Li et al. 2020) between the parts of one sheet. A configuration
/// is reached from another one only on a straight way on which no vertex passes through a face and
/// no edge through another one.
class ContactPotential : public Potential {
 public:
  /// \param stiffness of one pair at contact, of the order of the membrane's [N/m]
  /// \pre no parts of the sheet cross in the configurations that start() is given
  ContactPotential(const Sheet& sheet, double distance, double stiffness);

  /// The pairs within their reach, in a fixed order.
  std::vector<Contact> contacts(const Positions& x) const;
  double energy(const Positions& x) const;  ///< [J]

  std::unique_ptr<Iterate> makeIterate() const override;
  void start(const Positions& x, Iterate& at) const override;
  void filterStart(const Positions& before, Iterate& at, Positions& x) const override;
  double value(const Positions& x, const Iterate& from, Iterate& at) const override;
  std::optional<Infeasibility> findInfeasibility(const Positions& x,
                                                 const Iterate& from) const override;
  void addGradient(const Positions& x, Iterate& at, Positions& gradient) const override;
  const Stencils& stencils(const Iterate& at) const override;
  void addHessian(const Positions& x, const Iterate& at, HessianKind kind,
                  HessianBlocks& blocks) const override;
  double maxFeasibleStep(const Positions& x, Iterate& at, const Positions& step) const override;
  bool anticipate(const Positions& x, Iterate& at, const Positions& step) const override;
  void addAnticipated(const Positions& x, const Iterate& at, Positions& gradient) const override;
  bool rough(const Iterate& at) const override;

 private:
  struct ContactIterate;
  static const ContactIterate& of(const Iterate& at);
  static ContactIterate& of(Iterate& at);

  std::shared_ptr<const Candidates> candidatesOf(const Positions& from, const Positions& to) const;
  void cover(ContactIterate& at, const Positions& to) const;
  void measure(ContactIterate& at) const;
  bool addContact(const ContactPair& pair, const ClosestPoints& closest, ContactIterate& at) const;
  void finish(ContactIterate& at) const;
  double energyOf(const Contact& contact) const;

  CollisionMesh mesh_;
  BoundingTree tree_;
  double distance_, stiffness_, margin_;
};

}  // namespace shell_origami
