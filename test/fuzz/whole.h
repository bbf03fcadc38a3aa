/// \file
/// What paper is at any time: finite, no triangle collapsed, no hinge past 180 degrees.
#pragma once

#include <shell_origami/origami/simulation.h>

namespace shell_origami {

/// \throws std::logic_error naming what the paper has lost.
void checkWhole(const Simulation& simulation);

/// \throws std::logic_error where paper passes through itself. Looks at every fifth step.
void checkApart(const Simulation& simulation);

}  // namespace shell_origami
