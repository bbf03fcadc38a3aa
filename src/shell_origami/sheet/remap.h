/// \file
/// The word for what an edit did to a sheet.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <cstdint>
#include <vector>

namespace shell_origami {

/// Origins of vertices, edges, triangles and creases in an edit. Vertices are never removed or
/// renumbered; an edit may add some and shift some along the flat sheet.
struct Remap {
  static constexpr int kNone = -1;

  /// Previous place of a vertex of the sheet after the edit: the affine combination of up to
  /// three vertices of the sheet before (weights sum to 1). Carries positions, velocities and
  /// accelerations over.
  struct Origin {
    std::array<int, 3> vertices;
    Vector3 weights;
  };
  struct Born {
    std::uint32_t crease;
    std::uint32_t parent;
  };
  int vertices_before = 0;
  std::vector<int> changed;     ///< new and shifted vertices, ascending
  std::vector<Origin> origins;  ///< one for each of `changed`
  /// For each edge after, the edge before along which its middle lies: itself, or the one it is a
  /// part of. kNone for an edge that crosses a face.
  std::vector<int> edges;
  /// For each triangle after, the one before that its centroid lies in.
  std::vector<int> triangles;
  std::vector<Born> born;  ///< creases that were cut off an older one, which they resemble

  /// Values of one column a vertex, before the edit -> after it.
  Eigen::Matrix3Xd apply(const Eigen::Matrix3Xd& before, int vertices_after) const;
};

/// Returns the origins of vertices, edges and triangles of a later state of a sheet; points closer
/// than `tolerance` [m] are one. `born` is left empty.
Remap traceEdit(const Sheet& before, const Sheet& after, double tolerance);

}  // namespace shell_origami
