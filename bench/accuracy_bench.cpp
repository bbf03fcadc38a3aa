/// \file
/// Accuracy: the dog's crease angles compared with those of a run with a tenth of the time step and
/// a thousandth of the tolerance.
#include "bench/scenes.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {
namespace {

constexpr int kFiner = 10;           // steps of the reference in one of the other
constexpr double kTolerance = 1e-7;  // of the reference [m/s]
constexpr int kSampled = 6;          // every so many steps, a tenth of a second

/// Returns the largest difference of a crease's angle.
struct Difference {
  double degrees = 0;
  std::string crease;

  void compare(const Simulation& a, const Simulation& b) {
    const std::vector<CreaseStatus> of_a = a.creases(), of_b = b.creases();
    if (of_a.size() != of_b.size()) throw std::runtime_error("the runs differ in their creases");
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      const double difference = std::abs(of_a[i].angle - of_b[i].angle) * 180 / M_PI;
      if (difference <= degrees) continue;
      degrees = difference;
      crease = of_a[i].name + "#" + std::to_string(of_a[i].id);
    }
  }
};

/// Returns the dog with folds that end between two steps. Rounding would decide whether a fold that
/// ends at a step is over there, and the next would start one step earlier or later.
Recipe dogBetweenSteps(double triangles) {
  Recipe recipe = dog(triangles);
  for (RecipeStep& step : recipe.steps) {
    if (auto* folds = std::get_if<FoldStep>(&step)) {
      folds->duration -= recipe.config.solver.time_step / 2;
    }
  }
  return recipe;
}

void step(Simulation& simulation) {
  const StepReport report = simulation.step();
  if (!report.converged) throw std::runtime_error(report.failure);
}

/// Both are edited at the same times, and compared at the same times.
void accuracy(benchmark::State& state) {
  const Recipe recipe = dogBetweenSteps(static_cast<double>(state.range(0)));
  SimulationConfig exact = recipe.config;
  exact.solver.time_step /= kFiner;
  exact.solver.tolerance = kTolerance;
  for (auto _ : state) {
    Simulation simulation = makeSimulation(recipe.sheet, recipe.config);
    Simulation reference = makeSimulation(recipe.sheet, exact);
    RecipeRunner runner(recipe), reference_runner(recipe);
    Difference on_the_way, at_the_end;
    while (runner.update(simulation)) {
      reference_runner.update(reference);
      step(simulation);
      for (int i = 0; i < kFiner; ++i) step(reference);
      if (simulation.counters().steps % kSampled == 0) on_the_way.compare(simulation, reference);
    }
    at_the_end.compare(simulation, reference);
    state.counters["end_deg"] = at_the_end.degrees;
    state.counters["way_deg"] = on_the_way.degrees;
    state.SetLabel("end " + at_the_end.crease + ", way " + on_the_way.crease);
  }
}
BENCHMARK(accuracy)->Arg(300)->Arg(2000)->Arg(10000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace shell_origami
