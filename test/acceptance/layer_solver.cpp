#include "test/acceptance/layer_solver.h"

#include <cstdlib>

namespace shell_origami {
namespace {

class Solver {
 public:
  Solver(const LayerConditions& conditions, std::size_t limit)
      : conditions_(conditions), limit_(limit), of_pair_(conditions.pairs.size()) {
    for (const LayerCondition& condition : conditions.conditions) {
      for (const auto& term : condition.terms) of_pair_[term.pair].push_back(&condition);
    }
  }

  std::vector<Stacking> solve() {
    Stacking stacking(conditions_.pairs.size(), 0);
    for (const Creased& creased : conditions_.creased) {
      if (!assign(creased.pair, creased.order, stacking)) return {};
    }
    search(stacking, 0);
    return found_;
  }

 private:
  /// Tries both orders of the first pair, from `from` on, that has none.
  void search(const Stacking& stacking, std::size_t from) {
    while (from < stacking.size() && stacking[from] != 0) ++from;
    if (from == stacking.size()) {
      found_.push_back(stacking);
      return;
    }
    for (int order : {1, -1}) {
      if (found_.size() >= limit_) return;
      Stacking tried = stacking;
      if (assign(static_cast<int>(from), order, tried)) search(tried, from + 1);
    }
  }

  /// Gives a pair an order and all others that follow. Returns false where a condition is broken.
  bool assign(int pair, int order, Stacking& stacking) const {
    if (stacking[pair] != 0) return stacking[pair] == order;
    stacking[pair] = order;
    std::vector<int> changed = {pair};
    while (!changed.empty()) {
      const int next = changed.back();
      changed.pop_back();
      for (const LayerCondition* condition : of_pair_[next]) {
        if (!follow(*condition, stacking, changed)) return false;
      }
    }
    return true;
  }

  static bool agrees(const LayerCondition& condition, const std::vector<int>& order,
                     const Stacking& stacking) {
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto& [pair, sign] = condition.terms[i];
      if (stacking[pair] == -sign * order[i]) return false;
    }
    return true;
  }

  /// Gives those of a condition's pairs an order that have the same one in all that is allowed yet.
  static bool follow(const LayerCondition& condition, Stacking& stacking,
                     std::vector<int>& changed) {
    std::vector<int> sums(condition.terms.size(), 0);
    int count = 0;
    for (const std::vector<int>& order : allowedOrders(condition.kind)) {
      if (!agrees(condition, order, stacking)) continue;
      for (std::size_t i = 0; i < order.size(); ++i) sums[i] += order[i];
      ++count;
    }
    for (std::size_t i = 0; i < sums.size() && count > 0; ++i) {
      const auto& [pair, sign] = condition.terms[i];
      if (stacking[pair] != 0 || std::abs(sums[i]) != count) continue;
      stacking[pair] = sums[i] > 0 ? sign : -sign;
      changed.push_back(pair);
    }
    return count > 0;
  }

  const LayerConditions& conditions_;
  std::size_t limit_;
  std::vector<std::vector<const LayerCondition*>> of_pair_;
  std::vector<Stacking> found_;
};

}  // namespace

std::vector<Stacking> stackings(const LayerConditions& conditions, std::size_t limit) {
  return Solver(conditions, limit).solve();
}

}  // namespace shell_origami
