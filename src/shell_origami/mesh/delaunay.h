/// \file
/// Constrained Delaunay triangulation. CGAL is hidden here and nowhere else.
#pragma once

#include <shell_origami/mesh/triangulate.h>

#include <vector>

namespace shell_origami {

/// The triangles between the graph's own points that keep its segments as edges and lie inside
/// its outline and in no hole, counter-clockwise, smallest first vertex first.
/// \throws std::invalid_argument when points coincide, segments cross, or the segments enclose
///         nothing. \pre indices are in range and points finite
std::vector<Triangle> constrainedDelaunay(const PlanarGraph& graph);

}  // namespace shell_origami
