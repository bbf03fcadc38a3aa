/// \file
/// Paper folded exactly flat: the panels that lie on each other, and the edges in which they meet.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <array>
#include <vector>

namespace shell_origami {

/// Corners of a convex polygon, counter-clockwise.
using Polygon = std::vector<Vector2>;

/// A part of the paper without a shut crease in it. It is convex: at an inner vertex that folds
/// flat every other sector adds up to pi (Kawasaki), so that none is larger.
struct FlatPanel {
  std::vector<int> triangles;
  Polygon outline;
  Polygon core;   ///< what is deeper inside the outline than FlatFold::tolerance
  bool front_up;  ///< whether it shows its front from above
};

/// An edge of the sheet in a shut crease, where two panels meet and lie on the same side of it.
struct ShutEdge {
  std::array<int, 2> panels;
  Segment ends;
  int crease;
  bool valley;
};

struct FlatFold {
  std::vector<Vector2> vertices;  ///< of the sheet, seen from above, where its first panel shows
                                  ///< its front [m]
  std::vector<FlatPanel> panels;
  std::vector<ShutEdge> edges;
  double tolerance;  ///< by less than this [m] nothing overlaps
};

/// Folds a sheet whose creases have the angles -M_PI, 0 or M_PI, one for each. Panels go on across
/// creases that stay flat, so that an order of panels is the same on both sides of these.
/// \throws std::invalid_argument where another angle is asked for, panels do not close around a
///         vertex, or one is not convex, as on a paper with a notch
FlatFold foldFlat(const Sheet& sheet, const std::vector<double>& crease_angles);

double areaOf(const Polygon& polygon);  ///< [m^2]

/// Returns what a polygon shares with a convex one whose sides are moved inwards by `inset` [m].
/// It has no corners, or no area, where they share nothing.
Polygon clip(Polygon polygon, const Polygon& convex, double inset = 0);

/// Returns the length of a segment inside a convex polygon [m].
double lengthInside(const Segment& segment, const Polygon& convex);

}  // namespace shell_origami
