/// \file
/// The faces of a planar graph.
#pragma once

#include <shell_origami/base/geometry.h>

#include <array>
#include <vector>

namespace shell_origami {

/// The walks around the faces of a planar graph, one for each connected part of a face's border:
/// counter-clockwise, with the face on the left, around the outside of a face; clockwise around
/// what lies inside it, as the unbounded face goes around all.
struct FaceWalks {
  /// The walks that run along each edge from its first end to its second, and back.
  std::vector<std::array<int, 2>> of_edges;
  std::vector<double> areas;  ///< of each walk, counter-clockwise positive

  /// The walk around all, by the largest area that is enclosed clockwise; -1 where no edges enclose
  /// more than `least` area.
  int outermost(double least) const;
};

/// Edges must meet only at their ends.
FaceWalks walkFaces(const std::vector<Vector2>& points,
                    const std::vector<std::array<int, 2>>& edges);

}  // namespace shell_origami
