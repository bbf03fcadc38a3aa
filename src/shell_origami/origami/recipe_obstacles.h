/// \file
/// Obstacles in a recipe's file.
#pragma once

#include <shell_origami/origami/edit.h>
#include <shell_origami/origami/recipe_reader.h>
#include <shell_origami/origami/yaml_text.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Reads a list of obstacles, or one. Paths of meshes are relative to the folder.
std::vector<AddObstacleEdit> readObstacles(const RecipeReader& reader, const YAML::Node& node,
                                           const std::string& folder);
/// Reads `position` and `rpy_deg` or `orientation` (x, y, z, w); what is not stated is zero.
Pose readPose(const RecipeReader& reader, const YAML::Node& node, const std::string& what);

// As these are read, to the bit.
std::string obstacleText(const AddObstacleEdit& edit);
void addPose(const Pose& pose, YamlMap& entries);

}  // namespace shell_origami
