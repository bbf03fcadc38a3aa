/// \file
/// Item 1: the closed-form derivatives against automatic differentiation of energies that are
/// written down anew, from their definitions.
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

/// A hinge's flat shape: its edge from (0, 0) to (length, 0), and where its wings' apexes stand
/// over and under it [m].
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
/// Of the whole energy of an ordinary hinge or a crease, through Shell.
DerivativeError hingeEnergyError(const HingeShape& shape, double theta, double rest, bool crease);
/// Stretched by `stretch` along and sheared, in space; `kind` chooses the model.
DerivativeError membraneError(MembraneKind kind, double stretch);

}  // namespace shell_origami
