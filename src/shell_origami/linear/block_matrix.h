/// \file
/// The sparse symmetric matrix of a Newton step, assembled without a search.
#pragma once

#include <shell_origami/energy/shell.h>

#include <Eigen/Core>

#include <vector>

namespace shell_origami {

/// Which unknown vertices share a triangle or a hinge: compressed columns of the lower triangle.
struct VertexGraph {
  VertexGraph(const Shell& shell, const std::vector<int>& unknown, int unknown_count);

  int size() const { return static_cast<int>(starts.size()) - 1; }

  std::vector<int> starts, indices;
};

/// Lower triangle, compressed columns, in blocks of 3x3: one block row an unknown vertex. The
/// pattern and the place of every element's entries stay as long as topology and pins do.
///
/// Every scalar column of a block column holds the rows of the same blocks, the diagonal one
/// first and whole (CHOLMOD does not read above the diagonal), so that entry (r, c) of a block
/// lies at start + c * stride + r.
class BlockMatrix {
 public:
  BlockMatrix() = default;
  /// `unknown[v]` is the block row of vertex v, or -1 where v is held.
  BlockMatrix(const Shell& shell, const std::vector<int>& unknown, int unknown_count);

  int blockRows() const { return block_rows_; }
  int size() const { return 3 * block_rows_; }
  const std::vector<int>& columnStarts() const { return column_starts_; }
  const std::vector<int>& rowIndices() const { return row_indices_; }
  const std::vector<double>& values() const { return values_; }

  void setZero();
  /// Adds value times the identity to a diagonal block.
  void addToDiagonal(int block_row, double value);
  /// Adds the block of a stencil of Shell::forEachHessian.
  template <int Size>
  void add(int stencil, const Eigen::Matrix<double, Size, Size>& block);
  void add(int stencil, const RankOne& block);

 private:
  /// Where the block of a pair of a stencil's corners lands.
  struct Target {
    int start;
    int stride;
    int row, column;  ///< corners, so that the block lies in the lower triangle
  };
  void addStencil(const int* vertices, int count, const std::vector<int>& unknown,
                  const VertexGraph& graph);

  int block_rows_ = 0;
  std::vector<int> column_starts_, row_indices_;
  std::vector<double> values_;
  std::vector<int> target_starts_;
  std::vector<Target> targets_;
};

template <int Size>
void BlockMatrix::add(int stencil, const Eigen::Matrix<double, Size, Size>& block) {
  for (int i = target_starts_[stencil]; i < target_starts_[stencil + 1]; ++i) {
    const Target& target = targets_[i];
    for (int c = 0; c < 3; ++c) {
      double* column = values_.data() + target.start + c * target.stride;
      for (int r = 0; r < 3; ++r) column[r] += block(3 * target.row + r, 3 * target.column + c);
    }
  }
}

inline void BlockMatrix::add(int stencil, const RankOne& block) {
  for (int i = target_starts_[stencil]; i < target_starts_[stencil + 1]; ++i) {
    const Target& target = targets_[i];
    for (int c = 0; c < 3; ++c) {
      double* column = values_.data() + target.start + c * target.stride;
      const double factor = block.factor * block.vector[3 * target.column + c];
      for (int r = 0; r < 3; ++r) column[r] += factor * block.vector[3 * target.row + r];
    }
  }
}

}  // namespace shell_origami
