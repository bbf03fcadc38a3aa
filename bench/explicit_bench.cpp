/// \file
/// What the implicit scheme is worth: the explicit one on the same paper, at its longest step.
#include "bench/run.h"
#include "bench/scenes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <optional>

namespace shell_origami {
namespace {

/// How much of the fold a step has to hold for, and how close to the longest one to come.
constexpr double kWatched = 0.02;  // [s]
constexpr double kCloseness = 1.05;
/// Paper that is stretched more than this has come apart.
constexpr double kStretched = 0.01;

/// Wall time per simulated time of symplectic Euler over the first fold's beginning; nothing where
/// a step of dt [s] is too long.
std::optional<double> explicitCost(double triangles, double dt) {
  Recipe recipe = firstFold(triangles);
  recipe.config.solver.integrator = IntegratorKind::kSymplecticEuler;
  recipe.config.solver.time_step = dt;
  Run run(recipe);
  while (run.simulation().time() < kWatched) {
    try {
      run.step();
    } catch (const std::runtime_error&) {
      return std::nullopt;
    }
    if (run.simulation().counters().retries > 0) return std::nullopt;
  }
  if (run.simulation().maxStrain() > kStretched) return std::nullopt;
  return run.medianStep() / dt;
}

void explicitScheme(benchmark::State& state) {
  const auto triangles = static_cast<double>(state.range(0));
  for (auto _ : state) {
    Run implicit(firstFold(triangles));
    while (implicit.step()) {}
    const double implicit_cost = implicit.meanStep() / implicit.simulation().config().solver.time_step;

    double unstable = 1e-4, stable = unstable;  // [s]
    std::optional<double> cost;
    while (!(cost = explicitCost(triangles, stable))) {
      unstable = stable;
      stable /= 2;
    }
    while (unstable / stable > kCloseness) {
      const double middle = std::sqrt(unstable * stable);
      const std::optional<double> held = explicitCost(triangles, middle);
      (held ? stable : unstable) = middle;
      if (held) cost = held;
    }
    state.counters["stable_step_us"] = 1e6 * stable;
    state.counters["explicit_s_per_s"] = *cost;
    state.counters["implicit_s_per_s"] = implicit_cost;
    state.counters["explicit_over_implicit"] = *cost / implicit_cost;
  }
}
BENCHMARK(explicitScheme)->Name("explicit")->Arg(2000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace shell_origami
