/// \file
/// Paper that passes through itself or a body, found by a check that shares nothing with the guard.
#pragma once

#include <shell_origami/contact/surface.h>
#include <shell_origami/sheet/sheet.h>

#include <array>
#include <vector>

namespace shell_origami {

/// Two triangles of a sheet, in ascending order.
using TrianglePair = std::array<int, 2>;

/// Returns the pairs of triangles that have a point in common but no vertex, by exact predicates.
/// Vertices with one place on the flat sheet, such as those of a slit's sides, are one.
std::vector<TrianglePair> crossings(const Sheet& sheet, const Positions& positions);

/// Returns a triangle of the sheet at `positions` that has a point in common with a body or is
/// inside of it; -1: there is none. `places` are those of the body's vertices.
int cutTriangle(const Sheet& sheet, const Positions& positions, const Surface& body,
                const Positions& places);

}  // namespace shell_origami
