/// \file
/// The start of a step, where paper would pass through paper.
#pragma once

#include <shell_origami/contact/candidates.h>

namespace shell_origami {

/// Moves vertices of `to` back on their ways from `from` until no pair touches on the way. Only
/// those vertices whose pairs would, so that a single contact does not stop the whole sheet.
/// \param gaps at `from`, of each pair a lower bound [m]
/// \pre the pairs cover both configurations
void separate(const std::vector<ContactPair>& pairs, const std::vector<double>& gaps,
              const Positions& from, Positions& to);

}  // namespace shell_origami
