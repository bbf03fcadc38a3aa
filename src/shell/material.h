/// \file
/// What the paper is made of.
#pragma once

namespace shell_origami {

/// Isotropic elastic paper. Defaults are copy paper.
struct Material {
  double youngs_modulus = 2e9;    ///< E [Pa]
  double poisson_ratio = 0.3;     ///< nu
  double thickness = 1e-4;        ///< t [m]
  double density = 800;           ///< rho [kg/m^3]
  double crease_stiffness = 5e-3; ///< c [N*m/rad per m of crease]
  double air_damping = 5;         ///< mass-proportional [1/s]

  /// B = E t^3 / (12 (1 - nu^2)) [N*m].
  double bendingStiffness() const {
    return youngs_modulus * thickness * thickness * thickness /
           (12 * (1 - poisson_ratio * poisson_ratio));
  }
  /// rho t [kg/m^2].
  double arealDensity() const { return density * thickness; }
};

}  // namespace shell_origami
