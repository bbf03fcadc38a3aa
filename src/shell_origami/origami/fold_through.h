/// \file
/// Folds on folded paper, as a person sees it: through the layers that lie on each other.
#pragma once

#include <shell_origami/origami/fold_plane.h>
#include <shell_origami/origami/layers.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

struct FoldThrough {
  FoldAxiom axiom;
  FoldLayers layers = FoldLayers::kAll;
  int count = 1;                   ///< of kTop
  Landmark flap;                   ///< of kFlap
  bool behind = false;             ///< the way: away from the viewer instead of towards
  double angle = kShutAngle;       ///< by which the layers turn [rad], inside (0, pi)
  std::optional<double> duration;  ///< [s]; none: SimulationConfig::fold_duration
  std::string name;                ///< of the new creases; empty: generated
};

/// The fold of one layer.
struct LayerFold {
  int panel;     ///< panelOfTriangle()
  Segment line;  ///< on the flat sheet [m]
  double angle;  ///< that its crease is to have [rad], valley > 0
};

/// The folds of single layers that carry a fold out.
struct FoldPlan {
  std::vector<LayerFold> layers;  ///< one for each panel that is cut, in the order of the panels
  Viewpoint after;                ///< the same view, at a layer that stays
};

/// Returns how a fold is carried out. Nothing is changed. Throws std::invalid_argument with one
/// sentence that says why the paper cannot be folded so: a landmark off the paper or on the fold, a
/// chosen layer that is joined beyond the fold to one that should stay, a layer that is bent along
/// the fold or stands on edge, a crease that would pass 180 degrees, a layer that stays over one
/// that moves.
FoldPlan planFold(const FoldThrough& fold, const Viewpoint& view, const Simulation& simulation);

/// The edits of the layers, which begin together.
std::vector<FoldEdit> foldEdits(const FoldPlan& plan, const FoldThrough& fold);

}  // namespace shell_origami
