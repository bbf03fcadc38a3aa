/// \file
/// Cost of a step in whole scenes, and the dog's first fold compared with the cost of its linear
/// algebra alone.
#include "bench/limit.h"
#include "bench/run.h"
#include "bench/scenes.h"

#include <benchmark/benchmark.h>

#include <utility>

namespace shell_origami {
namespace {

void fold(benchmark::State& state, Recipe recipe) {
  for (auto _ : state) {
    Run run(recipe);
    while (run.step()) {
    }
    run.report(state);
  }
}

/// The limit is measured halfway: for the present matrix, in the same process and at the same time.
void foldBack(benchmark::State& state) {
  for (auto _ : state) {
    Run run(firstFold(static_cast<double>(state.range(0))));
    while (run.simulation().time() < 0.5) run.step();
    const double peak_memory = peakMemory();
    const Limit limit = measureLimit(run.simulation());
    while (run.step()) {
    }
    run.report(state);
    state.counters["peak_memory_MB"] = peak_memory;  // of the run alone
    state.SetLabel(limit.setting);
    state.counters["limit_numeric_ms"] = 1e3 * limit.best.numeric;
    state.counters["limit_solve_ms"] = 1e3 * limit.best.solve;
    state.counters["own_numeric_ms"] = 1e3 * limit.own.numeric;
    state.counters["own_solve_ms"] = 1e3 * limit.own.solve;
    state.counters["factorization_allocations"] = limit.allocations;
    state.counters["factorization_GFlop"] = 1e-9 * limit.flops;
    state.counters["step_over_limit"] = run.medianStep() / (limit.best.numeric + limit.best.solve);
  }
}

void foldDog(benchmark::State& state) { fold(state, dog(static_cast<double>(state.range(0)))); }

Recipe inTwoThreads(Recipe recipe) {
  recipe.config.solver.threads = 2;
  return recipe;
}
void foldDogInTwoThreads(benchmark::State& state) {
  fold(state, inTwoThreads(dog(static_cast<double>(state.range(0)))));
}
void foldBackInTwoThreads(benchmark::State& state) {
  fold(state, inTwoThreads(firstFold(static_cast<double>(state.range(0)))));
}
void hang(benchmark::State& state) { fold(state, cantilever(static_cast<double>(state.range(0)))); }
void swingFree(benchmark::State& state) { fold(state, swing(static_cast<double>(state.range(0)))); }
void foldMiura(benchmark::State& state) { fold(state, recipeNamed("miura_1000")); }
void unroll(benchmark::State& state) { fold(state, recipeNamed("scroll")); }

void once(benchmark::internal::Benchmark* benchmark) {
  benchmark->Iterations(1)->Unit(benchmark::kMillisecond);
}

// By name, because Debian 11 does not have Benchmark::Name().
[[maybe_unused]] const benchmark::internal::Benchmark* const registered[] = {
    benchmark::RegisterBenchmark("first_fold", foldBack)
        ->Arg(300)
        ->Arg(2000)
        ->Arg(10000)
        ->Arg(50000)
        ->Apply(once),
    benchmark::RegisterBenchmark("first_fold_two_threads", foldBackInTwoThreads)
        ->Arg(2000)
        ->Arg(10000)
        ->Arg(50000)
        ->Apply(once),
    benchmark::RegisterBenchmark("dog", foldDog)->Arg(300)->Arg(2000)->Arg(10000)->Apply(once),
    benchmark::RegisterBenchmark("dog_two_threads", foldDogInTwoThreads)
        ->Arg(2000)
        ->Arg(10000)
        ->Apply(once),
    benchmark::RegisterBenchmark("cantilever", hang)->Arg(2000)->Apply(once),
    benchmark::RegisterBenchmark("swing", swingFree)->Arg(2000)->Apply(once),
    benchmark::RegisterBenchmark("scroll", unroll)->Apply(once),
    benchmark::RegisterBenchmark("miura_1000", foldMiura)->Apply(once)};

}  // namespace
}  // namespace shell_origami
