/// \file
/// Paper that meets paper: the solver's work in each step, and how close the layers come.
#include "bench/contact_limit.h"
#include "bench/run.h"
#include "bench/scenes.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

namespace shell_origami {
namespace {

double percentile95(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() * 95 / 100];
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// The most contacts, the smallest gap [um] and the crossings of a run.
class Closeness {
 public:
  void look(const Simulation& simulation) {
    const std::vector<Contact> contacts = simulation.contacts();
    most_ = std::max(most_, contacts.size());
    const double gap = smallestGap(contacts);
    if (gap >= 0 && (gap_ < 0 || gap < gap_)) gap_ = gap;
    if (simulation.counters().steps % 10 == 0) crossings_ += simulation.crossings().size();
  }
  void report(benchmark::State& state) const {
    state.counters["contacts_max"] = static_cast<double>(most_);
    state.counters["gap_um"] = gap_ < 0 ? -1 : 1e6 * gap_;
    state.counters["crossings"] = static_cast<double>(crossings_);
  }

 private:
  std::size_t most_ = 0, crossings_ = 0;
  double gap_ = -1;
};

/// Every twentieth step that ends with contacts, beside what no such step can do without.
class Limits {
 public:
  void look(const Run& run) {
    const Simulation& simulation = run.simulation();
    if (simulation.counters().steps % 20 != 0 || simulation.contacts().empty()) return;
    const ContactLimit limit = measureContactLimit(simulation);
    steps_ += run.lastStep();
    all_ += limit.total();
    candidates_ += limit.candidates;
  }
  void report(benchmark::State& state) const {
    if (all_ == 0) return;
    state.counters["step_over_contact_limit"] = steps_ / all_;
    state.counters["candidates_in_limit"] = candidates_ / all_;
  }

 private:
  double steps_ = 0, all_ = 0, candidates_ = 0;  // [s]
};

/// Without contact as well: what it costs.
void touch(benchmark::State& state, const std::string& scene, bool contact, int threads) {
  for (auto _ : state) {
    Recipe recipe = touching(scene, static_cast<double>(state.range(0)));
    recipe.config.contact.enabled = contact;
    recipe.config.solver.threads = threads;
    Run run(recipe);
    Closeness closeness;
    Limits limits;
    std::vector<double> iterations, factorizations;
    for (Counters before; run.step(); before = run.simulation().counters()) {
      const Counters& now = run.simulation().counters();
      iterations.push_back(static_cast<double>(now.newton_iterations - before.newton_iterations));
      factorizations.push_back(static_cast<double>(now.factorizations - before.factorizations));
      closeness.look(run.simulation());
      if (contact) limits.look(run);
    }
    run.report(state);
    closeness.report(state);
    limits.report(state);
    state.counters["newton_median"] = median(iterations);
    state.counters["newton_p95"] = percentile95(iterations);
    state.counters["newton_max"] = largest(iterations);
    state.counters["factorizations_p95"] = percentile95(factorizations);
    state.counters["factorizations_max"] = largest(factorizations);
    state.counters["step_max_ms"] = 1e3 * run.longestStep();
  }
}

void enlist(const std::string& name, const std::string& scene) {
  const auto add = [&](const std::string& variant, bool contact, int threads) {
    benchmark::RegisterBenchmark(
        (name + variant).c_str(),
        [=](benchmark::State& state) { touch(state, scene, contact, threads); })
        ->Arg(500)
        ->Arg(2000)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  };
  add("", true, 1);
  add("_two_threads", true, 2);
  add("_without", false, 1);
}

[[maybe_unused]] const bool registered = [] {
  enlist("contact_half_fold", "half_fold");
  enlist("contact_letter", "letter");
  enlist("contact_pleats", "pleats");
  enlist("contact_map_fold", "map_fold");
  enlist("contact_map_arriving", "../../recipes/map");
  return true;
}();

}  // namespace
}  // namespace shell_origami
