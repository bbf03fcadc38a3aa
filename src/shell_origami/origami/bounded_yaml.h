/// \file
/// YAML from unknown sources, within bounds.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <string>

namespace shell_origami {

/// Aliases of aliases make short text long: a list of a thousand times a list of a thousand folds.
/// Who reads a document counts the values once more, aliases followed.
constexpr std::size_t kMostYamlValues = 1000000;

/// Returns the first document of a text.
/// Throws YAML::Exception, with the line, if the text is not YAML, nests deeper than 32 levels,
/// holds more than a million values, or has a map in which a key occurs twice.
YAML::Node loadBoundedYaml(const std::string& text);

}  // namespace shell_origami
