#include <shell_origami/base/files.h>

#include <cstdlib>

namespace shell_origami {

std::string expandedPath(const std::string& path) {
  const bool is_home = path == "~" || path.rfind("~/", 0) == 0;
  const char* home = is_home ? std::getenv("HOME") : nullptr;
  return home ? home + path.substr(1) : path;
}

}  // namespace shell_origami
