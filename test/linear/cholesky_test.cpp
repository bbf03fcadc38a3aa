#include <shell_origami/linear/cholesky.h>

#include <shell_origami/mesh/triangulate.h>
#include "bench/allocations.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <thread>

namespace shell_origami {
namespace {

/// A sheet's Hessian with inertia on its diagonal; every seventh vertex is held.
template <int Size>
Eigen::MatrixXd whole(const Eigen::Matrix<double, Size, Size>& block) {
  return block;
}
Eigen::MatrixXd whole(const RankOne& block) {
  return block.factor * block.vector * block.vector.transpose();
}

struct System {
  Sheet sheet{triangulateRectangle(0.1, 0.1, 0.02)};
  Shell shell{sheet, {}, Vector3::Zero()};
  std::vector<int> unknown;
  int count = 0;
  Positions x = Positions::Zero(3, sheet.vertexCount());
  BlockMatrix matrix;
  Eigen::MatrixXd dense;

  System() {
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      unknown.push_back(v % 7 == 0 ? -1 : count++);
      x.col(v).head<2>() = sheet.flatPositions()[v];
    }
    matrix = BlockMatrix(shell, unknown, count);
    fill();
  }

  void fill() {
    std::vector<FoldAngle> angles;
    std::vector<HingeGradient> angle_gradients;
    std::vector<MembraneStrain> strains;
    shell.foldAngles(x, angles);
    shell.angleGradients(x, angle_gradients);
    shell.strains(x, strains);
    dense = Eigen::MatrixXd::Identity(3 * count, 3 * count);
    matrix.setZero();
    for (int i = 0; i < count; ++i) matrix.addToDiagonal(i, 1);
    const int triangles = static_cast<int>(shell.triangles().size());
    shell.forEachHessian(
        x, angles, angle_gradients, strains, HessianKind::kGaussNewton,
        [&](int stencil, const auto& given) {
          matrix.add(stencil, given);
          const Eigen::MatrixXd block = whole(given);
          const int* corners = stencil < triangles
                                   ? shell.triangles()[stencil].data()
                                   : shell.hinges()[stencil - triangles].vertices.data();
          for (int i = 0; i < block.rows(); ++i) {
            for (int j = 0; j < block.cols(); ++j) {
              const int row = unknown[corners[i / 3]], column = unknown[corners[j / 3]];
              if (row >= 0 && column >= 0)
                dense(3 * row + i % 3, 3 * column + j % 3) += block(i, j);
            }
          }
        });
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
  const Sheet sheet(triangulateRectangle(0.1, 0.1, 0.005));
  const Shell shell(sheet, {}, Vector3::Zero());
  std::vector<int> unknown(sheet.vertexCount());
  std::iota(unknown.begin(), unknown.end(), 0);
  const VertexGraph graph(shell, unknown, sheet.vertexCount());
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
}

}  // namespace
}  // namespace shell_origami
