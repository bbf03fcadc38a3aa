/// \file
/// Random sheets - rectangles, an L, a ring, a star, a square with slits - and lines on them; and
/// what no edit of one may change.
#pragma once

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/sheet.h>

#include <random>

namespace shell_origami {

PlanarGraph ell();
PlanarGraph ring();
/// A square with a slit from the border, one inside, and two that cross.
Triangulation slits(double max_edge);

class RandomSheets {
 public:
  explicit RandomSheets(unsigned seed) : random_(seed) {}

  /// Uniform in [0, 1).
  double unit();
  double between(double low, double high) { return low + (high - low) * unit(); }
  int below(int count) { return static_cast<int>(count * unit()); }
  PlanarGraph outline();
  /// One of those outlines, or slits().
  Triangulation mesh(double max_edge);
  /// Anywhere on the paper, three times in ten at a vertex.
  Vector2 point(const Sheet& sheet);
  /// Between two such points that are not the same.
  Segment line(const Sheet& sheet);

 private:
  std::mt19937 random_;
};

/// Length of the outline [m].
double borderLength(const Sheet& sheet);

/// Triangles with an angle below 15 degrees that lines do not force. Lines force an angle where
/// they meet at it, and slivers where they or their ends pass closer than a tenth of max_edge.
int unforcedSlivers(const Sheet& sheet, double max_edge);

}  // namespace shell_origami
