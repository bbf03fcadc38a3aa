/// \file
/// YAML from anywhere: however deep text nests, reading it takes a bounded stack.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace shell_origami {

/// \throws YAML::Exception where the text is no YAML, or nests deeper than any recipe has to.
YAML::Node loadBoundedYaml(const std::string& text);

}  // namespace shell_origami
