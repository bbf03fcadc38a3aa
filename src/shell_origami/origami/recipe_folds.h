/// \file
/// Landmarks and folds through layers in a recipe's file.
#pragma once

#include <shell_origami/origami/fold_through.h>
#include <shell_origami/origami/recipe_reader.h>

namespace shell_origami {

// Each throws std::invalid_argument with one sentence naming file, line and offending value.

/// Reads `names`. A landmark may use the names before it.
LandmarkNames readNames(const RecipeReader& reader, const YAML::Node& node);
/// Reads the entry of a step `fold_through`.
FoldThrough readFoldThrough(const RecipeReader& reader, const YAML::Node& node,
                            const LandmarkNames& names);

}  // namespace shell_origami
