/// \file
/// The frames of a folding sequence (FOLD's file class "diagrams"): which angles each asks for.
#pragma once

#include <shell_origami/fold_format/crease_pattern.h>
#include <shell_origami/fold_format/fold_file.h>

#include <vector>

namespace shell_origami {

/// Returns what each frame of a sequence, other than the pattern's, asks of the creases of a sheet
/// that was made of the pattern; nothing where the file is no sequence. A frame has the pattern's
/// mesh or states the flat coordinates of its vertices. One that cannot be used is passed over,
/// with a note. \param metres  of one unit of the file
std::vector<FoldStage> readStages(const FoldDocument& document, const CreasePattern& pattern,
                                  double metres, FoldPaper& paper);

}  // namespace shell_origami
