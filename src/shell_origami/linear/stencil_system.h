/// \file
/// The linear system of a Newton step, over stencils that may change from step to step.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/linear/block_matrix.h>
#include <shell_origami/linear/cholesky.h>

#include <vector>

namespace shell_origami {

/// Solves H s = -g for the free vertices. The matrix keeps the pattern of earlier stencils as long
/// as it is not much larger than needed, so that stencils that come and go need one analysis and
/// not one each time.
class StencilSystem {
 public:
  /// Starts a new pattern. `free[v]` is false for vertices that are no unknowns.
  void setFree(const std::vector<bool>& free);
  bool hasUnknowns() const { return unknown_count_ > 0; }

  /// The pattern, by the numbers of the unknowns. It depends on earlier stencils, and the order of
  /// elimination, on which the bits of a solution depend, on it.
  const VertexGraph& pattern() const { return graph_; }
  /// Goes on with the pattern of another system. \pre setFree() was called with the same argument
  /// as that one's. Returns false where the pattern is of another number of unknowns.
  bool restorePattern(VertexGraph pattern);

  /// Prepares the matrix for these lists of stencils, one for each energy in a fixed order: grows
  /// its pattern and analyzes it anew where a stencil is not covered. Returns false where CHOLMOD
  /// could not analyze it, and is as after setFree() then.
  bool prepare(const std::vector<const Stencils*>& stencils);
  /// Number of analyses of the pattern so far.
  int analyses() const { return analyses_; }

  void setZero() { matrix_.setZero(); }
  /// Adds the blocks of the list at this place in prepare()'s argument.
  HessianBlocks blocks(std::size_t list) { return {matrix_, targets_[list].targets}; }
  /// As well multiplies those of `stencils`, which is that list, by a motion.
  HessianBlocks blocks(std::size_t list, const Stencils& stencils, PrescribedMotion& motion) {
    return {matrix_, targets_[list].targets, stencils, motion};
  }
  /// Adds factor * weights[v] times the identity to the diagonal block of every unknown vertex.
  void addToDiagonal(double factor, const Eigen::VectorXd& weights);

  /// Returns false where the matrix is not positive definite.
  bool factorize() { return cholesky_.factorize(matrix_); }
  /// Writes -H^-1 gradient into the columns of unknown vertices of `step`, with the last factor.
  /// Returns false where CHOLMOD failed. \pre factorize() returned true
  bool solve(const Positions& gradient, Positions& step);

 private:
  struct List {
    bool found = false;
    std::uint64_t revision = 0;
    BlockTargets targets;
  };

  bool findTargets(const std::vector<const Stencils*>& stencils);
  bool grow(const std::vector<const Stencils*>& stencils);
  bool analyze(VertexGraph graph);

  std::vector<int> numbers_;  ///< of each unknown vertex in graph_, -1 elsewhere
  std::vector<int> rows_;     ///< block row of each unknown vertex, -1 elsewhere
  int unknown_count_ = 0;
  VertexGraph graph_;
  bool analyzed_ = false;
  int analyses_ = 0;
  BlockMatrix matrix_;
  Cholesky cholesky_;
  std::vector<List> targets_;
  Eigen::VectorXd right_hand_side_;
};

}  // namespace shell_origami
