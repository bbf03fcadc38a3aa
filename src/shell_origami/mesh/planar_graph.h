/// \file
/// Checks of a planar graph, and what its triangulation needs to be seeded.
#pragma once

#include <shell_origami/mesh/triangulate.h>

#include <vector>

namespace shell_origami {

/// \throws std::invalid_argument naming the point or segment that is not finite, out of range,
///         without length, or crosses another.
void checkGraph(const PlanarGraph& graph);

/// Cuts every segment evenly into pieces of about `spacing`, none longer than `longest`. Points
/// are appended; the pieces replace the segments. Returns the points along each old segment.
std::vector<std::vector<int>> subdivide(PlanarGraph& graph, double spacing, double longest);

/// Points of a lattice of equilateral triangles of edge `spacing` inside the paper, none closer
/// to a segment than `clearance`. `outline` holds the paper's border edges, by their ends.
std::vector<Vector2> latticePoints(const PlanarGraph& graph, const std::vector<Segment>& outline,
                                   double spacing, double clearance);

}  // namespace shell_origami
