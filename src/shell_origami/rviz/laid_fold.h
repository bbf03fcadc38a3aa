/// \file
/// The fold that a person has laid over the paper with the mouse.
#pragma once

#include <shell_origami/rviz/snapping.h>

#include <cmath>
#include <optional>
#include <variant>

namespace shell_origami {

/// Which layers a fold takes.
enum class FoldReach {
  kAll,      ///< every layer on the side that moves
  kTop,      ///< the one nearest to the viewer
  kFlap,     ///< the flap of the point that moves
  kSegment,  ///< the layer that the line was drawn on, from the one point to the other
};

/// A fold that is laid on the paper but not folded yet.
struct LaidFold {
  bool bring = false;             ///< whether the first point comes onto the second, or the fold
                                  ///< goes through both
  Spot first, second;             ///< different places
  std::optional<Vector2> moving;  ///< flat, on the side that moves [m]; none: the smaller side
  FoldReach reach = FoldReach::kAll;
  double angle = 0;  ///< [rad] inside (-pi, pi); positive: what moves comes towards the viewer
};

/// Folds a crease that is there.
struct TurnCrease {
  int crease;    ///< an index into Sheet::creases()
  double angle;  ///< [rad] inside (-pi, pi), valley > 0
};

/// Holds a vertex, or lets go of it where it is held.
struct TogglePin {
  int vertex;
};

/// Offers what else can be done at a place.
struct OpenMenu {
  Spot spot;
};

using MouseRequest = std::variant<LaidFold, TurnCrease, TogglePin, OpenMenu>;

}  // namespace shell_origami
