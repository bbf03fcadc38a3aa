/// \file
/// Paths of files.
#pragma once

#include <string>

namespace shell_origami {

/// Returns the path with a leading `~` or `~/` replaced by the home folder ($HOME).
std::string expandedPath(const std::string& path);

}  // namespace shell_origami
