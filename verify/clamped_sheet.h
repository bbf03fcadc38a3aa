/// \file
/// A wide sheet clamped along one side: a plate that behaves as the cantilever of beam theory.
#pragma once

#include <shell_origami/origami/simulation.h>

namespace shell_origami {

/// A sheet clamped by two rows of held vertices.
///
/// It is wider than long, so that its rows of triangles run across it. The hinges of a row
/// represent the paper half a row to either side. The clamp is therefore half way between the two
/// held rows, and the length is measured from there: from the second row it would be half a row too
/// short, an error of first order in the mesh.
///
/// Why wide: hinges of an equilateral mesh store, for curvatures k1 and k2, the energy
/// B/2 (k1^2 + k2^2 - 2/3 k1 k2) per area, as a plate with Poisson's ratio -1/3. A narrow strip
/// would curl across by k1/3 and be softer by a ninth. The clamp, the breadth and, at large
/// deflections, stretching keep a wide sheet from doing so.
struct ClampedSheet {
  Sheet sheet;
  double clamp;                    ///< x of the clamp [m]
  double length;                   ///< from the clamp to the free side [m]
  std::vector<std::int64_t> held;  ///< vertices of the first two rows
  std::vector<int> tip;            ///< vertices of the free side
};

/// Returns a sheet about `length` [m] long and `aspect` times as wide, with `rows` rows of
/// triangles.
ClampedSheet clampedSheet(double length, double aspect, int rows);

/// Returns copy paper with Poisson's ratio 0, so that a strip is as stiff as a plate.
Material strip();

/// Returns the first natural frequency [1/s] of a cantilever: .55959 sqrt(B / (rho t L^4)), where
/// .55959 = 1.8751^2 / 2 pi (Euler-Bernoulli).
double firstFrequency(const Material& material, double length);

}  // namespace shell_origami
