/// \file
/// The inside and the outside reverse fold.
#pragma once

#include <shell_origami/origami/fold_phase.h>
#include <shell_origami/origami/fold_plane.h>

namespace shell_origami {

/// Turns a tip of two halves inside out along a line, so that it comes to lie between its halves
/// (inside) or around them.
struct ReverseFold {
  Landmark flap;  ///< its tip, at which its halves are joined
  FoldAxiom axiom;
  bool inside = true;
};

/// \throws std::invalid_argument with one sentence that says why the paper cannot be folded so
ManoeuvrePlan planReverseFold(const ReverseFold& reverse, const ManoeuvreManner& manner,
                              const Viewpoint& view, const Simulation& simulation);

}  // namespace shell_origami
