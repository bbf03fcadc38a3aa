/// \file
/// Values as YAML reads them back, to the bit.
#pragma once

#include <shell_origami/base/geometry.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Returns a list of numbers: "[0.1, 0.2]".
std::string numbers(const Vector2& p);
std::string numbers(const Vector3& v);
/// Returns a list of points: "[[0, 0], [0.1, 0.2]]".
std::string points(const std::vector<Vector2>& places);
/// Returns a word, in quotes where it needs them.
std::string word(const std::string& text);
/// Returns the shortest number of degrees that is read as an angle [rad], or the nearest to it.
std::string degrees(double angle);

/// Returns a list of values, each of which `text` writes.
template <class Values, class Text>
std::string list(const Values& values, Text text) {
  std::string all;
  for (const auto& value : values) all += (all.empty() ? "" : ", ") + text(value);
  return "[" + all + "]";
}

/// The entries of a map in braces.
class YamlMap {
 public:
  YamlMap& add(const std::string& key, const std::string& value) {
    text_ += (text_.empty() ? "" : ", ") + key + ": " + value;
    return *this;
  }
  bool empty() const { return text_.empty(); }
  std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

}  // namespace shell_origami
