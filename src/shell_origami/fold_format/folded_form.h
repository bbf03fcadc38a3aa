/// \file
/// A pattern's folded form: where the paper is in space.
#pragma once

#include <shell_origami/fold_format/fold_document.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/fold_format/pattern_mesh.h>

namespace shell_origami {

/// Puts the paper where the file's last folded form (of a film, the end) has it, with its creases
/// at rest at their angles there. Leaves it flat where there is no folded form, or an edge of it is
/// folded flat, or with a note where edges of the pattern cross without a vertex. `made` is the
/// sheet that was made of the pattern; where it has vertices other than the file's, each stands at
/// its place in the file's faces. Lengths in the pattern are in metres; `metres` are those of one
/// unit of the file. \throws std::invalid_argument when it is no folded form of the pattern
void readFoldedForm(const FoldDocument& document, const CreasePattern& pattern, double metres,
                    const PatternSheet& made, FoldPaper& paper);

}  // namespace shell_origami
