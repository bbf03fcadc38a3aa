/// \file
/// Random folds on folded paper, as people tell them.
#pragma once

#include <shell_origami/origami/fold_through.h>
#include "test/sheet/random_sheets.h"

namespace shell_origami {

/// A fold by any axiom, of all layers, the top ones or a flap, to either side, most often shut.
FoldThrough randomFoldThrough(RandomSheets& random, const Sheet& sheet);

}  // namespace shell_origami
