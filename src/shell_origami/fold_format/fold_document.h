/// \file
/// The words of a FOLD file, checked one by one but not yet understood.
#pragma once

#include <shell_origami/base/geometry.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

/// A crease as our own files note it, under `shell_origami:creases`.
struct NotedCrease {
  std::uint32_t id = 0;
  std::string name;
  std::vector<int> vertices;
  double rest_angle = 0;     ///< [rad]; NaN: a free crease
  double pattern_angle = 0;  ///< what is asked of it [rad]; NaN: nothing
};

/// The word under which our own frames of a sequence state where their vertices are on the flat
/// sheet.
constexpr const char* kFlatCoordinates = "vertices_shell_origami:flat_coords";

/// A FOLD file. Frame 0 is the key frame, frame i > 0 is file_frames[i - 1]; a frame that says
/// frame_inherit sees its parent's words (the key frame's where it names no parent).
/// Everything throws std::invalid_argument with a sentence that names the place in the file.
class FoldDocument {
 public:
  explicit FoldDocument(const std::string& path);
  FoldDocument(const FoldDocument&) = delete;
  FoldDocument& operator=(const FoldDocument&) = delete;

  int frameCount() const { return static_cast<int>(frames_.size()); }
  bool has(int frame, const char* key) const { return find(frame, key) != nullptr; }
  /// Whether the frame itself has the key, not only an ancestor.
  bool hasOwn(int frame, const char* key) const { return frames_[frame]->contains(key); }
  bool hasClass(int frame, const char* name) const;
  /// Whether the file as a whole is of a class.
  bool isOfClass(const char* name) const;
  /// Whether a frame is another or names it as its parent, directly or by way of others.
  bool descendsFrom(int frame, int ancestor) const;
  /// Whether two frames have the same edges and faces, as far as both have any.
  bool sharesMesh(int frame, int other) const;
  std::string unit(int frame) const;  ///< frame_unit; "unit" where there is none
  static std::string frameName(int frame);

  /// vertices_coords in units of the file; z is 0 where it is not given.
  std::vector<Vector3> points(int frame) const;
  /// kFlatCoordinates, in the same form; empty where the frame has none.
  std::vector<Vector3> flatCoordinates(int frame) const;
  std::vector<std::array<int, 2>> edges(int frame, int vertex_count) const;
  /// One letter of BMVFUCJ each; empty where the file has none.
  std::string assignments(int frame, std::size_t edge_count) const;
  /// [rad], NaN for null; empty where the file has none.
  std::vector<double> foldAngles(int frame, std::size_t edge_count) const;
  std::vector<std::vector<int>> faces(int frame, int vertex_count) const;
  /// Two faces and -1, 0 or 1 each.
  std::vector<std::array<int, 3>> faceOrders(int frame, std::size_t face_count) const;
  std::vector<NotedCrease> notedCreases(int frame, int vertex_count) const;

 private:
  const nlohmann::json* find(int frame, const char* key) const;
  const nlohmann::json* findArray(int frame, const char* key) const;
  std::vector<Vector3> coordinates(int frame, const char* key) const;

  nlohmann::json root_;
  std::vector<const nlohmann::json*> frames_;
  std::vector<int> parents_;  ///< -1: inherits nothing
};

}  // namespace shell_origami
