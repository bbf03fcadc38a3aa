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
  bool enabled = true;
  double distance = 5e-5;  ///< within which paper begins to push, d^ [m]
  double friction = 0.4;   ///< Coulomb's coefficient, paper on paper
};

/// Of a ContactPotential.
struct ContactParameters {
  double distance;   ///< within which paper begins to push [m]
  double stiffness;  ///< of a pair of that reach at contact, of the order of the membrane's [N/m]
  double friction = 0;     ///< Coulomb's coefficient, paper on paper
  double sticking = 1e-6;  ///< slip within a step below which friction is not yet at its bound [m]
};

/// Two primitives that are close, and their barrier.
struct Contact {
  ContactPair pair;
  ClosestPoints closest;
  Derivatives barrier;  ///< of the distance over the reach, both above kClosestGap
  Mollifier mollifier;
};

/// Returns the smallest distance of them [m]; -1: there is none.
double smallestGap(const std::vector<Contact>& contacts);

/// Two primitives that a step would bring together, with their closest points at that time.
struct Impact {
  ContactPair pair;
  ClosestPoints closest;
};

/// Incremental Potential Contact (Li et al. 2020) between the parts of one sheet, or between it and
/// bodies. A configuration is reached from another one only on a straight way on which no vertex
/// passes through a face and no edge through another one. Columns of positions are the vertices of
/// the sheet and, after these, of the bodies, which are prescribed.
class ContactPotential : public Potential {
 public:
  /// \param crossing what passes through itself where the paper is: left out of contact. Nothing
  /// else may cross in a configuration that start() is given.
  ContactPotential(const Sheet& sheet, const ContactParameters& parameters,
                   const std::vector<TrianglePair>& crossing = {});
  /// \pre there are bodies, and none crosses the sheet
  ContactPotential(const Sheet& sheet, const std::vector<Body>& bodies,
                   const ContactParameters& parameters);

  /// The pairs within their reach, in a fixed order.
  std::vector<Contact> contacts(const Positions& x) const;
  std::vector<Contact> contacts(const Iterate& at) const;
  double energy(const Positions& x) const;  ///< [J]
  /// Returns the derivative of a contact's energy by its distance [N]: not positive, as it pushes.
  double forceOf(const Contact& contact) const;
  /// Adds dW/dx [N].
  void addGradient(const Positions& x, Positions& gradient) const;

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
  ContactPotential(CollisionMesh mesh, const Sheet& sheet, const ContactParameters& parameters);
  struct ContactIterate;
  struct Friction;
  static const ContactIterate& of(const Iterate& at);
  static ContactIterate& of(Iterate& at);

  std::shared_ptr<const Candidates> candidatesOf(const Positions& from, const Positions& to) const;
  bool cover(ContactIterate& at, const Positions& to) const;
  void measure(ContactIterate& at) const;
  void addContact(const ContactPair& pair, const ClosestPoints& closest, const Positions& x,
                  std::vector<Contact>& contacts) const;
  void finish(ContactIterate& at) const;
  double smallestFreePart(const ContactIterate& at, const Positions& x, const Positions& to) const;
  void addHessianPart(const Positions& x, const ContactIterate& at, HessianKind kind,
                      HessianBlocks& blocks) const;
  double stiffnessOf(const ContactPair& pair) const;
  double frictionOf(const ContactPair& pair) const {
    return mesh_.hasBodies() ? mesh_.bodyFriction(pair.faces) : friction_;
  }
  std::shared_ptr<const Friction> frictionFrom(const ContactIterate& at) const;
  void addFriction(const Positions& x, const Friction& friction, Positions& gradient) const;
  void addFrictionHessian(const Positions& x, const Friction& friction, int first,
                          HessianBlocks& blocks) const;
  double energyOf(const Contact& contact) const;

  CollisionMesh mesh_;
  BoundingTree tree_;
  double distance_, stiffness_;
  double friction_;  ///< the largest coefficient of a pair
  double sticking_, margin_;
  std::size_t most_;
};

}  // namespace shell_origami
