/// \file
/// The heavy elastica: strips that hang under their own weight, with large deflections.
///
/// Lengths are over the strip's, L; gamma = rho t g L^3 / B. A strip hangs towards -y; theta is its
/// angle below the horizontal. Integrated with the classical Runge-Kutta method, to better than
/// 1e-8.
#pragma once

#include <shell_origami/base/geometry.h>

#include <vector>

namespace shell_origami {

/// Returns points of a cantilever of length 1, clamped horizontally at the origin, from the clamp
/// to the tip, evenly spaced along it. With the arc length s
///   theta'' = -gamma (1 - s) cos(theta),   theta(0) = 0,   theta'(1) = 0.
/// Solved by shooting from the tip.
std::vector<Vector2> heavyElastica(double gamma);

/// A strip on a table, of which a length 1 was beyond the edge while it lay flat, held far behind
/// the edge. The table is smooth.
struct EdgeElastica {
  std::vector<Vector2> hanging;  ///< from the edge, the origin, to the tip
  double lift;                   ///< arc length behind the edge that does not touch the table
  double slope;                  ///< theta at the edge [rad]
  double bulge;                  ///< largest height behind the edge
};

/// Returns the equilibrium of that strip. The edge is no clamp: it carries a force N across the
/// strip and no moment. The moment of the part beyond it lifts the strip off the table behind it,
/// up to where a strip that lies flat begins: there theta = 0, theta' = 0 and y = 0. With the
/// distance u from the tip along the strip and the force (P_x, P_y) of all that is beyond u,
///   theta'' = P_x sin(theta) + P_y cos(theta),   theta'(0) = 0,
///   P = (0, -gamma u) before the edge, at u = a,
///   P = N (sin(theta(a)), cos(theta(a))) - (0, gamma u) behind it,
/// and the part that lifts off takes a little of the length that hangs. The four unknowns a, N,
/// theta(0) and the lift are found by Newton's method, for gamma up to 8. For small gamma the lift
/// is sqrt(2) and the slope at the edge sqrt(2) gamma / 12.
EdgeElastica elasticaOverEdge(double gamma);

}  // namespace shell_origami
