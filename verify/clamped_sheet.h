/// \file
/// A wide sheet clamped along one side, the plate that a cantilever stands for.
#pragma once

#include <shell_origami/origami/simulation.h>

namespace shell_origami {

/// A sheet clamped by two rows of held vertices.
///
/// It is wider than long, so that its rows of triangles run across it. A row's hinges stand for the
/// paper half a row to either side of it, so that the clamp lies half way between the two held
/// rows, and the length counts from there: counted from the second row it would come short by half
/// a row, an error of first order in the mesh.
///
/// Why wide: hinges of an equilateral mesh store, for curvatures k1 and k2, the energy
/// B/2 (k1^2 + k2^2 - 2/3 k1 k2) per area, that of a plate with Poisson ratio -1/3. A narrow strip
/// would curl across by k1/3 and be softer by a ninth. The clamp, the breadth and, where it bends
/// far, stretching keep a wide one from doing so.
struct ClampedSheet {
  Sheet sheet;
  double clamp;                    ///< x of the clamp [m]
  double length;                   ///< from the clamp to the free side [m]
  std::vector<std::int64_t> held;  ///< vertices of the first two rows
  std::vector<int> tip;            ///< vertices of the free side
};

/// About `length` long and `aspect` times as wide, in `rows` rows of triangles.
ClampedSheet clampedSheet(double length, double aspect, int rows);

/// Copy paper with Poisson ratio 0, so that a strip's stiffness is the plate's.
Material strip();

/// First natural frequency [1/s] of a cantilever of small amplitude: (1.8751^2 / 2 pi) =
/// .55959 times sqrt(B / (rho t L^4)) (Euler-Bernoulli).
double firstFrequency(const Material& material, double length);

}  // namespace shell_origami
