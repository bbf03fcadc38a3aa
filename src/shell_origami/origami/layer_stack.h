/// \file
/// The layers of folded paper that lie on each other at one place, as a viewer sees them.
#pragma once

#include <shell_origami/origami/landmark.h>
#include <shell_origami/origami/viewed_paper.h>

#include <vector>

namespace shell_origami {

struct StackedLayer {
  int panel;     ///< panelOfTriangle()
  Vector2 flat;  ///< the place on the flat sheet that is seen there [m]
  double depth;  ///< from the layer nearest to the viewer [m]
};

/// Returns the layers at a point of the flat sheet, wherever that is now, the nearest to the viewer
/// first. A layer is there once for each panel, also where panels meet in a crease.
/// \throws std::invalid_argument where the point is off the paper, or as viewedPaper() does
std::vector<StackedLayer> layersAt(const Landmark& point, const Viewpoint& view,
                                   const Simulation& simulation);

/// Returns the viewpoint of somebody who looks at the paper from a direction, at the triangle that
/// faces it most.
/// \param from  direction from the paper to the viewer, of any length
/// \throws std::invalid_argument where the direction is none, or along the paper
Viewpoint viewFrom(const Vector3& from, const Simulation& simulation);

}  // namespace shell_origami
