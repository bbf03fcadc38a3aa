/// \file
/// Landmarks as recipes write them.
#pragma once

#include <shell_origami/origami/landmark.h>
#include <shell_origami/origami/yaml_text.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Landmarks by their names where these stand for the same places.
class LandmarkText {
 public:
  explicit LandmarkText(const LandmarkNames& names) : names_(names) {}

  std::string operator()(const Landmark& landmark) const;
  /// Returns the landmark's place without its own name.
  std::string place(const Landmark& landmark) const;
  template <class Landmarks>
  std::string several(const Landmarks& landmarks) const {
    return list(landmarks, *this);
  }

 private:
  const LandmarkNames& names_;  ///< must live as long
};

/// Returns the lines of names, each after those that it uses.
std::string namesText(const LandmarkNames& names);

}  // namespace shell_origami
