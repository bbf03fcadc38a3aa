/// \file
/// A lower bound on the cost of an implicit step: one factorization of its matrix and one solve.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <string>

namespace shell_origami {

struct FactorTimes {
  double numeric = 0;  ///< factorization [s]
  double solve = 0;    ///< with the factor [s]
};

struct Limit {
  FactorTimes best;        ///< CHOLMOD called directly, by the best of several settings
  std::string setting;     ///< which one that was
  FactorTimes own;         ///< by Cholesky, as the solver calls it
  double flops = 0;        ///< of a factorization in the solver's order
  double allocations = 0;  ///< from the heap, in a factorization and a solve by Cholesky
};

/// Measures the matrix of a Newmark step with the default beta at the present positions; medians.
Limit measureLimit(const Simulation& simulation);

}  // namespace shell_origami
