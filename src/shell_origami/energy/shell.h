/// \file
/// The elastic energy of the sheet in space: membrane and hinges; and its weight.
#pragma once

#include <shell_origami/energy/dihedral.h>
#include <shell_origami/energy/edge_area_membrane.h>
#include <shell_origami/energy/material.h>
#include <shell_origami/energy/membrane.h>
#include <shell_origami/energy/potential.h>
#include <shell_origami/energy/rest_state.h>
#include <shell_origami/sheet/sheet.h>

#include <optional>
#include <variant>
#include <vector>

namespace shell_origami {

/// A hinge between two triangles, in the order of HingePoints.
/// W = stiffness / 2 u^2 with u = hingeBend(theta, rest), of a crease creaseBend(theta, rest).
struct Hinge {
  std::array<int, 4> vertices;
  double length = 0;  ///< |e| on the flat sheet [m]
  double width = 0;   ///< of the paper that bends in it: two thirds of its mean height [m]
  int edge = -1;      ///< index into Sheet::edges()
  int crease = -1;    ///< index into Sheet::creases(), or -1

  Bend bend(const FoldAngle& theta, const FoldAngle& rest) const {
    return crease < 0 ? hingeBend(theta, rest) : creaseBend(theta, rest);
  }
};

/// Energies are pure functions of the positions and of the rest state, which is passed.
class Shell {
 public:
  Shell(const Sheet& sheet, const Material& material);

  /// Returns the rest state of flat paper: creases without stiffness, ordinary hinges and the
  /// membrane with the material's.
  RestState restState() const {
    return {std::vector<FoldAngle>(hinges_.size()), stiffness_,
            std::vector<double>(triangles_.size(), 1),
            std::vector<MembraneStrain>(triangles_.size(), MembraneStrain::Zero())};
  }
  /// Sets the rest angle [rad] and stiffness [N*m/rad per m] of a crease's hinges.
  void setCrease(int crease, double rest_angle, double stiffness, RestState& rest) const;
  /// Sets the rest angle [rad] of an ordinary hinge.
  static void setRestAngle(int hinge, double rest_angle, RestState& rest);
  /// Sets the strain in which a triangle rests.
  void setRestStrain(int triangle, const GreenStrain& green, RestState& rest) const;

  int vertexCount() const { return static_cast<int>(masses_.size()); }
  const Eigen::VectorXd& masses() const { return masses_; }  ///< lumped, one a vertex [kg]
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Hinge>& hinges() const { return hinges_; }
  /// Hinges of each crease.
  const std::vector<std::vector<int>>& creaseHinges() const { return crease_hinges_; }

  double membraneEnergy(const Positions& x, const RestState& rest) const;
  double bendingEnergy(const Positions& x, const RestState& rest) const;
  double gravityEnergy(const Positions& x, const Vector3& gravity) const;

  double foldAngle(int hinge, const Positions& x) const;
  /// Moment of a hinge per metre of it [N*m/m], positive towards a valley.
  double moment(int hinge, double theta, const RestState& rest) const;

  /// Adds the energy [J] to a sum, with every fold angle near `before`, those of a configuration
  /// close by (one a hinge). Returns false where a hinge would have passed 180 degrees on the way,
  /// or a triangle has collapsed. Where it returns true `angles` are those at x, and `energies`
  /// those of the triangles, then of the hinges [J].
  bool addEnergy(const Positions& x, const RestState& rest, const std::vector<FoldAngle>& before,
                 std::vector<FoldAngle>& angles, std::vector<double>& energies,
                 double& energy) const;
  /// Says why addEnergy() returns false; nothing where it does not.
  std::optional<Infeasibility> findInfeasibility(const Positions& x,
                                                 const std::vector<FoldAngle>& before) const;
  /// Returns the first hinge that turned further between two configurations than a step may.
  std::optional<Infeasibility> findJump(const std::vector<FoldAngle>& before,
                                        const std::vector<FoldAngle>& angles) const;
  void foldAngles(const Positions& x, std::vector<FoldAngle>& angles) const;
  /// d theta / dx of every hinge.
  void angleGradients(const Positions& x, std::vector<HingeGradient>& angle_gradients) const;
  /// One a triangle; where a displacement is given, after it, to first order by the derivative at
  /// `along`.
  void strains(const Positions& x, std::vector<MembraneStrain>& strains) const;
  void strainsAfter(const Positions& x, const Positions& along, const Positions& displacement,
                    std::vector<MembraneStrain>& strains) const;
  /// Adds dW/dx [N], with the angles and their gradients at x.
  void addGradient(const Positions& x, const RestState& rest, const std::vector<FoldAngle>& angles,
                   const std::vector<HingeGradient>& angle_gradients, Positions& gradient) const;
  /// Moves to where triangles are at `along` the forces by which their strains at x are other than
  /// `predicted`.
  void redirect(const Positions& x, const Positions& along, const RestState& rest,
                const std::vector<MembraneStrain>& predicted, Positions& gradient) const;
  /// The triangles, then the hinges.
  const Stencils& stencils() const { return stencils_; }
  /// Adds the 9x9 block of every triangle and the 12x12 block of every hinge. `strains`, less those
  /// at rest, have the stress that makes the geometric stiffness. Hinges: kConvex is the
  /// Gauss-Newton block psi'' grad(theta) grad(theta)^T, and so is kExact where a hinge is so near
  /// rest that its torque hardly counts.
  void addHessian(const Positions& x, const RestState& rest, const std::vector<FoldAngle>& angles,
                  const std::vector<HingeGradient>& angle_gradients,
                  const std::vector<MembraneStrain>& strains, HessianKind kind,
                  HessianBlocks& blocks) const;
  /// Calls sink(i, block) with the exact block of every stencil i.
  template <class Sink>
  void forEachExactHessian(const Positions& x, const RestState& rest, Sink&& sink) const;
  /// Returns the largest fraction of `step` in (0, 1] that turns no hinge by more than a radian nor
  /// carries one past the last angle before 180 degrees, by the angles and their gradients where it
  /// starts.
  double maxFeasibleStep(const std::vector<FoldAngle>& angles,
                         const std::vector<HingeGradient>& angle_gradients,
                         const Positions& step) const;

 private:
  TrianglePoints pointsOf(const Triangle& t, const Positions& x) const;
  HingePoints pointsOf(const Hinge& h, const Positions& x) const;
  void addMembraneHessian(const Positions& x, const RestState& rest,
                          const std::vector<MembraneStrain>& strains, HessianKind kind,
                          HessianBlocks& blocks) const;
  void addHingeHessian(const Positions& x, const RestState& rest,
                       const std::vector<FoldAngle>& angles,
                       const std::vector<HingeGradient>& angle_gradients, HessianKind kind,
                       HessianBlocks& blocks) const;
  double gaussNewtonFactor(int hinge, const RestState& rest, const FoldAngle& theta) const;
  HingeHessian exactHessian(int hinge, const RestState& rest, const FoldAngle& theta,
                            const HingeGradient& angle_gradient, const HingePoints& points) const;

  std::vector<Triangle> triangles_;
  std::variant<std::vector<MembraneElement>, std::vector<EdgeAreaMembrane>> membranes_;
  std::vector<Hinge> hinges_;
  std::vector<double> stiffness_;  ///< of ordinary hinges, one for each hinge [J]
  std::vector<std::vector<int>> crease_hinges_;
  Stencils stencils_;
  /// Mean hinge width of the sheet where it counts for creases [m]; 0: it does not.
  double crease_width_ = 0;
  Eigen::VectorXd masses_;
};

template <class Sink>
void Shell::forEachExactHessian(const Positions& x, const RestState& rest, Sink&& sink) const {
  const int triangle_count = static_cast<int>(triangles_.size());
  std::visit(
      [&](const auto& membranes) {
        for (int i = 0; i < triangle_count; ++i) {
          const TrianglePoints points = pointsOf(triangles_[i], x);
          const MembraneStrain strain = membranes[i].strain(points) - rest.strains[i];
          sink(i, MembraneHessian(rest.membrane[i] * membranes[i].hessian(points, strain, false)));
        }
      },
      membranes_);
  for (int j = 0; j < static_cast<int>(hinges_.size()); ++j) {
    const HingePoints points = pointsOf(hinges_[j], x);
    sink(triangle_count + j, exactHessian(j, rest, shell_origami::foldAngle(points),
                                          foldAngleGradient(points), points));
  }
}

}  // namespace shell_origami
