/// \file
/// The lines of a recipe, before it is folded.
#pragma once

#include <shell_origami/origami/recipe.h>

#include <vector>

namespace shell_origami {

/// Returns folds that draw every line of a recipe's folds on the flat sheet, as creases that stay
/// flat: where these lines are is found on paper that is folded in thought, step by step, rigidly
/// and without thickness.
/// \throws std::invalid_argument with one sentence naming the step where that does not tell the
/// lines: it counts layers from the top, or names creases that panels do not close at
std::vector<FoldEdit> precreasesOf(const Recipe& recipe);

}  // namespace shell_origami
