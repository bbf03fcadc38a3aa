/// \file
/// Where a fold's plane cuts the layers of folded paper.
#pragma once

#include <shell_origami/origami/layers.h>

#include <vector>

namespace shell_origami {

/// Part of the sheet's size by which a panel must reach beyond a fold's plane to be cut by it.
constexpr double kReach = 0.004;

/// The line along which a plane cuts a panel, or a crease of it that lies on the plane.
struct LayerCut {
  int panel;        ///< panelOfTriangle()
  int triangle;     ///< one of the panel that the cut belongs to
  Segment line;     ///< on the flat sheet [m]
  int crease = -1;  ///< index into Sheet::creases(), where one lies on the plane
};

/// The angle of a cut's crease that turns by an angle [rad]: one that is there turns further.
/// \throws std::invalid_argument where it would pass 180 degrees
double angleOf(const LayerCut& cut, double by, const std::vector<CreaseStatus>& creases);

/// Returns the cuts of what moves: of panels in their order, then of creases in theirs. A cut ends
/// at a corner or at the end of a crease that is near.
/// \param moves  of each triangle
/// \throws std::invalid_argument where a panel is bent along the cut
std::vector<LayerCut> cutLayers(const Sheet& sheet, const ViewedPaper& paper,
                                const FoldPlane& plane, const LayersBesidePlane& layers,
                                const std::vector<bool>& moves);

}  // namespace shell_origami
