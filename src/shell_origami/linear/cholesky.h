/// \file
/// Sparse Cholesky factorization (CHOLMOD, which is included nowhere else).
#pragma once

#include <shell_origami/linear/block_matrix.h>
#include <shell_origami/linear/vertex_graph.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shell_origami {

/// Returns the order in which to eliminate the vertices so that the factor stays sparse and its
/// supernodes are contiguous: order[i] is the vertex of block row i. A matrix made in this order is
/// factorized without a permutation, which would cost a tenth of the factorization each time.
/// Returns an empty order where CHOLMOD fails, for want of memory, say.
std::vector<int> eliminationOrder(const VertexGraph& graph);

/// CHOLMOD's supernodal factorization. Its failures are return values: a step that fails is retried
/// or reported, and the program goes on.
class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Symbolic work: kept until the pattern changes. Returns false where CHOLMOD fails.
  /// \pre rows are in an elimination order
  bool analyze(const BlockMatrix& matrix);
  /// Numeric work. Returns false when the matrix is not positive definite.
  bool factorize(const BlockMatrix& matrix);
  /// Solves with the last factor, in place. Returns false where CHOLMOD fails, and then has not
  /// changed b. \pre factorize() returned true
  bool solve(Eigen::VectorXd& b);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace shell_origami
