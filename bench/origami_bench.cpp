/// \file
/// Benchmarks of named scenes. Times are medians over repetitions; counters are per step.
#include "origami/simulation.h"
#include "sheet/triangulate.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace {

using namespace shell_origami;

constexpr double kSide = 0.15;

/// Longest edge [m] for about so many triangles of the square.
double edgeFor(double triangles) { return kSide * std::sqrt(4 / std::sqrt(3.0) / triangles) * 1.1; }

Sheet square(double triangles) {
  return Sheet(triangulateRectangle(kSide, kSide, edgeFor(triangles)));
}

FoldRequest diagonal() {
  FoldRequest request;
  request.where = Line{Vector2(0, 0), Vector2(kSide, kSide)};
  request.angle = -170 * M_PI / 180;
  request.duration = 1.0;
  return request;
}

/// One edge-making edit of a flat sheet: a line between random points.
void edit(benchmark::State& state) {
  const Sheet sheet = square(static_cast<double>(state.range(0)));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> along(0, kSide);
  for (auto _ : state) {
    state.PauseTiming();
    Sheet copy = sheet;
    const Line line{Vector2(along(random), along(random)), Vector2(along(random), along(random))};
    state.ResumeTiming();
    makeFoldLine(copy, line);
  }
  state.counters["triangles"] = static_cast<double>(sheet.triangles().size());
}
BENCHMARK(edit)->Arg(300)->Arg(2000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// An edit on the folded paper of a running simulation, with all that follows from it.
void editInSimulation(benchmark::State& state) {
  Simulation folded(square(static_cast<double>(state.range(0))), {});
  folded.fold(diagonal());
  for (int i = 0; i < 30; ++i) folded.step();
  const Positions positions = folded.positions();
  FoldRequest second;
  second.where = Line{Vector2(0.01, 0.14), Vector2(0.14, 0.03)};
  second.angle = 1;
  for (auto _ : state) {
    state.PauseTiming();
    Simulation copy(folded.sheet(), {}, positions, {1.0});
    state.ResumeTiming();
    copy.fold(second);
  }
  state.counters["triangles"] = static_cast<double>(folded.sheet().triangles().size());
}
BENCHMARK(editInSimulation)->Arg(300)->Arg(2000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// The dog's first fold: a whole diagonal to 170 degrees within a second.
void firstFold(benchmark::State& state) {
  Simulation simulation(square(static_cast<double>(state.range(0))), {});
  simulation.fold(diagonal());
  for (auto _ : state) {
    if (simulation.time() > 1.2) {
      state.PauseTiming();
      simulation = Simulation(square(static_cast<double>(state.range(0))), {});
      simulation.fold(diagonal());
      state.ResumeTiming();
    }
    simulation.step();
  }
  const auto per_step = [&](std::uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(simulation.counters().steps);
  };
  state.counters["triangles"] = static_cast<double>(simulation.sheet().triangles().size());
  state.counters["newton"] = per_step(simulation.counters().newton_iterations);
  state.counters["factorizations"] = per_step(simulation.counters().factorizations);
  state.counters["simulated_s"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * simulation.config().solver.time_step,
      benchmark::Counter::kIsRate);
}
BENCHMARK(firstFold)->Arg(300)->Arg(2000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
