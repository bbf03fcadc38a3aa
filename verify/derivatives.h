/// \file
/// Item 1: the closed-form derivatives against automatic differentiation of the energies'
/// definitions, which are written down here once more.
#pragma once

#include <shell_origami/energy/dihedral.h>
#include <shell_origami/energy/membrane.h>

#include <vector>

namespace shell_origami {

/// Relative differences, in the Frobenius norm.
struct DerivativeError {
  double value = 0, gradient = 0, hessian = 0;

  double largest() const;
};

/// Bounds on the differences. Fold angles: the rounding error 1.1e-16 of some 40 operations on
/// triangles of aspect 100. Energies of hinges and creases: that of one operation, times the
/// aspect, times theta / sin(theta) = 180 for a hinge one degree from 180, twice for each of two
/// derivatives. Membranes: 200 operations.
constexpr double kFoldAngleRounding = 4e-13, kHingeRounding = 8e-12, kMembraneRounding = 2e-14;

/// A hinge's flat shape: its edge from (0, 0) to (length, 0), and the apexes of its triangles above
/// and below it [m].
struct HingeShape {
  double length, foot2, height2, foot3, height3;

  /// Bent by theta without stretching, then turned and shifted.
  HingePoints bent(double theta) const;
};

/// Near-equilateral hinges, lopsided ones, and slivers of aspect 100.
const std::vector<HingeShape>& hingeShapes();
/// 1 to 179 degrees, both signs [rad].
std::vector<double> hingeAngles();

DerivativeError foldAngleError(const HingePoints& points);
/// For the energy of an ordinary hinge or of a crease, through Shell.
DerivativeError hingeEnergyError(const HingeShape& shape, double theta, double rest, bool crease);
/// For the membrane of this kind in a triangle that is stretched by `stretch` and sheared, in
/// space.
DerivativeError membraneError(MembraneKind kind, double stretch);

}  // namespace shell_origami
