/// \file
/// Sheets that come to rest under their own weight.
#pragma once

#include <shell_origami/origami/simulation.h>

namespace shell_origami {

/// Returns strip() under the gravity of gamma = rho t g L^3 / B for a length L [m]. Air damps it as
/// it critically damps a cantilever of length `swinging` [m], and steps are solved to 1e-5 L in a
/// period of that cantilever.
SimulationConfig hangingConfig(double gamma, double length, double swinging);

/// Steps until no vertex is faster than the tolerance to which the steps are solved. Throws
/// std::runtime_error if a step does not converge, or after 1000 steps.
void comeToRest(Simulation& simulation);

}  // namespace shell_origami
