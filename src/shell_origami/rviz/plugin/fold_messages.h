/// \file
/// Requests to the node, made of folds laid with the mouse.
#pragma once

#include <shell_origami/node/messages.h>
#include <shell_origami/rviz/seen_fold.h>

#include <string>

namespace shell_origami {

/// Returns the fold through the layers that it reaches. \pre its reach is not kSegment
msg::FoldThrough::Request foldThroughRequest(const LaidFold& fold, const SeenFold& seen,
                                             const std::string& name);
/// Returns the fold of one layer from the first point to the second.
/// \param front  whether that layer shows its front
msg::Fold::Request foldRequest(const LaidFold& fold, bool front, const std::string& name);
/// Returns the fold of a crease that is there: by its name where no other one has it.
msg::Fold::Request foldRequest(const TurnCrease& turn, const Sheet& sheet);

/// Returns the request for a vertex at a place on the edge of its triangle that is nearest to it on
/// the flat sheet.
msg::AddVertex::Request addVertexRequest(const PaperPlace& place, const Sheet& sheet);

}  // namespace shell_origami
