/// \file
/// Makes a triangulation fine and even. Labelled edges and the border keep their place; they are
/// split, and a split hands on the label.
#pragma once

#include <shell_origami/mesh/triangulation.h>

namespace shell_origami {

/// A sheet has at most so many triangles: a step of more takes minutes.
constexpr double kMostTriangles = 1e6;
/// Memory that a simulation takes for each triangle [bytes], most of it for its factorized matrix.
constexpr double kTriangleMemory = 8000;

/// Throws std::invalid_argument unless max_edge is positive and finite.
void checkMaxEdge(double max_edge);
/// Throws std::invalid_argument if there would be more than kMostTriangles.
void checkCount(double triangles, double max_edge);
/// Throws std::invalid_argument if there would be more than kMostTriangles or a simulation of so
/// many would take more memory than is available.
void checkPlan(double triangles, double max_edge);
/// Throws std::invalid_argument if a simulation of so many triangles would take more memory than is
/// available.
void checkMemory(double triangles);

/// Whether the edge is on the border or labelled.
bool isFixed(const Triangulation& mesh, Triangulation::Side side);

/// Whether the triangle has an angle below `least` [rad] that labelled edges and border do not
/// force on it.
bool isSliver(const Triangulation& mesh, int triangle, double least);

/// The edge to split for a bad triangle: the end of its path of ever longer edges (Rivara 1997).
Triangulation::Side terminalEdge(const Triangulation& mesh, int triangle);

double longestEdge(const Triangulation& mesh, int triangle);

/// Splits edges at their middle until none is longer than `longest` and no triangle is a sliver,
/// other than between two labelled edges, unless all its edges are short beside `longest`.
/// Flips to Delaunay as it goes.
/// \throws std::invalid_argument when it takes more than kMostTriangles.
void refineMesh(Triangulation& mesh, double longest);

/// Shifts loose vertices and flips unlabelled edges so that triangles come closer to equilateral.
/// No edge that was short enough becomes longer than `longest`, no triangle becomes worse than
/// the worst beside it.
void relaxMesh(Triangulation& mesh, double longest);

}  // namespace shell_origami
