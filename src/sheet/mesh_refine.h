/// \file
/// Makes a triangulation fine and even. Labelled edges and the border keep their place; they are
/// split, and a split hands on the label.
#pragma once

#include "sheet/triangulation.h"

namespace shell_origami {

/// What triangulate() and its peers refuse to exceed.
constexpr double kMostTriangles = 1e6;
/// \throws std::invalid_argument unless max_edge is positive and finite
void checkMaxEdge(double max_edge);
/// \throws std::invalid_argument when there would be more than kMostTriangles
void checkCount(double triangles, double max_edge);

/// Splits edges at their middle until none is longer than `longest` and no triangle is a sliver,
/// other than between two labelled edges, unless all its edges are short beside `longest`.
/// Follows the longest-edge path of each bad triangle (Rivara 1997), flipping to Delaunay.
/// \throws std::invalid_argument when it takes more than kMostTriangles.
void refineMesh(Triangulation& mesh, double longest);

/// Shifts loose vertices and flips unlabelled edges so that triangles come closer to equilateral.
/// No edge that was short enough becomes longer than `longest`, no triangle becomes worse than
/// the worst beside it.
void relaxMesh(Triangulation& mesh, double longest);

}  // namespace shell_origami
