#include "dynamics/system_matrix.h"

#include <algorithm>

namespace shell_origami {

SystemMatrix::SystemMatrix(const Shell& shell, const std::vector<int>& unknown, int unknown_count)
    : block_rows_(unknown_count) {
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
  makePattern(std::move(below));

  target_starts_.push_back(0);
  for (const Triangle& t : shell.triangles()) addStencil(t.data(), 3, unknown);
  for (const Hinge& hinge : shell.hinges()) addStencil(hinge.vertices.data(), 4, unknown);
}

void SystemMatrix::makePattern(std::vector<std::vector<int>> below) {
  block_starts_.push_back(0);
  column_starts_.push_back(0);
  for (int j = 0; j < block_rows_; ++j) {
    std::vector<int>& rows = below[j];
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    block_indices_.insert(block_indices_.end(), rows.begin(), rows.end());
    block_starts_.push_back(static_cast<int>(block_indices_.size()));
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) row_indices_.push_back(3 * j + r);
      for (int i : rows) {
        for (int r = 0; r < 3; ++r) row_indices_.push_back(3 * i + r);
      }
      column_starts_.push_back(static_cast<int>(row_indices_.size()));
    }
  }
  values_.resize(row_indices_.size());
}

void SystemMatrix::addStencil(const int* vertices, int count, const std::vector<int>& unknown) {
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const int row = unknown[vertices[i]], column = unknown[vertices[j]];
      if (column < 0 || row < column) continue;
      const auto first = block_indices_.begin() + block_starts_[column];
      const auto last = block_indices_.begin() + block_starts_[column + 1];
      const int place =
          row == column ? 0 : 1 + static_cast<int>(std::lower_bound(first, last, row) - first);
      const int stride = column_starts_[3 * column + 1] - column_starts_[3 * column];
      targets_.push_back({column_starts_[3 * column] + 3 * place, stride, i, j});
    }
  }
  target_starts_.push_back(static_cast<int>(targets_.size()));
}

void SystemMatrix::setZero() { std::fill(values_.begin(), values_.end(), 0.0); }

void SystemMatrix::addToDiagonal(int block_row, double value) {
  const int start = column_starts_[3 * block_row];
  const int stride = column_starts_[3 * block_row + 1] - start;
  for (int c = 0; c < 3; ++c) values_[start + c * stride + c] += value;
}

}  // namespace shell_origami
