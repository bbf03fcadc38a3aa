/// \file
/// Rigid origami: paper whose panels stay flat and which bends in its creases alone.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <cmath>
#include <functional>
#include <vector>

namespace shell_origami {

/// Panels that close but for less than this are taken to close [rad]: files round their angles.
constexpr double kClosingTolerance = M_PI / 180;

/// Returns where vertices are [m], one column each, if every crease has its angle (one for each
/// crease [rad], valley > 0) and nothing else bends: triangle after triangle, starting from the
/// first one in its flat place. Where panels do not close around a vertex, they part somewhere.
Positions foldRigidly(const Sheet& sheet, const std::vector<double>& crease_angles);

/// Returns the angle [rad, 0 to pi] that is left when the panels around an inner vertex are turned
/// about each crease in succession: zero where they close. On the border it is zero.
double closingError(const Sheet& sheet, int vertex, const std::vector<double>& crease_angles);

/// By how much the sectors between the creases around an inner vertex, every other one taken, miss
/// pi [rad] (Kawasaki's theorem: a vertex that folds flat misses nothing). NaN: their number is
/// odd.
double kawasakiError(const Sheet& sheet, int vertex);

/// Returns the angle of each crease that leaves an inner vertex, counter-clockwise.
std::vector<double> anglesAround(const Sheet& sheet, int vertex,
                                 const std::vector<double>& crease_angles);

/// Returns the part of each triangle: triangles are of one part where they are connected by edges
/// that join. Parts are numbered in the order of their first triangles.
std::vector<int> connectedTriangles(const Sheet& sheet,
                                    const std::function<bool(const Edge&)>& joins);

/// Returns the panel of each triangle: triangles are of one panel where no crease parts them.
/// Panels are numbered in the order of their first triangles.
std::vector<int> panelOfTriangle(const Sheet& sheet);

/// The vertices inside the paper at which creases meet or end, ascending.
std::vector<int> innerCreaseVertices(const Sheet& sheet);

}  // namespace shell_origami
