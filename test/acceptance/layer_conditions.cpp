#include "test/acceptance/layer_conditions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>

namespace shell_origami {
namespace {

/// Edges lie on each other, or inside a panel, where they do so along more than this many
/// tolerances: next to a shorter part the panels' cores may not meet.
constexpr double kShortest = 10;

const char* nameOf(ConditionKind kind) {
  switch (kind) {
    case ConditionKind::kTacoTaco: return "taco-taco";
    case ConditionKind::kTacoTortilla: return "taco-tortilla";
    default: return "transitivity";
  }
}

/// Whether panels in these places of a stack are in an order that a condition allows.
bool allows(ConditionKind kind, const std::vector<int>& place) {
  const auto between = [&](int panel) {
    return (place[panel] < place[0]) != (place[panel] < place[1]);
  };
  switch (kind) {
    case ConditionKind::kTacoTaco: return between(2) == between(3);
    case ConditionKind::kTacoTortilla: return !between(2);
    default: return true;
  }
}

std::vector<std::vector<int>> ordersAllowed(ConditionKind kind) {
  std::vector<int> place(kind == ConditionKind::kTacoTaco ? 4 : 3);
  std::iota(place.begin(), place.end(), 0);
  std::vector<std::vector<int>> orders;
  do {
    if (!allows(kind, place)) continue;
    std::vector<int> order;
    for (std::size_t i = 0; i < place.size(); ++i) {
      for (std::size_t j = i + 1; j < place.size(); ++j) {
        order.push_back(place[i] < place[j] ? 1 : -1);
      }
    }
    orders.push_back(order);
  } while (std::next_permutation(place.begin(), place.end()));
  return orders;
}

double distanceFromLine(const Vector2& p, const Segment& line) {
  return cross((line[1] - line[0]).normalized(), p - line[0]);
}

/// Length that two edges share, where one lies on the line of the other.
double sharedLength(const Segment& a, const Segment& b, double tolerance) {
  for (const Vector2& p : b) {
    if (std::abs(distanceFromLine(p, a)) > tolerance) return 0;
  }
  const Vector2 along = (a[1] - a[0]).normalized();
  const auto [from, to] = std::minmax({along.dot(b[0] - a[0]), along.dot(b[1] - a[0])});
  return std::min(to, (a[1] - a[0]).norm()) - std::max(from, 0.0);
}

class Maker {
 public:
  explicit Maker(const FlatFold& fold) : fold_(fold), shortest_(kShortest * fold.tolerance) {}

  LayerConditions make() {
    findPairs();
    for (const ShutEdge& edge : fold_.edges) addCreased(edge);
    for (std::size_t i = 0; i < fold_.edges.size(); ++i) {
      addTortillas(fold_.edges[i]);
      for (std::size_t j = i + 1; j < fold_.edges.size(); ++j) {
        addTacos(fold_.edges[i], fold_.edges[j]);
      }
    }
    return made_;
  }

 private:
  Polygon shared(const Polygon& a, const Polygon& b) const {
    const Polygon both = clip(a, b);
    return areaOf(both) > fold_.tolerance * fold_.tolerance ? both : Polygon();
  }

  void findPairs() {
    const int count = static_cast<int>(fold_.panels.size());
    std::vector<std::vector<Polygon>> regions(count, std::vector<Polygon>(count));
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        regions[a][b] = shared(fold_.panels[a].core, fold_.panels[b].core);
        if (regions[a][b].empty()) continue;
        index_[{a, b}] = static_cast<int>(made_.pairs.size());
        made_.pairs.push_back({a, b});
      }
    }
    for (const auto& [a, b] : made_.pairs) {
      for (int c = b + 1; c < count; ++c) {
        if (regions[a][c].empty() || regions[b][c].empty()) continue;
        if (shared(regions[a][b], fold_.panels[c].core).empty()) continue;
        add(ConditionKind::kTransitivity, {a, b, c});
      }
    }
  }

  LayerCondition::Term term(int a, int b) const {
    const auto place = index_.find(std::minmax(a, b));
    if (place == index_.end()) {
      throw std::logic_error("panels " + std::to_string(a) + " and " + std::to_string(b) +
                             " meet in an edge and do not overlap");
    }
    return {place->second, a < b ? 1 : -1};
  }

  void add(ConditionKind kind, const std::vector<int>& panels) {
    if (!known_.insert({kind, panels}).second) return;
    LayerCondition condition{kind, panels, {}};
    for (std::size_t i = 0; i < panels.size(); ++i) {
      for (std::size_t j = i + 1; j < panels.size(); ++j) {
        condition.terms.push_back(term(panels[i], panels[j]));
      }
    }
    made_.conditions.push_back(condition);
  }

  /// A valley brings the fronts of its panels together, a mountain their backs.
  void addCreased(const ShutEdge& edge) {
    const auto [a, b] = edge.panels;
    const LayerCondition::Term a_above_b = term(a, b);
    const int order = fold_.panels[a].front_up == edge.valley ? -1 : 1;
    const Creased creased{a_above_b.pair, a_above_b.sign * order, edge.crease};
    if (!creased_.insert({creased.pair, creased.order}).second) return;
    made_.creased.push_back(creased);
  }

  void addTortillas(const ShutEdge& edge) {
    const auto [a, b] = std::minmax(edge.panels[0], edge.panels[1]);
    for (int c = 0; c < static_cast<int>(fold_.panels.size()); ++c) {
      if (c == a || c == b || lengthInside(edge.ends, fold_.panels[c].core) < shortest_) continue;
      add(ConditionKind::kTacoTortilla, {a, b, c});
    }
  }

  void addTacos(const ShutEdge& one, const ShutEdge& two) {
    const auto [a, b] = std::minmax(one.panels[0], one.panels[1]);
    const auto [c, d] = std::minmax(two.panels[0], two.panels[1]);
    if ((a == c && b == d) || sharedLength(one.ends, two.ends, fold_.tolerance) < shortest_) return;
    const auto side = [&](int panel) {
      double most = 0;
      for (const Vector2& p : fold_.panels[panel].outline) {
        const double distance = distanceFromLine(p, one.ends);
        if (std::abs(distance) > std::abs(most)) most = distance;
      }
      return most > 0;
    };
    if (side(a) != side(c)) return;
    if (a < c) {
      add(ConditionKind::kTacoTaco, {a, b, c, d});
    } else {
      add(ConditionKind::kTacoTaco, {c, d, a, b});
    }
  }

  const FlatFold& fold_;
  double shortest_;
  LayerConditions made_;
  std::map<std::pair<int, int>, int> index_;
  std::set<std::pair<ConditionKind, std::vector<int>>> known_;
  std::set<std::pair<int, int>> creased_;
};

}  // namespace

int LayerConditions::count(ConditionKind kind) const {
  return std::count_if(conditions.begin(), conditions.end(),
                       [&](const LayerCondition& condition) { return condition.kind == kind; });
}

LayerConditions layerConditions(const FlatFold& fold) { return Maker(fold).make(); }

const std::vector<std::vector<int>>& allowedOrders(ConditionKind kind) {
  static const std::array<std::vector<std::vector<int>>, 3> orders = {
      ordersAllowed(ConditionKind::kTacoTaco), ordersAllowed(ConditionKind::kTacoTortilla),
      ordersAllowed(ConditionKind::kTransitivity)};
  return orders[static_cast<int>(kind)];
}

std::vector<std::string> broken(const LayerConditions& conditions, const Stacking& stacking) {
  std::vector<std::string> sentences;
  for (const Creased& creased : conditions.creased) {
    if (stacking[creased.pair] == creased.order) continue;
    const auto [a, b] = conditions.pairs[creased.pair];
    sentences.push_back("crease " + std::to_string(creased.crease) +
                        " is folded to the side that " + "its panels " + std::to_string(a) +
                        " and " + std::to_string(b) + " do not lie on");
  }
  for (const LayerCondition& condition : conditions.conditions) {
    std::vector<int> order;
    for (const auto& term : condition.terms) order.push_back(term.sign * stacking[term.pair]);
    const auto& allowed = allowedOrders(condition.kind);
    if (std::find(allowed.begin(), allowed.end(), order) != allowed.end()) continue;
    std::string sentence = std::string(nameOf(condition.kind)) + " of the panels";
    for (int panel : condition.panels) sentence += " " + std::to_string(panel);
    sentences.push_back(sentence);
  }
  return sentences;
}

}  // namespace shell_origami
