/// \file
/// Stretching and shearing of one triangle by Discrete Shells' edge-length and area terms.
#pragma once

#include <shell_origami/energy/membrane.h>

namespace shell_origami {

/// W = A (c sum_e (1 - |e| / |e_flat|)^2 + a (1 - A_now / A)^2) of a triangle of flat area A
/// (Grinspun et al., Discrete Shells, 2003, section 3: W_L and W_A), each term less that at rest.
/// With c = 4 mu t / 3 and a = (lambda - mu) t / 2 an equilateral triangle strained a little has
/// the plane-stress energy of the material. Below nu = 1/3 that asks for a < 0, which would make
/// paper collapse: a is then 0 and the sheet as stiff as mu t and nu = 1/3 are.
class EdgeAreaMembrane {
 public:
  EdgeAreaMembrane(const std::array<Vector2, 3>& flat, const Material& material);

  double energy(const TrianglePoints& x, const MembraneStrain& rest) const;              ///< [J]
  MembraneGradient gradient(const TrianglePoints& x, const MembraneStrain& rest) const;  ///< [N]
  /// The exact Hessian where `strain` is strain(x) less the one at rest, or with `projected` a
  /// positive semidefinite one: what compressed edges and a shrunk area add across their direction
  /// is left out.
  MembraneHessian hessian(const TrianglePoints& x, const MembraneStrain& strain,
                          bool projected) const;
  /// |e| / |e_flat| - 1 of the edge opposite each corner, and A_now / A - 1.
  MembraneStrain strain(const TrianglePoints& x) const;
  /// The same after a displacement, to first order in it.
  MembraneStrain strainAfter(const TrianglePoints& x, const TrianglePoints& along,
                             const TrianglePoints& displacement) const;
  /// Returns the strain() of a triangle that has this Green strain.
  MembraneStrain strainOf(const GreenStrain& green) const;
  /// Area in space over flat area.
  double areaRatio(const TrianglePoints& x) const;

 private:
  std::array<Vector2, 3> edges_;   ///< on the flat sheet, opposite each corner [m]
  std::array<double, 3> lengths_;  ///< of these [m]
  double area_;                    ///< flat [m^2]
  double edge_stiffness_;          ///< A c [J]
  double area_stiffness_;          ///< A a [J]
};

}  // namespace shell_origami
