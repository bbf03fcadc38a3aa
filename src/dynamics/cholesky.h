/// \file
/// Sparse Cholesky factorization (CHOLMOD, which is included nowhere else).
#pragma once

#include "dynamics/system_matrix.h"

#include <Eigen/Core>

#include <memory>

namespace shell_origami {

class Cholesky {
 public:
  Cholesky();
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Symbolic work: kept until the pattern changes. The order is found on the vertex graph.
  void analyze(const SystemMatrix& matrix);
  /// Numeric work. Returns false when the matrix is not positive definite.
  bool factorize(const SystemMatrix& matrix);
  /// Solves with the last factor, in place. \pre factorize() returned true
  void solve(Eigen::VectorXd& b);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace shell_origami
