/// \file
/// The explicit scheme on the same paper, at its largest stable step.
#include "bench/run.h"
#include "bench/scenes.h"

#include <benchmark/benchmark.h>

#include <optional>
#include <stdexcept>

namespace shell_origami {
namespace {

/// Simulated time for which a step must be stable.
constexpr double kWatched = 0.02;  // [s]
/// Start of the search for the largest step, too large for any paper, and its ratio. The search
/// goes downwards, because unstable runs are short: they end as soon as the paper comes apart.
constexpr double kLongest = 2e-5;  // [s]
constexpr double kPace = 1.05;
/// Strain from which on the paper has come apart.
constexpr double kStretched = 0.01;

/// Returns wall time over simulated time of symplectic Euler at the start of the first fold;
/// nothing if a step of dt [s] is unstable.
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
    while (implicit.step()) {
    }
    const double implicit_cost =
        implicit.meanStep() / implicit.simulation().config().solver.time_step;

    double dt = kLongest;
    std::optional<double> cost;
    while (!(cost = explicitCost(triangles, dt))) dt /= kPace;
    state.counters["stable_step_us"] = 1e6 * dt;
    state.counters["explicit_s_per_s"] = *cost;
    state.counters["implicit_s_per_s"] = implicit_cost;
    state.counters["explicit_over_implicit"] = *cost / implicit_cost;
  }
}
[[maybe_unused]] const benchmark::internal::Benchmark* const registered =
    benchmark::RegisterBenchmark("explicit", explicitScheme)
        ->Arg(2000)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace shell_origami
