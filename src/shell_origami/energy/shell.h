/// \file
/// The elastic energy of the sheet in space: membrane, hinges and gravity.
#pragma once

#include <shell_origami/energy/dihedral.h>
#include <shell_origami/energy/edge_area_membrane.h>
#include <shell_origami/energy/material.h>
#include <shell_origami/energy/membrane.h>
#include <shell_origami/sheet/sheet.h>

#include <optional>
#include <variant>
#include <vector>

namespace shell_origami {

/// A hinge between two triangles, in the order of HingePoints.
/// W = stiffness / 2 u^2 with u = hingeBend(theta, rest_angle), of a crease creaseBend().
struct Hinge {
  std::array<int, 4> vertices;
  double length = 0;     ///< |e| on the flat sheet [m]
  double width = 0;      ///< of the paper that bends in it: two thirds of its mean height [m]
  int edge = -1;         ///< index into Sheet::edges()
  double stiffness = 0;  ///< [J]
  FoldAngle rest_angle;  ///< short of 180 degrees
  int crease = -1;       ///< index into Sheet::creases(), or -1

  Bend bend(const FoldAngle& theta) const {
    return crease < 0 ? hingeBend(theta, rest_angle) : creaseBend(theta, rest_angle);
  }
};

/// factor * vector * vector^T.
struct RankOne {
  double factor;
  const HingeGradient& vector;
};

/// Why a configuration is none of a paper.
struct Infeasibility {
  const char* what;
  int vertex;  ///< of the triangle or hinge
};

enum class HessianKind {
  kGaussNewton,     ///< hinges: rank one, psi'' grad(theta) grad(theta)^T. Positive semidefinite
  kExactWhereBent,  ///< Gauss-Newton for hinges so near rest that their torque hardly counts
};

/// Energies are pure functions of the positions; the rest state is set by the caller.
class Shell {
 public:
  Shell(const Sheet& sheet, const Material& material, const Vector3& gravity);

  void setGravity(const Vector3& gravity) { gravity_ = gravity; }  ///< [m/s^2]

  /// Rest angle [rad] and stiffness [N*m/rad per m] of a crease's hinges. Creases are held short
  /// of 180 degrees, and so is the rest angle.
  void setCrease(int crease, double rest_angle, double stiffness);

  /// Rest angle [rad] of an ordinary hinge, held short of 180 degrees.
  void setRestAngle(int hinge, double rest_angle);

  int vertexCount() const { return static_cast<int>(masses_.size()); }
  const Eigen::VectorXd& masses() const { return masses_; }  ///< lumped, one a vertex [kg]
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Hinge>& hinges() const { return hinges_; }
  /// Hinges of each crease.
  const std::vector<std::vector<int>>& creaseHinges() const { return crease_hinges_; }

  double membraneEnergy(const Positions& x) const;
  double bendingEnergy(const Positions& x) const;
  double gravityEnergy(const Positions& x) const;

  double foldAngle(int hinge, const Positions& x) const;
  /// Moment of a hinge per metre of it [N*m/m], positive towards a valley.
  double moment(int hinge, double theta) const;

  /// Energy [J] with every fold angle near `before`, those of a configuration close by (one a
  /// hinge): infinite where a hinge would have passed 180 degrees on the way, or a triangle has
  /// collapsed. Where it is finite `angles` are those at x.
  double energy(const Positions& x, const std::vector<FoldAngle>& before,
                std::vector<FoldAngle>& angles) const;
  /// What made energy() infinite; nothing where it is not.
  std::optional<Infeasibility> findInfeasibility(const Positions& x,
                                                 const std::vector<FoldAngle>& angles) const;
  /// The first hinge that turned further between two configurations than a step may.
  std::optional<Infeasibility> findJump(const std::vector<FoldAngle>& before,
                                        const std::vector<FoldAngle>& angles) const;
  void foldAngles(const Positions& x, std::vector<FoldAngle>& angles) const;
  /// d theta / dx of every hinge.
  void angleGradients(const Positions& x, std::vector<HingeGradient>& angle_gradients) const;
  /// One a triangle; where a displacement is given, after it, to first order.
  void strains(const Positions& x, std::vector<MembraneStrain>& strains) const;
  void strainsAfter(const Positions& x, const Positions& displacement,
                    std::vector<MembraneStrain>& strains) const;
  /// Adds dW/dx [N], with the angles and turns at x.
  void addGradient(const Positions& x, const std::vector<FoldAngle>& angles,
                   const std::vector<HingeGradient>& angle_gradients, Positions& gradient) const;
  void addGradient(const Positions& x, Positions& gradient) const;
  /// Calls sink(i, block) with the 9x9 block of every triangle i, then sink(triangles + j, block)
  /// with the 12x12 block of every hinge j, a HingeHessian or a RankOne. `strains` are those that
  /// the stress in the geometric stiffness is of.
  template <class Sink>
  void forEachHessian(const Positions& x, const std::vector<FoldAngle>& angles,
                      const std::vector<HingeGradient>& angle_gradients,
                      const std::vector<MembraneStrain>& strains, HessianKind kind,
                      Sink&& sink) const;
  /// The same with the exact blocks, all of them matrices.
  template <class Sink>
  void forEachExactHessian(const Positions& x, Sink&& sink) const;
  /// Largest fraction of `step` in (0, 1] that turns no hinge by more than a radian nor carries
  /// one past the last angle before 180 degrees, by the angles and turns where it starts.
  double maxFeasibleStep(const std::vector<FoldAngle>& angles,
                         const std::vector<HingeGradient>& angle_gradients,
                         const Positions& step) const;

 private:
  TrianglePoints pointsOf(const Triangle& t, const Positions& x) const;
  HingePoints pointsOf(const Hinge& h, const Positions& x) const;
  static bool nearRest(const Hinge& hinge, const FoldAngle& theta);
  RankOne gaussNewton(const Hinge& hinge, const FoldAngle& theta, const HingeGradient& turn) const;
  HingeHessian exactHessian(const Hinge& hinge, const FoldAngle& theta, const HingeGradient& turn,
                            const HingePoints& points) const;

  std::vector<Triangle> triangles_;
  std::variant<std::vector<MembraneElement>, std::vector<EdgeAreaMembrane>> membranes_;
  std::vector<Hinge> hinges_;
  std::vector<std::vector<int>> crease_hinges_;
  /// Mean hinge width of the sheet where it counts for creases [m]; 0: it does not.
  double crease_width_ = 0;
  Eigen::VectorXd masses_;
  Vector3 gravity_;
};

template <class Sink>
void Shell::forEachHessian(const Positions& x, const std::vector<FoldAngle>& angles,
                           const std::vector<HingeGradient>& angle_gradients,
                           const std::vector<MembraneStrain>& strains, HessianKind kind,
                           Sink&& sink) const {
  const int triangle_count = static_cast<int>(triangles_.size());
  std::visit(
      [&](const auto& membranes) {
        for (int i = 0; i < triangle_count; ++i) {
          sink(i, membranes[i].hessian(pointsOf(triangles_[i], x), strains[i],
                                       kind == HessianKind::kGaussNewton));
        }
      },
      membranes_);
  for (int j = 0; j < static_cast<int>(hinges_.size()); ++j) {
    const bool rank_one = kind == HessianKind::kGaussNewton || nearRest(hinges_[j], angles[j]);
    if (rank_one) {
      sink(triangle_count + j, gaussNewton(hinges_[j], angles[j], angle_gradients[j]));
    } else {
      sink(triangle_count + j,
           exactHessian(hinges_[j], angles[j], angle_gradients[j], pointsOf(hinges_[j], x)));
    }
  }
}

template <class Sink>
void Shell::forEachExactHessian(const Positions& x, Sink&& sink) const {
  const int triangle_count = static_cast<int>(triangles_.size());
  std::visit(
      [&](const auto& membranes) {
        for (int i = 0; i < triangle_count; ++i) {
          const TrianglePoints points = pointsOf(triangles_[i], x);
          sink(i, membranes[i].hessian(points, membranes[i].strain(points), false));
        }
      },
      membranes_);
  for (int j = 0; j < static_cast<int>(hinges_.size()); ++j) {
    const HingePoints points = pointsOf(hinges_[j], x);
    sink(triangle_count + j, exactHessian(hinges_[j], shell_origami::foldAngle(points),
                                          foldAngleGradient(points), points));
  }
}

}  // namespace shell_origami
