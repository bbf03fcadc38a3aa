/// \file
/// Cuts a flat outline into near-equilateral triangles (CGAL).
#pragma once

#include <shell_origami/mesh/triangulation.h>

#include <array>
#include <optional>
#include <vector>

namespace shell_origami {

/// Points and straight segments between them that must appear as edges of the triangulation.
/// Segments meet only at their ends. The outline is among the segments: what is not enclosed by
/// it is not paper.
struct PlanarGraph {
  std::vector<Vector2> points;
  std::vector<std::array<int, 2>> segments;
  std::vector<Vector2> holes;  ///< one point inside each hole
};

/// Two segments that share more than an end, or come closer than 1e-9 of the graph's size where
/// they share none: the first such pair, as indices into `segments`.
std::optional<std::array<int, 2>> crossingSegments(const PlanarGraph& graph);

/// A triangulation of a graph, and what became of its segments.
struct GraphMesh {
  Triangulation triangulation;
  /// Of each segment of the graph, the vertices along it from its first end to its second.
  std::vector<std::vector<int>> chains;
};

/// A constrained Delaunay triangulation refined until no edge is longer than max_edge [m] and
/// triangles are near-equilateral, as far as the segments leave room for that. A max_edge of 0
/// adds no points. The graph's points keep their indices; points added on a segment follow, then
/// those inside. The same graph gives the same bits.
/// \throws std::invalid_argument when max_edge is negative or not finite, would give more than a
///         million triangles, segments cross, or a point is off the paper.
GraphMesh meshGraph(const PlanarGraph& graph, double max_edge);

/// The same without the chains. \throws std::invalid_argument also when max_edge is 0
Triangulation triangulate(const PlanarGraph& graph, double max_edge);

/// The rectangle from (0, 0) to (width, height) [m] in rows of near-equilateral triangles, none
/// with an angle below 34 degrees. Its corners are the vertices 0 to 3, counter-clockwise from
/// (0, 0). \throws std::invalid_argument
Triangulation triangulateRectangle(double width, double height, double max_edge);

}  // namespace shell_origami
