/// \file
/// Crease patterns, folded to their own angles and compared with the exact state of rigid panels.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <optional>
#include <string>

namespace shell_origami {

constexpr double kPatternWidth = 0.15;  ///< [m]

/// Returns where rigid panels are at the angles that the pattern asks for; nothing where they do
/// not close.
std::optional<Positions> rigidState(const Sheet& sheet);

/// What became of a pattern all of whose creases folded at once, 180 degrees taken as 178.
struct PatternOutcome {
  std::size_t triangles = 0;
  double cpu = 0;                ///< seconds of processor time for one of simulation
  double strain = 0;             ///< largest
  double worst = 0, median = 0;  ///< error of a crease's mean angle [rad]
  /// From the exact state, root mean square over the vertices after a rigid fit [widths]; NaN:
  /// there is none.
  double distance = 0;
  std::string said;  ///< what the library says is amiss; empty: nothing

  /// Whether it is off by more than 2 % of the width, or a crease by more than 5 degrees.
  bool isOff() const;
};

/// Folds a pattern of a file. `compliance` is the parameter compliance/factor.
/// \throws std::invalid_argument when the pattern cannot be read or asks for no fold
PatternOutcome foldPattern(const std::string& path, double compliance);

}  // namespace shell_origami
