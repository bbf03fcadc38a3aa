/// \file
/// A scene folded from beginning to end, and its cost.
#pragma once

#include <shell_origami/origami/recipe.h>
#include "bench/allocations.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace shell_origami {

double median(std::vector<double> values);

/// Returns the peak of resident memory since the last Run was constructed [MB].
double peakMemory();

class Run {
 public:
  explicit Run(Recipe recipe);

  /// Takes one time step after the edits due before it. Returns false once the recipe is done.
  /// Throws std::runtime_error if the step does not converge.
  bool step();

  const Simulation& simulation() const { return simulation_; }
  double medianStep() const { return median(step_times_); }  ///< wall time [s]
  double meanStep() const;                                   ///< wall time [s]
  double longestStep() const;                                ///< wall time [s]
  double lastStep() const { return step_times_.back(); }     ///< wall time [s]

  /// Writes the cost of the run so far into the benchmark's counters.
  void report(benchmark::State& state) const;

 private:
  RecipeRunner runner_;
  Simulation simulation_;
  std::vector<double> step_times_;                         ///< wall time of each [s]
  std::vector<double> allocations_, cholmod_allocations_;  ///< in each step
  double edit_time_ = 0;                                   ///< wall time of all [s]
  std::size_t edits_ = 0;
};

}  // namespace shell_origami
