#include <shell_origami/linear/cholesky.h>

#include <shell_origami/linear/serial_scope.h>
#include <shell_origami/linear/workspace_pool.h>

#include <cholmod.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <mutex>
#include <vector>

namespace shell_origami {
namespace {

/// Nested dissection pays above this many vertices, minimum degree below: at 10,000 triangles the
/// factorization takes three quarters of the time.
constexpr int kDissectionVertices = 500;
/// Columns below which supernodes are merged whatever the zeros, and sparingly: three times
/// CHOLMOD's own. Sheets have many small supernodes, and merging them saves a quarter of the
/// factorization at 300 triangles, a tenth at 10,000.
constexpr std::size_t kMergedColumns[] = {12, 48, 144};

/// CHOLMOD's view of compressed columns that live elsewhere.
cholmod_sparse view(std::size_t size, const std::vector<int>& starts,
                    const std::vector<int>& indices, const double* values) {
  cholmod_sparse a{};
  a.nrow = a.ncol = size;
  a.nzmax = indices.size();
  a.p = const_cast<int*>(starts.data());
  a.i = const_cast<int*>(indices.data());
  a.x = const_cast<double*>(values);
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = true;
  a.packed = true;
  return a;
}

/// libopenblas0-serial takes its workspaces from one table without a lock: one thread at a time.
std::mutex blas_mutex;

}  // namespace

struct Cholesky::Implementation {
  WorkspacePool workspace;
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense* solution = nullptr;
  cholmod_dense *workspace_y = nullptr, *workspace_e = nullptr;

  Implementation() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;  // faster at every size of sheet
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NATURAL;
    common.postorder = false;
    std::copy(std::begin(kMergedColumns), std::end(kMergedColumns), common.nrelax);
    common.quick_return_if_not_posdef = true;
  }
  ~Implementation() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&workspace_y, &common);
    cholmod_free_dense(&workspace_e, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
};

std::vector<int> eliminationOrder(const VertexGraph& graph) {
  // METIS draws from the process's one sequence of random numbers.
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  common.nmethods = 1;
  common.method[0].ordering = graph.size() > kDissectionVertices ? CHOLMOD_METIS : CHOLMOD_AMD;
  common.postorder = true;
  cholmod_sparse pattern = view(graph.size(), graph.starts, graph.indices, nullptr);
  cholmod_factor* factor = cholmod_analyze(&pattern, &common);
  std::vector<int> order;
  if (factor) {
    const int* permutation = static_cast<const int*>(factor->Perm);
    order.assign(permutation, permutation + graph.size());
  }
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  return order;
}

Cholesky::Cholesky() : implementation_(std::make_unique<Implementation>()) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

bool Cholesky::analyze(const BlockMatrix& matrix) {
  Implementation& own = *implementation_;
  cholmod_free_factor(&own.factor, &own.common);
  cholmod_sparse a =
      view(matrix.size(), matrix.columnStarts(), matrix.rowIndices(), matrix.values().data());
  own.factor = cholmod_analyze(&a, &own.common);
  return own.factor != nullptr;
}

bool Cholesky::factorize(const BlockMatrix& matrix) {
  Implementation& own = *implementation_;
  cholmod_sparse a =
      view(matrix.size(), matrix.columnStarts(), matrix.rowIndices(), matrix.values().data());
  const std::lock_guard<std::mutex> lock(blas_mutex);
  const SerialScope serial;
  const WorkspacePool::Use use(own.workspace);
  return cholmod_factorize(&a, own.factor, &own.common) && own.factor->minor == own.factor->n;
}

bool Cholesky::solve(Eigen::VectorXd& b) {
  Implementation& own = *implementation_;
  cholmod_dense rhs{};
  rhs.nrow = rhs.nzmax = rhs.d = b.size();
  rhs.ncol = 1;
  rhs.x = b.data();
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  const std::lock_guard<std::mutex> lock(blas_mutex);
  const SerialScope serial;
  if (!cholmod_solve2(CHOLMOD_A, own.factor, &rhs, nullptr, &own.solution, nullptr,
                      &own.workspace_y, &own.workspace_e, &own.common)) {
    return false;
  }
  std::memcpy(b.data(), own.solution->x, b.size() * sizeof(double));
  return true;
}

}  // namespace shell_origami
