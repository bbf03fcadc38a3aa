/// \file
/// Which triangles of a surface in space pass through each other, by exact predicates.
#pragma once

#include <shell_origami/base/geometry.h>

#include <array>
#include <vector>

namespace shell_origami {

/// Returns the pairs of triangles (by index, ascending) that have a point in common but no vertex.
/// Exact for the given positions [m]. Triangles without area meet nothing.
/// \param names one number a vertex; vertices of one name are one, such as those of a slit's sides
/// \pre positions are finite
std::vector<std::array<int, 2>> intersections(const Positions& positions,
                                              const std::vector<Triangle>& triangles,
                                              const std::vector<int>& names);

}  // namespace shell_origami
