#include <shell_origami/linear/cholesky.h>

#include "bench/allocations.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>
#include <thread>

namespace shell_origami {
namespace {

/// The stencils of a lattice of squares: its triangles, and its squares as hinges.
Stencils latticeStencils(int side) {
  Stencils stencils;
  stencils.restart(1);
  for (int row = 0; row + 1 < side; ++row) {
    for (int i = 0; i + 1 < side; ++i) {
      const int a = row * side + i, b = a + 1, c = a + side, d = c + 1;
      for (const std::array<int, 3>& t : {std::array{a, b, c}, {b, d, c}}) {
        stencils.add(t.data(), 3);
      }
      const std::array<int, 4> hinge{b, c, a, d};
      stencils.add(hinge.data(), 4);
    }
  }
  return stencils;
}

/// Positive semidefinite blocks on a lattice with an identity on the diagonal; every seventh vertex
/// is held.
struct System {
  static constexpr int kSide = 6;
  Stencils stencils = latticeStencils(kSide);
  std::vector<int> unknown;
  int count = 0;
  BlockMatrix matrix;
  BlockTargets targets;
  Eigen::MatrixXd dense;

  System() {
    for (int v = 0; v < kSide * kSide; ++v) unknown.push_back(v % 7 == 0 ? -1 : count++);
    VertexGraph graph(count);
    graph.add({&stencils}, unknown);
    matrix = BlockMatrix(graph);
    EXPECT_TRUE(targets.find(stencils, unknown, matrix));
    fill();
  }

  void fill() {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0, 30);
    dense = Eigen::MatrixXd::Identity(3 * count, 3 * count);
    matrix.setZero();
    for (int i = 0; i < count; ++i) matrix.addToDiagonal(i, 1);
    HessianBlocks blocks(matrix, targets);
    for (int s = 0; s < stencils.count(); ++s) {
      if (stencils.end(s) - stencils.begin(s) == 3) {
        const Eigen::Matrix<double, 9, 9> root =
            Eigen::Matrix<double, 9, 9>::NullaryExpr([&] { return normal(random); });
        const Eigen::Matrix<double, 9, 9> block = root * root.transpose();
        blocks.add(s, block);
        addDense(s, block);
      } else {
        const Eigen::Matrix<double, 12, 1> vector =
            Eigen::Matrix<double, 12, 1>::NullaryExpr([&] { return normal(random); });
        blocks.addRankOne(s, 2.5, vector);
        addDense(s, 2.5 * vector * vector.transpose());
      }
    }
  }

  void addDense(int stencil, const Eigen::MatrixXd& block) {
    const int* vertices = stencils.begin(stencil);
    for (int i = 0; i < block.rows(); ++i) {
      for (int j = 0; j < block.cols(); ++j) {
        const int row = unknown[vertices[i / 3]], column = unknown[vertices[j / 3]];
        if (row >= 0 && column >= 0) dense(3 * row + i % 3, 3 * column + j % 3) += block(i, j);
      }
    }
  }
};

TEST(BlockMatrix, HoldsTheSameEntriesAsADenseAssembly) {
  const System system;
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(system.dense.rows(), system.dense.cols());
  for (int column = 0; column < system.matrix.size(); ++column) {
    for (int k = system.matrix.columnStarts()[column]; k < system.matrix.columnStarts()[column + 1];
         ++k) {
      lower(system.matrix.rowIndices()[k], column) = system.matrix.values()[k];
    }
  }
  const Eigen::MatrixXd difference = (lower - system.dense).triangularView<Eigen::Lower>();
  EXPECT_LT(difference.norm(), 1e-13 * system.dense.norm());
}

TEST(Cholesky, SolvesTheSystem) {
  System system;
  Cholesky cholesky;
  cholesky.analyze(system.matrix);
  ASSERT_TRUE(cholesky.factorize(system.matrix));
  const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(system.matrix.size(), -1, 2);
  Eigen::VectorXd b = system.dense * expected;
  cholesky.solve(b);
  EXPECT_LT((b - expected).norm(), 1e-7 * expected.norm());
}

TEST(EliminationOrder, IsAPermutationThatKeepsTheFactorSparse) {
  constexpr int kSide = 25;
  std::vector<int> unknown(kSide * kSide);
  std::iota(unknown.begin(), unknown.end(), 0);
  const Stencils stencils = latticeStencils(kSide);
  VertexGraph graph(kSide * kSide);
  graph.add({&stencils}, unknown);
  const std::vector<int> order = eliminationOrder(graph);
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, unknown);

  // Entries of the factor, by eliminating the vertices one after the other.
  const auto fill = [&](const std::vector<int>& sequence) {
    std::vector<std::set<int>> above(sequence.size());
    std::vector<int> place(sequence.size());
    for (std::size_t i = 0; i < sequence.size(); ++i) place[sequence[i]] = static_cast<int>(i);
    for (int v = 0; v < graph.size(); ++v) {
      for (int k = graph.starts[v]; k < graph.starts[v + 1]; ++k) {
        const auto [i, j] = std::minmax(place[v], place[graph.indices[k]]);
        above[i].insert(j);
      }
    }
    std::size_t entries = 0;
    for (const std::set<int>& rows : above) {
      entries += rows.size();
      if (rows.empty()) continue;
      above[*rows.begin()].insert(std::next(rows.begin()), rows.end());
    }
    return entries;
  };
  EXPECT_LT(static_cast<double>(fill(order)), 0.7 * static_cast<double>(fill(unknown)));
}

TEST(Cholesky, SaysWhenTheMatrixIsNotPositiveDefinite) {
  System system;
  Cholesky cholesky;
  cholesky.analyze(system.matrix);
  system.matrix.addToDiagonal(4, -1e9);
  EXPECT_FALSE(cholesky.factorize(system.matrix));
  system.fill();
  EXPECT_TRUE(cholesky.factorize(system.matrix));
}

/// A solution by a solver of its own.
Eigen::VectorXd solutionOf(const System& system) {
  Cholesky cholesky;
  cholesky.analyze(system.matrix);
  EXPECT_TRUE(cholesky.factorize(system.matrix));
  Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(system.matrix.size(), -1, 2);
  cholesky.solve(b);
  return b;
}

/// Debian 11's libgomp asks for a team in each of CHOLMOD's parallel regions, which is not counted.
TEST(Cholesky, AsksForNoMemoryAfterItsFirstFactorization) {
  System system;
  const Eigen::VectorXd expected = solutionOf(system);
  Cholesky cholesky;
  cholesky.analyze(system.matrix);
  Eigen::VectorXd b(system.matrix.size());
  std::uint64_t asked = 0;
  for (int i = 0; i < 5; ++i) {
    b.setLinSpaced(-1, 2);
    const Allocations before = allocations();
    ASSERT_TRUE(cholesky.factorize(system.matrix));
    cholesky.solve(b);
    asked = (allocations() - before).cholmod;
    if (i == 0) EXPECT_GT(asked, 0u) << "nothing is counted";
    else EXPECT_EQ(asked, 0u);
    EXPECT_EQ(b, expected);
  }
  // Neither does one that fails, and none is lost by it.
  system.matrix.addToDiagonal(4, -1e9);
  cholesky.factorize(system.matrix);
  system.fill();
  const Allocations before = allocations();
  ASSERT_TRUE(cholesky.factorize(system.matrix));
  EXPECT_EQ((allocations() - before).cholmod, 0u);
}

TEST(Cholesky, SolversInTurnAndInOtherThreadsKeepTheirMemoryApart) {
  System one, other;
  other.matrix.addToDiagonal(4, 3);
  const Eigen::VectorXd expected_one = solutionOf(one), expected_other = solutionOf(other);
  const auto solve_often = [](const System& system, const Eigen::VectorXd& expected, bool& good) {
    Cholesky cholesky;
    for (int i = 0; i < 300; ++i) {
      if (i % 100 == 0) cholesky.analyze(system.matrix);
      Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(system.matrix.size(), -1, 2);
      good = cholesky.factorize(system.matrix) && good;
      cholesky.solve(b);
      good = b == expected && good;
    }
  };
  bool one_good = true, other_good = true;
  solve_often(one, expected_one, one_good);
  solve_often(other, expected_other, other_good);
  EXPECT_TRUE(one_good && other_good) << "in turn";
  std::thread thread([&] { solve_often(one, expected_one, one_good); });
  thread.join();
  EXPECT_TRUE(one_good) << "in another thread";
  std::thread second([&] { solve_often(one, expected_one, one_good); });
  solve_often(other, expected_other, other_good);
  second.join();
  EXPECT_TRUE(one_good && other_good) << "in two threads at once";
}

}  // namespace
}  // namespace shell_origami
