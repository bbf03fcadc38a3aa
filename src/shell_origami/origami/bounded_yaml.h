/// \file
/// YAML from unknown sources, within bounds.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace shell_origami {

/// Returns the first document of a text.
/// Throws YAML::Exception, with the line, if the text is not YAML, nests deeper than 32 levels,
/// holds more than a million values, or has a map in which a key occurs twice.
YAML::Node loadBoundedYaml(const std::string& text);

}  // namespace shell_origami
