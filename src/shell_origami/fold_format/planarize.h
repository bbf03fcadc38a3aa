/// \file
/// Lines as people draw them, made a pattern without faces.
#pragma once

#include <shell_origami/fold_format/crease_pattern.h>

namespace shell_origami {

/// Points of a drawing closer than this part of its size are one.
constexpr double kDrawnPrecision = 1e-3;

/// Makes a planar graph of a pattern's edges and finds its border.
///
/// Points closer than kDrawnPrecision to an earlier one become that one. Edges are divided where
/// they cross, and where they pass a point closer than that, which is put on them. Of edges that
/// then lie on each other one stays: border or cut before crease before flat; border on border is a
/// cut, as the sides of an open slit are. What sticks out of the paper of an edge that is on it as
/// well is left out, and flat edges may be left out of a pattern that has border or cuts.
///
/// Border or cut around all is border, border with the same paper on both sides is a cut. Where
/// there is neither, what surrounds all edges is the border. `notes` says what was changed.
///
/// Throws std::invalid_argument naming two edges that lie on each other and fold differently, or if
/// there are too many edges or crossings, or nothing is enclosed.
void makePlanar(CreasePattern& pattern, bool keep_flat_edges);

}  // namespace shell_origami
