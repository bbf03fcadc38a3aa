/// \file
/// The heavy elastica: a cantilever under its own weight, with large deflections.
#pragma once

#include <shell_origami/base/geometry.h>

#include <vector>

namespace shell_origami {

/// Returns points of a cantilever of length 1, clamped horizontally at the origin and hanging
/// towards -y, from the clamp to the tip, evenly spaced along it. With the arc length s and the
/// angle theta below the horizontal,
///   theta'' = -gamma (1 - s) cos(theta),   theta(0) = 0,   theta'(1) = 0,
/// where gamma = rho t g L^3 / B. Solved by shooting from the tip with the classical Runge-Kutta
/// method, to better than 1e-8.
std::vector<Vector2> heavyElastica(double gamma);

}  // namespace shell_origami
