/// \file
/// A manoeuvre's phases, over ordinary folds.
#pragma once

#include <shell_origami/origami/crease_paths.h>
#include <shell_origami/origami/fold_plane.h>
#include <shell_origami/origami/viewed_paper.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Folds that run together. The next phase begins when they are done and the paper has settled, or
/// had time to.
struct FoldPhase {
  std::vector<FoldEdit> folds;
  double rest = 0;  ///< within which the paper may settle [s]
};

/// From its beginning until the next phase begins, at most [s].
double lengthOf(const FoldPhase& phase);

struct ManoeuvrePlan {
  std::vector<FoldPhase> phases;
  /// The creases that it makes or changes, as they are to be after it.
  std::vector<FoldEdit> result;
  Viewpoint after;
};

/// How a manoeuvre is to be done.
struct ManoeuvreManner {
  double angle = kShutAngle;  ///< by which creases are shut [rad]
  double duration = 1;        ///< of all phases, without their rest [s]
  bool looser = false;        ///< opens what is in the way farther
};

/// A fold along a line of the flat sheet.
FoldEdit lineFold(const Segment& line, double angle, double duration);

/// Returns the vertex of the outline at a landmark.
/// \throws std::invalid_argument where none is near. `what` says in the message what it is
int outlineVertexAt(const Landmark& landmark, const char* what, const Sheet& sheet);

/// A sentence for each of these folds whose creases are far from its angle, or to the other side.
std::vector<std::string> failuresOf(const std::vector<FoldEdit>& folds,
                                    const Simulation& simulation);

/// Returns the creases that are not flat.
FoldedCreases foldedCreases(const Simulation& simulation);

/// Returns the angle that a crease is folded to. \throws std::invalid_argument where that is not
/// shut
double shutAngle(int crease, const Simulation& simulation);

}  // namespace shell_origami
