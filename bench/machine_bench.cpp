/// \file
/// The rates of the machine that bound a factorization.
#include <benchmark/benchmark.h>
#include <dlfcn.h>

#include <string>
#include <vector>

extern "C" void dgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n,
                       const int* k, const double* alpha, const double* a, const int* lda,
                       const double* b, const int* ldb, const double* beta, double* c,
                       const int* ldc);

namespace {

/// Returns the kernels that OpenBLAS uses, by itself or because of OPENBLAS_CORETYPE: they
/// determine the speed of a factorization. "unknown" with another BLAS.
std::string blasKernels() {
  const auto name =
      reinterpret_cast<const char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  return name ? name() : "unknown";
}

/// Products of dense matrices by the BLAS that CHOLMOD uses.
void denseProduct(benchmark::State& state) {
  const int n = 512;
  const double one = 1, zero = 0;
  const std::vector<double> a(n * n, 1.5), b(n * n, 0.5);
  std::vector<double> c(n * n);
  for (auto _ : state) {
    dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n);
    benchmark::ClobberMemory();
  }
  state.counters["GFlop_per_s"] =
      benchmark::Counter(2e-9 * n * n * n, benchmark::Counter::kIsIterationInvariantRate);
  state.SetLabel(blasKernels());
}
[[maybe_unused]] const benchmark::internal::Benchmark* const registered =
    benchmark::RegisterBenchmark("dgemm", denseProduct)->Unit(benchmark::kMillisecond);

/// a = b + s c over arrays of 64 MB, larger than a core's share of the caches.
void triad(benchmark::State& state) {
  const std::size_t n = (64u << 20) / sizeof(double);
  std::vector<double> a(n), b(n, 1.0), c(n, 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3 * c[i];
    benchmark::ClobberMemory();
  }
  state.counters["GB_per_s"] = benchmark::Counter(3e-9 * sizeof(double) * static_cast<double>(n),
                                                  benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(triad)->Unit(benchmark::kMillisecond);

}  // namespace
