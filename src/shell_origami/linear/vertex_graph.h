/// \file
/// The graph of unknown vertices that share a stencil.
#pragma once

#include <shell_origami/linear/stencils.h>

#include <vector>

namespace shell_origami {

/// Compressed columns of the strictly lower triangle: the neighbors of vertex j that have a higher
/// number are indices[starts[j]] to indices[starts[j + 1] - 1], ascending.
class VertexGraph {
 public:
  VertexGraph() = default;
  explicit VertexGraph(int size) : starts(size + 1, 0) {}

  int size() const { return static_cast<int>(starts.size()) - 1; }

  /// Adds what the stencils couple. `rows[v]` is the number of vertex v here, -1 where it is no
  /// unknown.
  void add(const std::vector<const Stencils*>& stencils, const std::vector<int>& rows);
  /// Whether it is one of `size` vertices, as the comment above says.
  bool valid(int size) const;
  /// The same graph with vertex i renumbered to place[i].
  VertexGraph renumbered(const std::vector<int>& place) const;

  std::vector<int> starts{0}, indices;

 private:
  static VertexGraph fromLists(std::vector<std::vector<int>>& below);
};

}  // namespace shell_origami
