/// \file
/// Values in a recipe's file, read with complaints that say where they are.
#pragma once

#include <shell_origami/base/error.h>
#include <shell_origami/base/geometry.h>
#include <shell_origami/origami/parameter.h>

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

constexpr double kDegree = M_PI / 180;  ///< of the angles in recipes, whose keys end in _deg

/// A recipe's file while it is read: knows where it is, for its complaints. Every function throws
/// std::invalid_argument with one sentence, by refuseAt(), when a value is not what it must be;
/// `what` is the value's name there.
class RecipeReader {
 public:
  explicit RecipeReader(std::string file) : file_(std::move(file)) {}

  template <class... Parts>
  [[noreturn]] void refuseAt(const YAML::Node& node, const Parts&... parts) const {
    const int line = node.Mark().line;
    if (line >= 0) reject(file_, ", line ", line + 1, ": ", parts...);
    reject(file_, ": ", parts...);
  }

  using Handlers = std::map<std::string, std::function<void(const YAML::Node&)>>;
  /// Hands each entry of the map to its handler. Unknown words are refused.
  void readMap(const YAML::Node& node, const std::string& what, const Handlers& handlers) const;

  std::string text(const YAML::Node& node, const std::string& what) const;
  double number(const YAML::Node& node, const std::string& what) const;  ///< finite
  bool truth(const YAML::Node& node, const std::string& what) const;
  std::vector<double> numbers(const YAML::Node& node, std::size_t count,
                              const std::string& what) const;
  std::vector<Vector2> points(const YAML::Node& node, const std::string& what) const;  ///< not none

  // Each reads a value into its place.
  void read(const YAML::Node& node, const std::string& what, double* value) const;
  void read(const YAML::Node& node, const std::string& what, int* value) const;
  void read(const YAML::Node& node, const std::string& what, bool* value) const;
  void read(const YAML::Node& node, const std::string& what, std::string* value) const;
  void read(const YAML::Node& node, const std::string& what, Vector3* value) const;
  void read(const YAML::Node& node, const std::string& what, const Choice& choice) const;
  /// Returns the handler that does so. \pre this outlives it
  std::function<void(const YAML::Node&)> into(const Place& place, const std::string& what) const;

 private:
  void countValue() const;

  std::string file_;
  mutable std::size_t values_ = 0;  ///< read so far
};

}  // namespace shell_origami
