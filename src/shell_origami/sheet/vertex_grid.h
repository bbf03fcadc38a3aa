/// \file
/// A spatial search for vertices of the flat sheet.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <vector>

namespace shell_origami {

/// The vertices of a sheet in the cells of a grid, about one a cell. Valid while the sheet is
/// unchanged.
class VertexGrid {
 public:
  explicit VertexGrid(const Sheet& sheet);

  /// Returns the vertex whose flat position is nearest to p, which must be finite; of those equally
  /// near, as on the sides of a slit, the one with the lowest number.
  int nearest(const Vector2& p) const;

 private:
  int cell(double offset, int count) const;

  const std::vector<Vector2>& points_;
  Vector2 corner_;  ///< lower left of the grid [m]
  double size_;     ///< of a cell [m]
  int columns_, rows_;
  std::vector<int> firsts_;    ///< of each cell and one more, the place of its first in vertices_
  std::vector<int> vertices_;  ///< by cell, ascending
};

}  // namespace shell_origami
