/// \file
/// Recipes as text: what readRecipe() reads, written as people write it.
#pragma once

#include <shell_origami/origami/journal.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Returns the text of a recipe. What is as by default is left out. Numbers are exact: read again,
/// they are the same but for the last bit of an angle, and times are of the same number of steps.
std::string recipeText(const PaperOrigin& origin, const std::vector<WrittenStep>& steps);

}  // namespace shell_origami
