/// \file
/// Where the hinges of a shell rest.
#pragma once

#include <shell_origami/energy/dihedral.h>

#include <vector>

namespace shell_origami {

/// One entry for each hinge of a Shell, which makes it (Shell::restState()) and whose setters keep
/// the rest angles short of 180 degrees.
struct RestState {
  std::vector<FoldAngle> angles;
  std::vector<double> stiffness;  ///< [J]
};

}  // namespace shell_origami
