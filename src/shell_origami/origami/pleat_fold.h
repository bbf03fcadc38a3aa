/// \file
/// A pleat: layers are folded along one line, and back along another one beyond it.
#pragma once

#include <shell_origami/origami/fold_phase.h>
#include <shell_origami/origami/fold_through.h>

#include <array>

namespace shell_origami {

struct PleatFold {
  FoldThrough fold;              ///< the first one; its angle, duration and name are not used
  std::array<Landmark, 2> back;  ///< two points of the line along which it is folded back
};

/// Plans a pleat. Both folds run together; the paper beyond both lines ends parallel to where it
/// was. \throws std::invalid_argument with one sentence that says why the paper cannot be
/// folded so
ManoeuvrePlan planPleatFold(const PleatFold& pleat, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation);

}  // namespace shell_origami
