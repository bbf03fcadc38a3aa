/// \file
/// The order of layers that a FOLD file states (faceOrders). The sheet keeps it.
#pragma once

#include <shell_origami/fold_format/crease_pattern.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace shell_origami {

/// The orders that a file states of the faces of its pattern, in the last frame that states any, in
/// units of the file. Call it before dropUnused().
/// \throws std::invalid_argument naming the place in the file
std::vector<LayerOrder> readLayerOrders(const FoldDocument& document, const CreasePattern& pattern);

/// The sheet's orders as faceOrders of its triangles.
nlohmann::json layerOrdersOf(const Sheet& sheet);

}  // namespace shell_origami
