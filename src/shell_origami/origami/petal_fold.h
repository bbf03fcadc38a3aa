/// \file
/// The petal fold.
#pragma once

#include <shell_origami/origami/fold_phase.h>

namespace shell_origami {

/// Lifts a flap by its tip: its two edges come together on its middle, and it stretches beyond the
/// new crease that it hangs from.
struct PetalFold {
  Landmark flap;  ///< its tip, on the edge of the paper
};

/// \throws std::invalid_argument with one sentence that says why the paper cannot be folded so
ManoeuvrePlan planPetalFold(const PetalFold& petal, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation);

}  // namespace shell_origami
