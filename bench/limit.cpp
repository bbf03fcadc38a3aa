#include "bench/limit.h"

#include <shell_origami/base/timer.h>
#include <shell_origami/linear/cholesky.h>
#include <shell_origami/linear/serial_scope.h>
#include "bench/allocations.h"
#include "bench/run.h"

#include <cholmod.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace shell_origami {
namespace {

constexpr int kRepetitions = 15;

/// Options of CHOLMOD, which is always supernodal here.
struct Setting {
  const char* name;
  int vertex_order;  ///< of the graph of vertices, before the matrix is made; natural: none
  int order;         ///< of the matrix, permuted at each factorization; natural: none
  /// Factor by which supernodes may grow wider by merging than with CHOLMOD's defaults: the dense
  /// blocks of a sheet are small, and the BLAS is slow for small blocks.
  int wider;
};

constexpr Setting kSettings[] = {
    {"AMD of the matrix", CHOLMOD_NATURAL, CHOLMOD_AMD, 1},
    {"AMD of the vertices", CHOLMOD_AMD, CHOLMOD_NATURAL, 1},
    {"AMD of the vertices, wide supernodes", CHOLMOD_AMD, CHOLMOD_NATURAL, 3},
    {"METIS of the vertices", CHOLMOD_METIS, CHOLMOD_NATURAL, 1},
    {"METIS of the vertices, wide supernodes", CHOLMOD_METIS, CHOLMOD_NATURAL, 3},
};

/// A CHOLMOD workspace of its own.
struct Common : cholmod_common {
  Common() : cholmod_common{} {
    cholmod_start(this);
    print = 0;
    nmethods = 1;
  }
  ~Common() { cholmod_finish(this); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
};

cholmod_sparse view(int size, const std::vector<int>& starts, const std::vector<int>& indices,
                    const double* values) {
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
  a.sorted = a.packed = true;
  return a;
}

/// Returns the block row of every vertex for this elimination order.
std::vector<int> rowsOf(const std::vector<int>& order) {
  std::vector<int> rows(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) rows[order[i]] = static_cast<int>(i);
  return rows;
}

std::vector<int> natural(int count) {
  std::vector<int> rows(count);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

/// Returns the block row of every vertex in CHOLMOD's order of the graph of vertices.
std::vector<int> rowsBy(int vertex_order, const VertexGraph& graph) {
  std::vector<int> order = natural(graph.size());
  if (vertex_order == CHOLMOD_NATURAL) return order;
  Common common;
  common.method[0].ordering = vertex_order;
  cholmod_sparse pattern = view(graph.size(), graph.starts, graph.indices, nullptr);
  cholmod_factor* factor = cholmod_analyze(&pattern, &common);
  if (!factor) throw std::runtime_error("CHOLMOD could not order the vertices");
  const int* permutation = static_cast<const int*>(factor->Perm);
  order.assign(permutation, permutation + graph.size());
  cholmod_free_factor(&factor, &common);
  return rowsOf(order);
}

/// Returns the graph of the shell's vertices, all of which are unknowns.
VertexGraph graphOf(const Shell& shell) {
  VertexGraph graph(shell.vertexCount());
  graph.add({&shell.stencils()}, natural(shell.vertexCount()));
  return graph;
}

/// Returns the matrix of a step from the present positions.
BlockMatrix stepMatrix(const Simulation& simulation, const std::vector<int>& rows) {
  const ShellPotential& potential = simulation.shell();
  const Shell& shell = potential.shell();
  const Positions& x = simulation.positions();
  const auto at = potential.makeIterate();
  Positions gradient = Positions::Zero(3, x.cols());
  potential.start(x, *at);
  potential.addGradient(x, *at, gradient);
  potential.predict(x, x, Positions::Zero(3, x.cols()), *at);
  BlockMatrix matrix(graphOf(shell).renumbered(rows));
  BlockTargets targets;
  targets.find(shell.stencils(), rows, matrix);
  HessianBlocks blocks(matrix, targets);
  potential.addHessian(x, *at, HessianKind::kExact, blocks);
  const double dt = simulation.config().solver.time_step;
  const double beta = 1.1 * 1.1 / 4;
  for (int v = 0; v < shell.vertexCount(); ++v) {
    matrix.addToDiagonal(rows[v], shell.masses()[v] / (beta * dt * dt));
  }
  return matrix;
}

/// Returns medians of repeated calls; `numeric` returns whether it succeeded.
template <class Numeric, class Solve>
FactorTimes timed(Numeric&& numeric, Solve&& solve) {
  std::vector<double> numeric_times(kRepetitions), solve_times(kRepetitions);
  for (int i = 0; i < kRepetitions; ++i) {
    bool positive_definite;
    {
      const Timer timer(numeric_times[i]);
      positive_definite = numeric();
    }
    if (!positive_definite) throw std::runtime_error("the step's matrix is not positive definite");
    const Timer timer(solve_times[i]);
    solve();
  }
  return {median(numeric_times), median(solve_times)};
}

FactorTimes measure(const Setting& setting, const BlockMatrix& matrix) {
  const SerialScope serial;
  Common common;
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.method[0].ordering = setting.order;
  common.postorder = setting.order != CHOLMOD_NATURAL;
  for (std::size_t& columns : common.nrelax) columns *= setting.wider;
  cholmod_sparse a =
      view(matrix.size(), matrix.columnStarts(), matrix.rowIndices(), matrix.values().data());
  cholmod_factor* factor = cholmod_analyze(&a, &common);
  cholmod_dense* b = cholmod_ones(matrix.size(), 1, CHOLMOD_REAL, &common);
  cholmod_dense *x = nullptr, *y = nullptr, *e = nullptr;
  const FactorTimes times =
      timed([&] { return cholmod_factorize(&a, factor, &common) && factor->minor == factor->n; },
            [&] { cholmod_solve2(CHOLMOD_A, factor, b, nullptr, &x, nullptr, &y, &e, &common); });
  for (cholmod_dense* dense : {b, x, y, e}) cholmod_free_dense(&dense, &common);
  cholmod_free_factor(&factor, &common);
  return times;
}

/// Returns the multiplications and additions of a factorization in the matrix's own order.
double flopsOf(const BlockMatrix& matrix) {
  Common common;
  common.method[0].ordering = CHOLMOD_NATURAL;
  common.postorder = false;
  cholmod_sparse a = view(matrix.size(), matrix.columnStarts(), matrix.rowIndices(), nullptr);
  cholmod_factor* factor = cholmod_analyze(&a, &common);
  cholmod_free_factor(&factor, &common);
  return common.fl;
}

void measureOwn(const BlockMatrix& matrix, Limit& limit) {
  Cholesky cholesky;
  cholesky.analyze(matrix);
  Eigen::VectorXd b = Eigen::VectorXd::Ones(matrix.size());
  const auto factorize = [&] { return cholesky.factorize(matrix); };
  const auto solve = [&] { cholesky.solve(b); };
  limit.own = timed(factorize, solve);
  const Allocations before = allocations();
  factorize();
  solve();
  limit.allocations = static_cast<double>((allocations() - before).all);
}

}  // namespace

Limit measureLimit(const Simulation& simulation) {
  const VertexGraph graph = graphOf(simulation.shell().shell());
  Limit limit;
  double least = HUGE_VAL;
  for (const Setting& setting : kSettings) {
    const FactorTimes times =
        measure(setting, stepMatrix(simulation, rowsBy(setting.vertex_order, graph)));
    if (times.numeric + times.solve >= least) continue;
    least = times.numeric + times.solve;
    limit.best = times;
    limit.setting = setting.name;
  }
  const BlockMatrix matrix = stepMatrix(simulation, rowsOf(eliminationOrder(graph)));
  measureOwn(matrix, limit);
  limit.flops = flopsOf(matrix);
  return limit;
}

}  // namespace shell_origami
