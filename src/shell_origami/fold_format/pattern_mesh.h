/// \file
/// From a crease pattern to a sheet.
#pragma once

#include <shell_origami/fold_format/crease_pattern.h>
#include <shell_origami/sheet/sheet.h>

#include <array>
#include <vector>

namespace shell_origami {

/// A sheet made of a pattern, and where its vertices come from.
struct PatternSheet {
  Sheet sheet;
  /// Of each vertex, those of the file that it lies midway between: mostly one, twice. Empty unless
  /// the sheet has the pattern's own vertices (max_edge 0).
  std::vector<std::array<int, 2>> file_vertices;
};

/// Cuts the pattern into triangles with edges of at most max_edge [units of the pattern], or, for
/// 0, takes its own triangles, and opens it along its cuts.
/// \throws std::invalid_argument naming what is wrong with the pattern
PatternSheet makeSheet(const CreasePattern& pattern, double max_edge);

}  // namespace shell_origami
