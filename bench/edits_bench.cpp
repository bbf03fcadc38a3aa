/// \file
/// Cost of an edit, of the flat sheet and of folded paper.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>
#include "bench/scenes.h"

#include <benchmark/benchmark.h>

#include <random>

namespace shell_origami {
namespace {

/// One edge-making edit of a flat sheet: a line between random points.
void edit(benchmark::State& state) {
  const SheetSource source = square(static_cast<double>(state.range(0)));
  const Sheet sheet(triangulateRectangle(source.width, source.height, source.max_edge));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> along(0, source.width);
  for (auto _ : state) {
    state.PauseTiming();
    Sheet copy = sheet;
    const Segment line{Vector2(along(random), along(random)),
                       Vector2(along(random), along(random))};
    state.ResumeTiming();
    makeFoldLine(copy, line);
  }
  state.counters["triangles"] = static_cast<double>(sheet.triangles().size());
}
BENCHMARK(edit)->Arg(300)->Arg(2000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// An edit of folded paper in a simulation, whose state follows the remap.
void editInSimulation(benchmark::State& state) {
  const Recipe recipe = firstFold(static_cast<double>(state.range(0)));
  Simulation folded = makeSimulation(recipe.sheet, recipe.config);
  RecipeRunner runner(recipe);
  while (folded.time() < 0.5 && runner.update(folded)) folded.step();
  FoldEdit second;
  second.where = Segment{Vector2(0.01, 0.14), Vector2(0.14, 0.03)};
  second.angle = 1;
  for (auto _ : state) {
    state.PauseTiming();
    Simulation copy(folded.sheet(), {}, folded.positions(), {1.0});
    state.ResumeTiming();
    copy.fold(second);
  }
  state.counters["triangles"] = static_cast<double>(folded.sheet().triangles().size());
}
[[maybe_unused]] const benchmark::internal::Benchmark* const registered =
    benchmark::RegisterBenchmark("edit_in_simulation", editInSimulation)
        ->Arg(300)
        ->Arg(2000)
        ->Arg(10000)
        ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace shell_origami
