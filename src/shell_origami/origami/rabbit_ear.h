/// \file
/// A rabbit ear: two edges of a triangular flap come to lie on its base at once, and what is left
/// at the tip between them lies down to one side.
#pragma once

#include <shell_origami/origami/fold_phase.h>

#include <array>

namespace shell_origami {

struct RabbitEar {
  Landmark flap;                 ///< its tip, a corner of the paper
  std::array<Landmark, 2> base;  ///< its other two corners; the tip comes to point to the second
  bool behind = false;           ///< the way: away from the viewer instead of towards
};

/// \throws std::invalid_argument with one sentence that says why the paper cannot be folded so
ManoeuvrePlan planRabbitEar(const RabbitEar& ear, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation);

}  // namespace shell_origami
