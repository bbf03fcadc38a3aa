/// \file
/// Rest angles, rest strains and stiffness of a shell.
#pragma once

#include <shell_origami/energy/dihedral.h>
#include <shell_origami/energy/membrane.h>

#include <cmath>
#include <vector>

namespace shell_origami {

/// Rest angles asked for beyond this, to either side, are set to it [rad].
constexpr double kLargestRestAngle = 179 * M_PI / 180;

/// Made by a Shell (Shell::restState()), whose setters keep the rest angles within
/// kLargestRestAngle.
struct RestState {
  std::vector<FoldAngle> angles;  ///< one for each hinge
  std::vector<double> stiffness;  ///< one for each hinge [J]
  /// One for each triangle: the part of the material's membrane stiffness that it has.
  std::vector<double> membrane;
  std::vector<MembraneStrain> strains;  ///< one for each triangle: in which its membrane rests
};

}  // namespace shell_origami
