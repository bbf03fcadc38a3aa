#include <shell_origami/linear/block_matrix.h>

#include <algorithm>

namespace shell_origami {

VertexGraph::VertexGraph(const Shell& shell, const std::vector<int>& unknown, int unknown_count) {
  std::vector<std::vector<int>> below(unknown_count);
  const auto collect = [&](const int* vertices, int count) {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const int row = unknown[vertices[i]], column = unknown[vertices[j]];
        if (column >= 0 && row > column) below[column].push_back(row);
      }
    }
  };
  for (const Triangle& t : shell.triangles()) collect(t.data(), 3);
  for (const Hinge& hinge : shell.hinges()) collect(hinge.vertices.data(), 4);
  starts.push_back(0);
  for (std::vector<int>& rows : below) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    indices.insert(indices.end(), rows.begin(), rows.end());
    starts.push_back(static_cast<int>(indices.size()));
  }
}

BlockMatrix::BlockMatrix(const Shell& shell, const std::vector<int>& unknown, int unknown_count)
    : block_rows_(unknown_count) {
  const VertexGraph graph(shell, unknown, unknown_count);
  column_starts_.push_back(0);
  for (int j = 0; j < block_rows_; ++j) {
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) row_indices_.push_back(3 * j + r);
      for (int k = graph.starts[j]; k < graph.starts[j + 1]; ++k) {
        for (int r = 0; r < 3; ++r) row_indices_.push_back(3 * graph.indices[k] + r);
      }
      column_starts_.push_back(static_cast<int>(row_indices_.size()));
    }
  }
  values_.resize(row_indices_.size());
  target_starts_.push_back(0);
  for (const Triangle& t : shell.triangles()) addStencil(t.data(), 3, unknown, graph);
  for (const Hinge& hinge : shell.hinges()) addStencil(hinge.vertices.data(), 4, unknown, graph);
}

void BlockMatrix::addStencil(const int* vertices, int count, const std::vector<int>& unknown,
                             const VertexGraph& graph) {
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const int row = unknown[vertices[i]], column = unknown[vertices[j]];
      if (column < 0 || row < column) continue;
      const auto first = graph.indices.begin() + graph.starts[column];
      const auto last = graph.indices.begin() + graph.starts[column + 1];
      const int place =
          row == column ? 0 : 1 + static_cast<int>(std::lower_bound(first, last, row) - first);
      const int stride = column_starts_[3 * column + 1] - column_starts_[3 * column];
      targets_.push_back({column_starts_[3 * column] + 3 * place, stride, i, j});
    }
  }
  target_starts_.push_back(static_cast<int>(targets_.size()));
}

void BlockMatrix::setZero() { std::fill(values_.begin(), values_.end(), 0.0); }

void BlockMatrix::addToDiagonal(int block_row, double value) {
  const int start = column_starts_[3 * block_row];
  const int stride = column_starts_[3 * block_row + 1] - start;
  for (int c = 0; c < 3; ++c) values_[start + c * stride + c] += value;
}

}  // namespace shell_origami
