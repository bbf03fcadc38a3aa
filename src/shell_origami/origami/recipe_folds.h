/// \file
/// Folds through layers and manoeuvres in a recipe's file.
#pragma once

#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/recipe_landmarks.h>

namespace shell_origami {

// Each throws std::invalid_argument with one sentence naming file, line and offending value.

/// Reads the name of a new crease.
std::string readCreaseName(const RecipeReader& reader, const YAML::Node& node);
/// Reads the entry of a step `fold_through`.
FoldThrough readFoldThrough(const RecipeReader& reader, const YAML::Node& node,
                            const LandmarkNames& names);
// Each reads the entry of the step of that name.
ManoeuvreStep readPetal(const RecipeReader& reader, const YAML::Node& node,
                        const LandmarkNames& names);
ManoeuvreStep readPleat(const RecipeReader& reader, const YAML::Node& node,
                        const LandmarkNames& names);
ManoeuvreStep readRabbitEar(const RecipeReader& reader, const YAML::Node& node,
                            const LandmarkNames& names);
ManoeuvreStep readSquash(const RecipeReader& reader, const YAML::Node& node,
                         const LandmarkNames& names);
ManoeuvreStep readReverse(const RecipeReader& reader, const YAML::Node& node,
                          const LandmarkNames& names);
LoosenStep readLoosen(const RecipeReader& reader, const YAML::Node& node,
                      const LandmarkNames& names);

}  // namespace shell_origami
