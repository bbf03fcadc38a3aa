/// \file
/// The edits with which a step of a recipe begins.
#pragma once

#include <shell_origami/origami/recipe.h>

#include <vector>

namespace shell_origami {

struct StepBeginning {
  std::vector<Edit> edits;  ///< that begin the step
  Viewpoint view;           ///< of the paper from now on
  StepUnderWay under_way;
};

/// \param place  at the step
/// \throws std::invalid_argument with one sentence where the paper cannot be folded so
StepBeginning beginningOf(const RecipeStep& step, const RecipePlace& place,
                          const Simulation& simulation);

/// Returns the folds of a step, of a manoeuvre those of its result.
std::vector<FoldEdit> foldsOf(const StepBeginning& beginning);

/// Returns the folds that bring the creases of these ones back to where they are asked to be now;
/// new ones become flat. \pre the folds of lines come before the lines' pieces
std::vector<FoldEdit> unfoldingOf(const std::vector<FoldEdit>& folds, const Simulation& simulation);

}  // namespace shell_origami
