/// \file
/// A lower bound on the cost of a step of paper that touches.
#pragma once

#include <shell_origami/origami/simulation.h>

namespace shell_origami {

/// Times of what such a step cannot do without [s].
struct ContactLimit {
  double numeric = 0;     ///< a factorization of the matrix of shell and contact
  double solve = 0;       ///< with that factor
  double candidates = 0;  ///< the distance of every candidate, once

  double total() const { return numeric + solve + candidates; }
};

/// Measures the step's matrix at the present positions; medians. \pre contact is on
ContactLimit measureContactLimit(const Simulation& simulation);

}  // namespace shell_origami
