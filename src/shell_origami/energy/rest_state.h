/// \file
/// Rest angles and stiffness of the hinges of a shell.
#pragma once

#include <shell_origami/energy/dihedral.h>

#include <cmath>
#include <vector>

namespace shell_origami {

/// Rest angles asked for beyond this, to either side, are set to it [rad].
constexpr double kLargestRestAngle = 179 * M_PI / 180;

/// One entry for each hinge of a Shell, which makes it (Shell::restState()) and whose setters keep
/// the rest angles within kLargestRestAngle.
struct RestState {
  std::vector<FoldAngle> angles;
  std::vector<double> stiffness;  ///< [J]
};

}  // namespace shell_origami
