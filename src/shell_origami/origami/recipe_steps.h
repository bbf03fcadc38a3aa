/// \file
/// The steps of a recipe's file.
#pragma once

#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/recipe_folds.h>
#include <shell_origami/origami/recipe_reader.h>

namespace shell_origami {

/// Reads one entry of `steps`. A fold that states no duration takes `fold_duration` [s]. Paths are
/// relative to `folder`.
/// \param lasts  set where the entry states it [s]
/// \throws std::invalid_argument with one sentence naming file, line and offending value.
RecipeStep readStep(const RecipeReader& reader, const YAML::Node& node, double fold_duration,
                    const LandmarkNames& names, const std::string& folder,
                    std::optional<double>& lasts);

}  // namespace shell_origami
