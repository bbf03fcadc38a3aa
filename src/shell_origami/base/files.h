/// \file
/// Files read within bounds and written whole.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

/// Returns the path with a leading `~` or `~/` replaced by the home folder ($HOME).
std::string expandedPath(const std::string& path);

/// Returns the contents of a regular file.
/// Throws std::invalid_argument, without the path, if it cannot be read or is larger than
/// `most_bytes`.
std::string readFile(const std::string& path, std::uintmax_t most_bytes);

/// A text and the path where it belongs.
struct TextFile {
  std::string path;
  std::string text;
};

/// Writes all files or none: each text goes to a file of its own beside its target and to the disk;
/// only then do they take their targets' places (renameTogether). Through a symbolic link, the file
/// that it names is written and the link stays.
/// Throws std::runtime_error naming path and reason; older files are then as they were.
void writeFiles(const std::vector<TextFile>& files);

/// Renames files, from first to second, replacing older files. Where one cannot be renamed, those
/// renamed before it give their places back.
/// Throws std::runtime_error naming path and reason.
void renameTogether(const std::vector<std::pair<std::string, std::string>>& moves);

}  // namespace shell_origami
