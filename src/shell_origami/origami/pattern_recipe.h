/// \file
/// The recipe of a crease pattern that is folded without one.
#pragma once

#include <shell_origami/origami/recipe.h>

#include <string>

namespace shell_origami {

/// Returns the recipe that folds every crease of a pattern to the angle that the pattern asks for,
/// or where the file is a folding sequence, step by step to the angles of each of its frames.
/// \param width  of the flat pattern [m]; 0: by the unit that the file states
/// \throws std::invalid_argument naming the file where its width or its steps cannot be read
RecipeText patternRecipe(const std::string& path, double width);

}  // namespace shell_origami
