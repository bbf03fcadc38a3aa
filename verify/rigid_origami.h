/// \file
/// Closed forms of rigid folding, in which only creases bend.
#pragma once

#include "verify/folding.h"

#include <array>
#include <vector>

namespace shell_origami {

/// A flat-foldable vertex: sectors a, b, pi - a, pi - b [rad] between creases 0..3 have one degree
/// of freedom and two folding modes (Lang, Twists, Tilings, and Tessellations, 2018, section 8).
struct Degree4Vertex {
  double a, b;
  bool twisted;  ///< the mode: creases 0 and 2 fold to opposite sides, else 1 and 3

  /// tan(rho1/2) / tan(rho0/2)
  double ratio() const;
  std::array<double, 4> angles(double rho0) const;
  /// Returns a disc of radius 30 mm whose crease pattern has the signs of this mode.
  Sheet sheet() const;
  /// Returns the largest error of the creases [rad], given the angle of crease 0.
  double error(const std::vector<CreaseStatus>& creases) const;
};

/// Returns pseudorandom vertices, every other one twisted, always the same. Sectors have 35 to 145
/// degrees, so that triangles fit in. Sectors within 20 degrees of a = b or a + b = 180 degrees are
/// left out: there the ratio of a twisted or an untwisted vertex tends to infinity or zero.
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

/// Returns the fold angle of a waterbomb base's mountains, given that of its valleys, the
/// diagonals.
double waterbombMountain(double valley);

/// Returns the slope of the cone that forms when a mountain and a valley that start at one inner
/// point, `alpha` apart, are folded to 180 degrees: they remove 2 alpha from the 2 pi around it.
double coneSlope(double alpha);

/// Returns a disc with such a pair of creases, rho0 and rho1, around the direction of y, folded to
/// 176 degrees and at rest. Throws std::runtime_error if a step does not converge.
Simulation foldedCone(double alpha, double radius);

/// Returns the slope of the cone that fits the border best, without the points near the creases.
double measuredConeSlope(const Simulation& simulation, double alpha, double radius);

}  // namespace shell_origami
