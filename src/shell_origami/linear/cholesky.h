/// \file
/// Sparse Cholesky factorization (CHOLMOD, which is included nowhere else).
#pragma once

#include <shell_origami/linear/block_matrix.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shell_origami {

/// In which order to eliminate the vertices, so that the factor stays sparse and its supernodes lie
/// together: order[i] is the vertex of block row i. A matrix made in this order is factorized as it
/// stands; permuting it each time would cost a tenth of the factorization.
std::vector<int> eliminationOrder(const VertexGraph& graph);

class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Symbolic work: kept until the pattern changes. \pre rows are in an elimination order
  void analyze(const BlockMatrix& matrix);
  /// Numeric work. Returns false when the matrix is not positive definite.
  bool factorize(const BlockMatrix& matrix);
  /// Solves with the last factor, in place. \pre factorize() returned true
  void solve(Eigen::VectorXd& b);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace shell_origami
