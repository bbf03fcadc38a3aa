/// \file
/// Decides whether paper folded flat has an order of layers, and lists the orders that it has.
#pragma once

#include "test/acceptance/layer_conditions.h"

#include <cstddef>
#include <vector>

namespace shell_origami {

/// Returns the stackings that keep every condition and the order of every crease, `limit` at most.
/// An order that all others leave one choice is taken at once; of those that are left one is tried
/// both ways.
std::vector<Stacking> stackings(const LayerConditions& conditions, std::size_t limit);

}  // namespace shell_origami
