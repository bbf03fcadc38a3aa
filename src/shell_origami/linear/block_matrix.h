/// \file
/// A sparse symmetric matrix of 3x3 blocks, assembled from stencils without a search.
#pragma once

#include <shell_origami/base/parallel.h>
#include <shell_origami/linear/stencils.h>
#include <shell_origami/linear/vertex_graph.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace shell_origami {

/// Lower triangle, compressed columns, in blocks of 3x3: one block row an unknown vertex.
///
/// Every scalar column of a block column holds the rows of the same blocks, the diagonal one
/// first and whole (CHOLMOD does not read above the diagonal), so that entry (r, c) of a block
/// lies at start + c * stride + r.
class BlockMatrix {
 public:
  BlockMatrix() = default;
  /// All zeros, with a block where two vertices of the graph are neighbors and on the diagonal.
  explicit BlockMatrix(VertexGraph graph);

  int blockRows() const { return graph_.size(); }
  int size() const { return 3 * blockRows(); }
  const std::vector<int>& columnStarts() const { return column_starts_; }
  const std::vector<int>& rowIndices() const { return row_indices_; }
  const std::vector<double>& values() const { return values_; }

  void setZero();
  /// Adds value times the identity to a diagonal block.
  void addToDiagonal(int block_row, double value);

 private:
  friend class BlockTargets;
  friend class HessianBlocks;

  VertexGraph graph_;
  std::vector<int> column_starts_, row_indices_;
  std::vector<double> values_;
};

/// Places in a matrix at which the blocks of a list of stencils are added.
class BlockTargets {
 public:
  /// Looks the places up. `rows[v]` is the block row of vertex v, -1 where it is no unknown.
  /// Returns false where the matrix lacks a block that a stencil needs.
  bool find(const Stencils& stencils, const std::vector<int>& rows, const BlockMatrix& matrix);

 private:
  friend class HessianBlocks;

  /// Place of the block of a pair of vertices of a stencil.
  struct Target {
    int start;
    int stride;
    int row, column;  ///< of the pair in the stencil, so that the block is in the lower triangle
  };
  static bool addTargets(const Stencils& stencils, std::size_t stencil,
                         const std::vector<int>& rows, const BlockMatrix& matrix,
                         std::vector<Target>& targets);

  std::vector<int> starts_;
  std::vector<Target> targets_;
};

/// Displacements d_p of prescribed vertices, which are not unknowns, and the forces H_fp d_p that
/// these cause on the unknowns to first order.
struct PrescribedMotion {
  Eigen::Matrix3Xd displacements;  ///< one column a vertex, zero where it does not move [m]
  Eigen::Matrix3Xd forces;         ///< of all vertices, those of prescribed ones unused [N]
};

/// Adds the Hessian blocks of one list of stencils to a matrix, or to a part of it.
class HessianBlocks {
 public:
  HessianBlocks(BlockMatrix& matrix, const BlockTargets& targets)
      : values_(matrix.values_.data()), targets_(targets), part_{0, 0, matrix.values_.size()} {}
  /// Multiplies the blocks by a motion as well, which must live as long.
  HessianBlocks(BlockMatrix& matrix, const BlockTargets& targets, const Stencils& stencils,
                PrescribedMotion& motion)
      : HessianBlocks(matrix, targets) {
    stencils_ = &stencils;
    motion_ = &motion;
  }

  /// Calls assemble(HessianBlocks&) for parts of the matrix, at the same time. Each call adds the
  /// blocks of all stencils that reach() its part, of which only what is in the part is added. With
  /// the stencils in the same order, sums are the same with any number of parts.
  template <class Assemble>
  void inParts(const Assemble& assemble) {
    if (motion_) return assemble(*this);  // the forces are not divided
    forEachPart(part_.end, kSmallestPart, [&](const Chunk& part) {
      HessianBlocks blocks = *this;
      blocks.part_ = part;
      assemble(blocks);
    });
  }
  /// Whether a stencil has a place in the part.
  bool reach(int stencil) const {
    const auto first = targets_.targets_.begin() + targets_.starts_[stencil];
    const auto last = targets_.targets_.begin() + targets_.starts_[stencil + 1];
    return motion_ || std::any_of(first, last, [this](const auto& target) { return has(target); });
  }

  /// Adds the block of a stencil: three rows and columns for each of its vertices.
  template <int Size>
  void add(int stencil, const Eigen::Matrix<double, Size, Size>& block) {
    forEachColumn(stencil, [&](const BlockTargets::Target& target, int c, double* column) {
      for (int r = 0; r < 3; ++r) column[r] += block(3 * target.row + r, 3 * target.column + c);
    });
    if (motion_) addForces(stencil, block);
  }
  /// Adds factor * vector * vector^T.
  template <int Size>
  void addRankOne(int stencil, double factor, const Eigen::Matrix<double, Size, 1>& vector) {
    forEachColumn(stencil, [&](const BlockTargets::Target& target, int c, double* column) {
      const double scaled = factor * vector[3 * target.column + c];
      for (int r = 0; r < 3; ++r) column[r] += scaled * vector[3 * target.row + r];
    });
    if (motion_) {
      addForces(stencil, Eigen::Matrix<double, Size, Size>(factor * vector * vector.transpose()));
    }
  }

 private:
  bool has(const BlockTargets::Target& target) const { return part_.contains(target.start); }

  template <class Add>
  void forEachColumn(int stencil, Add&& add) {
    for (int i = targets_.starts_[stencil]; i < targets_.starts_[stencil + 1]; ++i) {
      const BlockTargets::Target& target = targets_.targets_[i];
      if (!has(target)) continue;
      for (int c = 0; c < 3; ++c) add(target, c, values_ + target.start + c * target.stride);
    }
  }

  template <int Size>
  void addForces(int stencil, const Eigen::Matrix<double, Size, Size>& block) {
    const int* vertices = stencils_->begin(stencil);
    for (int j = 0; j < Size / 3; ++j) {
      const auto displacement = motion_->displacements.col(vertices[j]);
      if (displacement.isZero(0)) continue;
      for (int i = 0; i < Size / 3; ++i) {
        motion_->forces.col(vertices[i]) += block.template block<3, 3>(3 * i, 3 * j) * displacement;
      }
    }
  }

  /// Values of a part: fewer are added sooner than another thread is awake.
  static constexpr std::size_t kSmallestPart = 40000;

  double* values_;
  const BlockTargets& targets_;
  Chunk part_;  ///< of the values, by where blocks start
  const Stencils* stencils_ = nullptr;
  PrescribedMotion* motion_ = nullptr;
};

}  // namespace shell_origami
