/// \file
/// The conditions under which paper folded flat has layers that do not pass through each other
/// (Akitaya, Demaine, Ku, "Computing Flat-Folded States", 2024, as Ku's program states them:
/// github.com/origamimagiro/flat-folder). Any two panels that overlap have an order:
///
///   taco-taco        two shut edges lie on each other with their panels on the same side of them:
///                    the panels of one do not alternate with those of the other
///   taco-tortilla    a panel goes on across a shut edge: it is not between the edge's panels
///   transitivity     three panels have a place in common: one lies above, one between, one below
///
/// Their fourth kind, tortilla-tortilla, is about edges that stay flat: the layers on both sides of
/// these have the same order. Panels here go on across such edges, which says the same.
#pragma once

#include "test/acceptance/flat_fold.h"

#include <array>
#include <string>
#include <vector>

namespace shell_origami {

enum class ConditionKind { kTacoTaco, kTacoTortilla, kTransitivity };

/// The order of each pair of LayerConditions::pairs: 1 where the first panel lies above the second,
/// -1 where it lies below, 0 where that is not known.
using Stacking = std::vector<int>;

struct LayerCondition {
  /// The order of two of its panels: that of a pair, or the reverse of it.
  struct Term {
    int pair;
    int sign;
  };

  ConditionKind kind;
  /// Of taco-taco the first two and the last two share an edge, of taco-tortilla the first two.
  std::vector<int> panels;
  std::vector<Term> terms;  ///< of panels 0 and 1, 0 and 2, ..., 1 and 2, ...
};

/// The order that a mountain or a valley gives its two panels.
struct Creased {
  int pair, order, crease;
};

struct LayerConditions {
  std::vector<std::array<int, 2>> pairs;  ///< of panels that overlap, ascending
  std::vector<LayerCondition> conditions;
  std::vector<Creased> creased;

  int count(ConditionKind kind) const;
};

/// \throws std::logic_error where panels meet in an edge and do not overlap beside it, as they may
///         where something is smaller than the fold's tolerance
LayerConditions layerConditions(const FlatFold& fold);

/// Returns the allowed orders of the terms of a condition of one kind.
const std::vector<std::vector<int>>& allowedOrders(ConditionKind kind);

/// Returns a sentence for each crease and each condition that a stacking without a 0 breaks.
std::vector<std::string> broken(const LayerConditions& conditions, const Stacking& stacking);

}  // namespace shell_origami
