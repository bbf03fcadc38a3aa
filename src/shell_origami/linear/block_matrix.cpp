#include <shell_origami/linear/block_matrix.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

namespace shell_origami {
namespace {

/// Stencils whose places one thread looks up in one go.
constexpr std::size_t kStencilsPerChunk = 256;

}  // namespace

BlockMatrix::BlockMatrix(VertexGraph graph) : graph_(std::move(graph)) {
  column_starts_.push_back(0);
  for (int j = 0; j < blockRows(); ++j) {
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) row_indices_.push_back(3 * j + r);
      for (int k = graph_.starts[j]; k < graph_.starts[j + 1]; ++k) {
        for (int r = 0; r < 3; ++r) row_indices_.push_back(3 * graph_.indices[k] + r);
      }
      column_starts_.push_back(static_cast<int>(row_indices_.size()));
    }
  }
  values_.resize(row_indices_.size());
}

void BlockMatrix::setZero() { std::fill(values_.begin(), values_.end(), 0.0); }

void BlockMatrix::addToDiagonal(int block_row, double value) {
  const int start = column_starts_[3 * block_row];
  const int stride = column_starts_[3 * block_row + 1] - start;
  for (int c = 0; c < 3; ++c) values_[start + c * stride + c] += value;
}

bool BlockTargets::find(const Stencils& stencils, const std::vector<int>& rows,
                        const BlockMatrix& matrix) {
  std::atomic<bool> covered{true};
  targets_.clear();
  starts_.assign(stencils.count() + 1, 0);
  gatherChunks(stencils.count(), kStencilsPerChunk, targets_,
               [&](const Chunk& chunk, std::vector<Target>& targets) {
                 for (std::size_t s = chunk.begin; s < chunk.end && covered; ++s) {
                   const std::size_t before = targets.size();
                   if (!addTargets(stencils, s, rows, matrix, targets)) covered = false;
                   starts_[s + 1] = static_cast<int>(targets.size() - before);
                 }
               });
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  return covered;
}

/// Adds the places of one stencil's blocks. Returns false where the matrix lacks one.
bool BlockTargets::addTargets(const Stencils& stencils, std::size_t stencil,
                              const std::vector<int>& rows, const BlockMatrix& matrix,
                              std::vector<Target>& targets) {
  const VertexGraph& graph = matrix.graph_;
  const int* vertices = stencils.begin(static_cast<int>(stencil));
  const int count = static_cast<int>(stencils.end(static_cast<int>(stencil)) - vertices);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const int row = rows[vertices[i]], column = rows[vertices[j]];
      if (column < 0 || row < column) continue;
      const auto first = graph.indices.begin() + graph.starts[column];
      const auto last = graph.indices.begin() + graph.starts[column + 1];
      const auto found = std::lower_bound(first, last, row);
      if (row != column && (found == last || *found != row)) return false;
      const int place = row == column ? 0 : 1 + static_cast<int>(found - first);
      const int start = matrix.column_starts_[3 * column];
      const int stride = matrix.column_starts_[3 * column + 1] - start;
      targets.push_back({start + 3 * place, stride, i, j});
    }
  }
  return true;
}

}  // namespace shell_origami
