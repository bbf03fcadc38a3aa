/// \file
/// Folded sheets whose layers lie close to each other.
#pragma once

#include <shell_origami/sheet/sheet.h>
#include "test/contact/reference.h"

namespace shell_origami {

/// Of pairs in these tests, d^ [m].
constexpr double kReach = 5e-5;

/// The sheet in pleats of width `pitch` across x, one `gap` above the other [m]: layers are flat,
/// and faces across a fold reach from one to the next. It crosses nowhere, and still does not when
/// vertices are moved up or down by a tenth of the gap.
Positions pleated(const Sheet& sheet, double pitch, double gap);

/// Moved along z at random, by up to `amount` [m].
Positions shaken(const Positions& x, double amount, Random& random);

/// Turned at random and moved.
Positions turned(const Positions& x, Random& random);

/// Folded along up to `folds` random lines one after the other, each by any angle. It may cross
/// itself.
Positions folded(const Sheet& sheet, int folds, Random& random);

}  // namespace shell_origami
