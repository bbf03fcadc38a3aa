/// \file
/// Edge making (Discrete Shells Origami, sections 2.2 and 2.5): edits of the flat sheet.
#pragma once

#include <shell_origami/sheet/remap.h>

#include <set>
#include <string>
#include <vector>

namespace shell_origami {

/// Properties of the folded paper that an edit must respect.
struct EditContext {
  /// Positions of the vertices in space; null: flat. Edges across which the paper is bent are not
  /// flipped and vertices on a bend are not shifted, so that the paper keeps its shape.
  const Positions* positions = nullptr;
  /// Vertices that must not be shifted.
  std::set<int> held;
  /// Whether the paper keeps its shape exactly: edges are split only, even if slivers stay. Paper
  /// is never quite flat, and where it touches paper a shifted vertex may come out on the other
  /// side.
  bool exact = false;
};

/// The result of makeFoldLine().
struct FoldLine {
  std::vector<std::uint32_t> crease_ids;  ///< creases on the line, in order from its start
  std::vector<int> vertices;              ///< the polyline in order, one part after the other
  int parts = 1;                          ///< of the line that lie on the paper
  Remap remap;
};

/// Makes the straight flat line from `line[0]` to `line[1]` run along edges of the sheet and
/// those edges creases. Faces that the line crosses are split, edges that already lie on it are
/// kept, a vertex close to it is shifted onto it, and neighbours are repaired so that every face
/// stays a triangle; then unlabelled edges nearby are flipped and loose vertices shifted so that
/// no sliver stays that the creases do not force.
/// Edges of an existing crease that the line covers stay that crease when it is covered whole,
/// otherwise the covered part is cut off as a crease of its own; all other edges of the line
/// become one new crease called `name` (a name of its own if empty). Where the line leaves the
/// paper, over a hole or across a slit, it is parted; along the border or a slit it does not fold.
/// An end that is hardly off the border, a crease or a vertex of theirs (kMergedFeature) is taken
/// to be on it. Bumps the revision. On any error the sheet is untouched. Throws
/// std::invalid_argument if an end is not finite or off the paper, the ends coincide, the line runs
/// along the border only, it would leave an edge shorter than kShortestEdge, or the name is not one
/// for a crease.
FoldLine makeFoldLine(Sheet& sheet, const Segment& line, const std::string& name = "",
                      const EditContext& context = {});

struct AddedVertex {
  int vertex;
  Remap remap;
};

/// Splits the edge a, b at `fraction` of its flat length from a and repairs both neighbours.
/// Bumps the revision. Throws std::invalid_argument if a, b is no edge, fraction is outside (0, 1),
/// or a part of the edge would be shorter than kShortestEdge allows.
AddedVertex addVertex(Sheet& sheet, int a, int b, double fraction);

}  // namespace shell_origami
