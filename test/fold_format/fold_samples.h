/// \file
/// Small FOLD files for tests.
#pragma once

#include <shell_origami/fold_format/fold_file.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>

namespace shell_origami {

using nlohmann::json;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A file of test/data/patterns.
inline std::string dataPath(const std::string& name) {
  const auto folder = std::filesystem::path(__FILE__).parent_path().parent_path() / "data";
  return (folder / "patterns" / name).string();
}

inline std::string patternPath(const std::string& name) { return dataPath(name + ".fold"); }

/// Files of their own for this program, one of each extension, gone with it.
class ScratchFiles {
 public:
  ~ScratchFiles() {
    for (const std::string& path : paths_) std::filesystem::remove(path);
  }
  std::string write(const std::string& text, const std::string& extension) {
    const std::string path = testing::TempDir() + "fold_samples." + std::to_string(getpid());
    paths_.insert(path + extension);
    std::ofstream(path + extension, std::ios::binary) << text;
    return path + extension;
  }

 private:
  std::set<std::string> paths_;
};

/// Writes a file and returns its path.
inline std::string scratch(const std::string& text, const std::string& extension = ".fold") {
  static ScratchFiles files;
  return files.write(text, extension);
}

inline FoldPaper read(const json& document, double scale = 1, double max_edge = 0) {
  return readFold(scratch(document.dump()), {scale, max_edge});
}

/// The sentence a file is refused with; empty when it is read.
inline std::string fileRefusal(const std::string& path, const FoldReadOptions& options = {1, 0}) {
  try {
    readPatternFile(path, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

inline std::string refusal(const json& document) { return fileRefusal(scratch(document.dump())); }

inline void expectWithin(const std::string& sentence, const std::string& part) {
  EXPECT_NE(sentence.find(part), std::string::npos)
      << "'" << sentence << "' lacks '" << part << "'";
}

/// A unit square with a valley from corner 0 to corner 2.
inline json diagonal() {
  return {{"vertices_coords", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
          {"edges_vertices", {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}},
          {"edges_assignment", {"B", "B", "B", "B", "V"}},
          {"faces_vertices", {{0, 1, 2}, {0, 2, 3}}}};
}

/// A square of 2 x 2 units with its middle as vertex 8, border 0 .. 7, and four creases.
inline json cross() {
  return {
      {"vertices_coords", {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {1, 1}}},
      {"edges_vertices",
       {{0, 1},
        {1, 2},
        {2, 3},
        {3, 4},
        {4, 5},
        {5, 6},
        {6, 7},
        {7, 0},
        {1, 8},
        {8, 5},
        {8, 3},
        {7, 8}}},
      {"edges_assignment", {"B", "B", "B", "B", "B", "B", "B", "B", "M", "M", "M", "V"}}};
}

inline double area(const FoldPaper& paper) { return paper.sheet.area(); }

/// What the file asks of each crease [rad].
inline std::vector<double> patternAngles(const FoldPaper& paper) {
  std::vector<double> angles;
  for (const Crease& crease : paper.sheet.creases()) angles.push_back(crease.pattern_angle);
  return angles;
}

}  // namespace shell_origami
