/// \file
/// Stretching and shearing of one triangle: St. Venant-Kirchhoff in plane stress.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/energy/material.h>

namespace shell_origami {

/// Three points of a triangle in space, counter-clockwise seen from the front.
using TrianglePoints = std::array<Eigen::Vector3d, 3>;
using MembraneGradient = Eigen::Matrix<double, 9, 1>;
using MembraneHessian = Eigen::Matrix<double, 9, 9>;
/// The quantities of a deformed triangle of which its energy is a quadratic form; zero when flat.
using MembraneStrain = Eigen::Vector4d;
/// E11, E22, E12 along the axes of the flat sheet.
using GreenStrain = Eigen::Vector3d;

/// Returns E = (F^T F - I) / 2 of the map F of a flat triangle into space.
Eigen::Matrix2d greenStrain(const Eigen::Matrix<double, 3, 2>& f);

/// Returns F^T F of a map with this Green strain: the scalar product of vectors of the flat sheet
/// where they are in space.
Eigen::Matrix2d metricOf(const GreenStrain& green);

/// W = A t (lambda/2 tr(E)^2 + mu E:E) with the Green strain E = (F^T F - I) / 2 of the flat
/// triangle's map into space, less the one it rests in, and the plane-stress constants
/// lambda = E nu / (1 - nu^2), mu = E / (2 (1 + nu)).
class MembraneElement {
 public:
  MembraneElement() = default;
  MembraneElement(const std::array<Vector2, 3>& flat, const Material& material);

  double energy(const TrianglePoints& x, const MembraneStrain& rest) const;              ///< [J]
  MembraneGradient gradient(const TrianglePoints& x, const MembraneStrain& rest) const;  ///< [N]
  /// The exact Hessian where `strain` is strain(x) less the one at rest, or with `projected` a
  /// positive semidefinite one: the stress of the strain is clamped to tension in its geometric
  /// part.
  MembraneHessian hessian(const TrianglePoints& x, const MembraneStrain& strain,
                          bool projected) const;
  /// E11, E22, E12, 0.
  MembraneStrain strain(const TrianglePoints& x) const;
  /// The same after a displacement, to first order in it by the derivative at `along`.
  MembraneStrain strainAfter(const TrianglePoints& x, const TrianglePoints& along,
                             const TrianglePoints& displacement) const;
  /// Returns the strain() of a triangle that has this Green strain.
  static MembraneStrain strainOf(const GreenStrain& green) {
    return {green[0], green[1], green[2], 0};
  }
  /// Area in space over flat area.
  double areaRatio(const TrianglePoints& x) const;

 private:
  using Deformation = Eigen::Matrix<double, 3, 2>;
  Deformation deformation(const TrianglePoints& x) const;
  /// Second Piola-Kirchhoff times A t [N m].
  Eigen::Matrix2d stress(const Eigen::Matrix2d& strain) const;

  Eigen::Matrix<double, 3, 2> shape_;  ///< gradients of the three shape functions [1/m]
  double lambda_ = 0, mu_ = 0;         ///< times A t [N m]
};

}  // namespace shell_origami
