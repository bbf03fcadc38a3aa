#include "bench/run.h"

#include <shell_origami/base/timer.h>

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

/// Returns freed memory to the system and resets its measurement of the peak.
void forgetPeakMemory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

Simulation measuredSimulation(const Recipe& recipe) {
  forgetPeakMemory();
  return makeSimulation(recipe.sheet, recipe.config);
}

}  // namespace

double peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Run::Run(Recipe recipe)
    : runner_(std::move(recipe)), simulation_(measuredSimulation(runner_.recipe())) {}

bool Run::step() {
  {
    const Timer timer(edit_time_);
    const auto apply = [this](const std::vector<Edit>& edits) {
      edits_ += edits.size();
      simulation_.apply(edits);
      return true;
    };
    if (!runner_.update(simulation_, apply)) return false;
  }
  StepReport report;
  double wall = 0;
  const Allocations before = allocations();
  {
    const Timer timer(wall);
    report = simulation_.step();
  }
  const Allocations made = allocations() - before;
  if (!report.converged) {
    throw std::runtime_error(runner_.recipe().name + ": " + report.failure);
  }
  step_times_.push_back(wall);
  allocations_.push_back(static_cast<double>(made.all));
  cholmod_allocations_.push_back(static_cast<double>(made.cholmod));
  return true;
}

double Run::meanStep() const {
  return std::accumulate(step_times_.begin(), step_times_.end(), 0.0) /
         static_cast<double>(step_times_.size());
}

double Run::longestStep() const {
  return *std::max_element(step_times_.begin(), step_times_.end());
}

void Run::report(benchmark::State& state) const {
  const Counters& counters = simulation_.counters();
  const auto steps = static_cast<double>(counters.steps);
  const auto per_step = [steps](double sum) { return sum / steps; };
  auto& out = state.counters;
  out["triangles"] = static_cast<double>(simulation_.sheet().triangles().size());
  out["steps"] = steps;
  out["step_median_ms"] = 1e3 * medianStep();
  out["step_mean_ms"] = 1e3 * meanStep();
  out["assembly_ms"] = 1e3 * per_step(counters.times.assembly);
  out["symbolic_ms"] = 1e3 * per_step(counters.times.symbolic);
  out["numeric_ms"] = 1e3 * per_step(counters.times.numeric);
  out["solve_ms"] = 1e3 * per_step(counters.times.solve);
  out["search_ms"] = 1e3 * per_step(counters.times.search);
  out["edit_ms"] = 1e3 * edit_time_ / static_cast<double>(edits_);
  out["newton"] = per_step(static_cast<double>(counters.newton_iterations));
  out["factorizations"] = per_step(static_cast<double>(counters.factorizations));
  out["retries"] = static_cast<double>(counters.retries);
  out["real_time_factor"] = simulation_.time() / (steps * meanStep() + edit_time_);
  out["allocations"] = median(allocations_);
  out["cholmod_allocations"] = median(cholmod_allocations_);
  out["peak_memory_MB"] = peakMemory();
}

}  // namespace shell_origami
