#include <shell_origami/linear/vertex_graph.h>

#include <algorithm>

namespace shell_origami {

VertexGraph VertexGraph::fromLists(std::vector<std::vector<int>>& below) {
  VertexGraph graph;
  for (std::vector<int>& rows : below) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    graph.indices.insert(graph.indices.end(), rows.begin(), rows.end());
    graph.starts.push_back(static_cast<int>(graph.indices.size()));
  }
  return graph;
}

void VertexGraph::add(const std::vector<const Stencils*>& stencils, const std::vector<int>& rows) {
  std::vector<std::vector<int>> below(size());
  for (int j = 0; j < size(); ++j) {
    below[j].assign(indices.begin() + starts[j], indices.begin() + starts[j + 1]);
  }
  for (const Stencils* list : stencils) {
    for (int i = 0; i < list->count(); ++i) {
      for (const int* a = list->begin(i); a != list->end(i); ++a) {
        for (const int* b = list->begin(i); b != list->end(i); ++b) {
          const int row = rows[*a], column = rows[*b];
          if (column >= 0 && row > column) below[column].push_back(row);
        }
      }
    }
  }
  *this = fromLists(below);
}

bool VertexGraph::valid(int size) const {
  const int count = static_cast<int>(indices.size());
  if (this->size() != size || starts.front() != 0 || starts.back() != count) return false;
  for (int j = 0; j < size; ++j) {
    if (starts[j] > starts[j + 1] || starts[j + 1] > count) return false;
    for (int k = starts[j], last = j; k < starts[j + 1]; last = indices[k++]) {
      if (indices[k] <= last || indices[k] >= size) return false;
    }
  }
  return true;
}

VertexGraph VertexGraph::renumbered(const std::vector<int>& place) const {
  std::vector<std::vector<int>> below(size());
  for (int j = 0; j < size(); ++j) {
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      const auto [column, row] = std::minmax(place[j], place[indices[k]]);
      below[column].push_back(row);
    }
  }
  return fromLists(below);
}

}  // namespace shell_origami
