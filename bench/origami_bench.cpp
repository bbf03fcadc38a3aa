/// \file
/// Benchmarks; scripts/bench makes a table of what they count.
#include <benchmark/benchmark.h>

BENCHMARK_MAIN();
