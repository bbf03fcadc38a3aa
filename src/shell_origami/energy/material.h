/// \file
/// Material parameters of the paper.
#pragma once

#include <map>
#include <string>

namespace shell_origami {

/// The energy of stretching and shearing.
enum class MembraneKind {
  kStVenantKirchhoff,  ///< the paper's own E t and nu, in every direction
  kDiscreteShells      ///< edge-length and area terms (Grinspun et al. 2003, section 3)
};

/// The kinds by the names that people write.
const std::map<std::string, MembraneKind>& membraneNames();

/// Paper tears before it is stretched so far.
constexpr double kBearableStrain = 0.02;

/// Isotropic elastic paper. Defaults are copy paper.
struct Material {
  double youngs_modulus = 2e9;     ///< E [Pa]
  double poisson_ratio = 0.3;      ///< nu
  double thickness = 1e-4;         ///< t [m]
  double density = 800;            ///< rho [kg/m^3]
  double crease_stiffness = 5e-3;  ///< c [N*m/rad per m of crease]
  double air_damping = 5;          ///< mass-proportional [1/s]
  MembraneKind membrane = MembraneKind::kStVenantKirchhoff;
  /// Whether a crease's stiffness is divided by the height of the triangles beside it, over the
  /// sheet's mean height (Discrete Shells Origami, equation of figure 11), or only proportional to
  /// its length (the same paper's proposal, section 5.1).
  bool crease_height_term = false;
  /// Bent further than this the paper keeps part of the bend [1/m]; 0: it is elastic.
  double yield_curvature = 0;
  /// Rise of the yield curvature per plastic curvature; negative: the paper weakens.
  double hardening = 0;

  /// B = E t^3 / (12 (1 - nu^2)) [N*m].
  double bendingStiffness() const {
    return youngs_modulus * thickness * thickness * thickness /
           (12 * (1 - poisson_ratio * poisson_ratio));
  }
  /// Plane-stress Lame constants lambda = E nu / (1 - nu^2) and mu = E / (2 (1 + nu)), times t
  /// [N/m].
  double membraneLambda() const {
    return youngs_modulus * thickness * poisson_ratio / (1 - poisson_ratio * poisson_ratio);
  }
  double membraneMu() const { return youngs_modulus * thickness / (2 * (1 + poisson_ratio)); }
  /// rho t [kg/m^2].
  double arealDensity() const { return density * thickness; }
};

/// Papers of which every parameter is known.
enum class PaperKind {
  /// 80 g/m^2: 0.1 mm thick, with the bending stiffness of a gravito-bending length
  /// (B / (2 rho t g))^(1/3) of 48 mm, as measured on A4. Bent beyond a radius of 5 mm, a strain of
  /// 1 % at its faces, it yields: there tensile curves of paper have their knee, beyond which they
  /// rise about 0.3 = hardening / (1 + hardening) times as steeply as before (Seth & Page, The
  /// stress strain curve of paper, 1981). However hard it is pressed, a fold then keeps less than
  /// a half turn, as paper's do (Farain, Phys. Rev. Applied 13, 014031, 2020).
  kCopyPaper
};

/// The papers by the names that people write.
const std::map<std::string, PaperKind>& paperNames();

Material materialOf(PaperKind paper);

}  // namespace shell_origami
