/// \file
/// Springs of limited force between vertices and places.
#pragma once

#include <shell_origami/energy/potential.h>

#include <vector>

namespace shell_origami {

/// Pulls a vertex to a place with stiffness times its distance, but at most with a force.
struct Spring {
  int vertex;
  Vector3 place;     ///< [m]
  double stiffness;  ///< [N/m]
  double max_force;  ///< [N]

  /// Distance from which on the force is at its limit [m].
  double reach() const { return max_force / stiffness; }
  Vector3 forceAt(const Vector3& x) const;  ///< on the vertex [N]
};

/// The springs' energy: k u^2 / 2 of a distance u up to F / k, beyond F u - F^2 / (2 k), which is
/// convex and once continuously differentiable.
class SpringPotential : public Potential {
 public:
  SpringPotential() = default;
  explicit SpringPotential(std::vector<Spring> springs);

  const std::vector<Spring>& springs() const { return springs_; }
  /// Moves the place that a spring pulls to.
  void setPlace(std::size_t spring, const Vector3& place) { springs_[spring].place = place; }

  std::unique_ptr<Iterate> makeIterate() const override;
  void start(const Positions& /*x*/, Iterate& /*at*/) const override {}
  double value(const Positions& x, const Iterate& from, Iterate& at) const override;
  std::optional<Infeasibility> findInfeasibility(const Positions& /*x*/,
                                                 const Iterate& /*from*/) const override {
    return std::nullopt;
  }
  void addGradient(const Positions& x, Iterate& at, Positions& gradient) const override;
  const Stencils& stencils(const Iterate& /*at*/) const override { return stencils_; }
  void addHessian(const Positions& x, const Iterate& at, HessianKind kind,
                  HessianBlocks& blocks) const override;
  double maxFeasibleStep(const Positions& /*x*/, Iterate& /*at*/,
                         const Positions& /*step*/) const override {
    return 1;
  }

 private:
  std::vector<Spring> springs_;
  Stencils stencils_;
};

}  // namespace shell_origami
