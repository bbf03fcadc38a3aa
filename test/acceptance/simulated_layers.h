/// \file
/// The order of the layers of paper that was folded flat, but for some degrees, by the simulation.
#pragma once

#include "test/acceptance/layer_conditions.h"

#include <shell_origami/origami/simulation.h>

#include <string>
#include <vector>

namespace shell_origami {

/// Returns the same paper folded exactly flat.
/// \throws std::invalid_argument naming a crease that is neither nearly shut nor nearly flat, and
/// as
///         foldFlat() of a sheet does
FlatFold foldFlat(const Simulation& simulation);

struct SimulatedLayers {
  Stacking stacking;
  /// A sentence for each pair of panels that pass each other, or that lie beside each other in
  /// space: those have no order.
  std::vector<std::string> faults;
};

/// Compares panels that overlap when folded exactly flat, wherever their triangles overlap in
/// space, seen along the stack: there the one that is farther along its direction lies above.
/// Places of the exact fold would not do: layers that stay open by some degrees shift each other,
/// those of a crane by a tenth of the sheet. \param positions  of the sheet's vertices in space [m]
SimulatedLayers simulatedLayers(const Sheet& sheet, const Positions& positions,
                                const FlatFold& fold, const LayerConditions& conditions);

/// Returns a sentence for each fault of the order of layers; empty: it is one that a solver of
/// layerConditions() finds. \throws std::invalid_argument as foldFlat() does
std::vector<std::string> layerFaults(const Simulation& simulation);

}  // namespace shell_origami
