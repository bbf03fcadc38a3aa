/// \file
/// Closed forms of paper that folds in its creases alone.
#pragma once

#include "verify/folding.h"

#include <array>
#include <vector>

namespace shell_origami {

/// A flat-foldable vertex: sectors a, b, pi - a, pi - b [rad] between creases 0..3 leave one degree
/// of freedom and two ways to use it (Lang, Twists, Tilings, and Tessellations, 2018, section 8).
struct Degree4Vertex {
  double a, b;
  bool twisted;  ///< opposite creases 0 and 2 fold to opposite sides, else 1 and 3

  /// tan(rho1/2) / tan(rho0/2)
  double ratio() const;
  std::array<double, 4> angles(double rho0) const;
  /// A disc of radius 30 mm whose pattern asks for this way.
  Sheet sheet() const;
  /// Largest error of the creases against the angle that crease 0 has [rad].
  double error(const std::vector<CreaseStatus>& creases) const;
};

/// Vertices, every other one twisted, the same ones each time. Sectors have 35 to 145 degrees, so
/// that triangles fit in. At a = b a twisted vertex's crease 1 shuts while crease 0 stays flat, at
/// a + b = 180 degrees an untwisted one's crease 1 stays flat: within 20 degrees of either, the
/// angles hang on a ratio near 0 or infinity.
std::vector<Degree4Vertex> randomDegree4Vertices(int count);

/// Miura-ori with panels of sides a, b and acute angle q, folded by g (Schenk & Guest 2013).
struct Miura {
  double a, b, q, g;

  double zigzagAngle() const { return 2 * g; }
  double otherAngle() const;  ///< of the straight lines' creases
  double height() const;      ///< [m]
  double length() const;      ///< l, of a panel along the rows [m]
  double width() const;       ///< s, of a panel across the rows [m]
  double poissonRatio() const;
};

/// The mountains of a waterbomb base whose valleys, the diagonals, have this angle.
double waterbombMountain(double valley);

/// Slope of the cone that is left when a mountain and a valley from one inner point, `alpha` apart,
/// are folded shut: they take 2 alpha out of the sheet's 2 pi around it.
double coneSlope(double alpha);

/// A disc with such a pair of creases, rho0 and rho1, about the direction of y, folded to 176
/// degrees and at rest. \throws std::runtime_error
Simulation foldedCone(double alpha, double radius);

/// Slope of the border's points seen from the center, about the axis of the cone that fits them
/// best, without those near the creases.
double measuredConeSlope(const Simulation& simulation, double alpha, double radius);

}  // namespace shell_origami
