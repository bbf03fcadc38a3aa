/// \file
/// The shape that paper without load takes, apart from its creases: flat, rolled, or as it was bent
/// beyond yield.
#pragma once

#include <shell_origami/energy/curvature.h>
#include <shell_origami/energy/shell.h>
#include <shell_origami/sheet/remap.h>

#include <vector>

namespace shell_origami {

/// A sheet that rests rolled up into a cylinder.
struct NaturalCurvature {
  double curvature = 0;  ///< [1/m], positive towards the front (+z of the flat sheet); 0: flat
  double axis = 0;       ///< direction of the cylinder's axis on the flat sheet, from x [rad]
};

/// Rest angles of the ordinary hinges, one for each edge of the sheet.
class RestShape {
 public:
  RestShape() = default;
  RestShape(const NaturalCurvature& roll, const Sheet& sheet);
  /// One that yielded before: see set() and plastic(), one of each for an edge.
  RestShape(const NaturalCurvature& roll, const Sheet& sheet, std::vector<double> set,
            std::vector<double> plastic);

  const std::vector<double>& set() const { return set_; }
  const std::vector<double>& plastic() const { return plastic_; }

  /// Sets the rest angles of the shell's ordinary hinges.
  void apply(const Shell& shell, RestState& rest) const;
  /// Carries what yielding left over an edit: a part of an edge keeps that edge's.
  void follow(const Remap& remap, const Sheet& after);
  /// Return map: where the paper is bent further from rest than the yield curvature, the excess
  /// becomes rest, less what the hardening bears, and `rest` gets the new rest angles. Of a sheet
  /// bent to kappa in whatever direction (kappa - kappa_y) / (1 + hardening) stays. The bend of a
  /// hinge is the largest principal curvature there, as `fit` of the same sheet has it; hinges
  /// yield by the same part of their angle in all directions (after Gingold et al., A Discrete
  /// Model for Inelastic Deformation of Thin Shells, 2004).
  void yield(const Material& material, const CurvatureFit& fit, const Positions& positions,
             const Shell& shell, RestState& rest);

 private:
  void roll(const Sheet& sheet);

  NaturalCurvature roll_;
  std::vector<double> rolled_;   ///< rest angle of the roll, one an edge [rad]
  std::vector<double> set_;      ///< what yielding added to it [rad]
  std::vector<double> plastic_;  ///< curvature yielded so far, either way [1/m]
};

}  // namespace shell_origami
