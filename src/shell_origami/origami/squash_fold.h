/// \file
/// The squash fold.
#pragma once

#include <shell_origami/origami/fold_phase.h>

#include <array>

namespace shell_origami {

/// Opens a flap of two layers and lays it flat, so that the fold that joined them comes onto a
/// line.
struct SquashFold {
  Landmark flap;                 ///< on one of its layers: the one that opens, where either could
  Landmark bring;                ///< on the fold that joins them
  std::array<Landmark, 2> onto;  ///< two points of the line
};

/// \throws std::invalid_argument with one sentence that says why the paper cannot be folded so
ManoeuvrePlan planSquashFold(const SquashFold& squash, const ManoeuvreManner& manner,
                             const Viewpoint& view, const Simulation& simulation);

}  // namespace shell_origami
