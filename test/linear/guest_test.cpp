/// The solver is a guest in its process: what it changes there it puts back.
#include <shell_origami/linear/cholesky.h>
#include <shell_origami/linear/stencil_system.h>
#include <shell_origami/linear/suitesparse_memory.h>

#include <gtest/gtest.h>
#include <omp.h>

#include <array>
#include <cstdlib>
#include <vector>

namespace shell_origami {
namespace {

/// A chain of springs between neighbors, and what is added to it.
Stencils chain(int count, std::uint64_t revision,
               const std::vector<std::array<int, 2>>& more = {}) {
  Stencils stencils;
  stencils.restart(revision);
  for (int i = 0; i + 1 < count; ++i) {
    const std::array<int, 2> pair{i, i + 1};
    stencils.add(pair.data(), 2);
  }
  for (const std::array<int, 2>& pair : more) stencils.add(pair.data(), 2);
  return stencils;
}

/// Adds block 2 I, -I, -I, 2 I of every stencil and the identity, and returns the solution for
/// ones.
Positions solve(StencilSystem& system, const Stencils& stencils, int count) {
  EXPECT_TRUE(system.prepare({&stencils}));
  system.setZero();
  HessianBlocks blocks = system.blocks(0);
  Eigen::Matrix<double, 6, 6> block = 2 * Eigen::Matrix<double, 6, 6>::Identity();
  block.topRightCorner<3, 3>() = block.bottomLeftCorner<3, 3>() = -Eigen::Matrix3d::Identity();
  for (int i = 0; i < stencils.count(); ++i) blocks.add(i, block);
  system.addToDiagonal(1, Eigen::VectorXd::Ones(count));
  EXPECT_TRUE(system.factorize());
  Positions step = Positions::Zero(3, count);
  EXPECT_TRUE(system.solve(Positions::Ones(3, count), step));
  return step;
}

TEST(Guest, OpenMpIsAsItWas) {
  omp_set_max_active_levels(3);
  StencilSystem system;
  system.setFree(std::vector<bool>(8, true));
  solve(system, chain(8, 1), 8);
  EXPECT_EQ(omp_get_max_active_levels(), 3);
  int threads = 0;
#pragma omp parallel num_threads(2) reduction(+ : threads)
  threads += 1;
  EXPECT_EQ(threads, 2) << "the process cannot open a parallel region any more";
}

TEST(Guest, SuiteSparsesMemoryIsAsItWas) {
  const SuiteSparseMemory before = suiteSparseMemory();
  {
    StencilSystem system;
    system.setFree(std::vector<bool>(8, true));
    solve(system, chain(8, 1), 8);
    EXPECT_EQ(suiteSparseMemory().allocate, before.allocate);
    EXPECT_EQ(suiteSparseMemory().release, before.release);
  }
  EXPECT_EQ(suiteSparseMemory().allocate_zeros, before.allocate_zeros);
  EXPECT_EQ(suiteSparseMemory().reallocate, before.reallocate);
}

TEST(StencilSystem, GrowsWhereAStencilIsNotCovered) {
  constexpr int kCount = 12;
  StencilSystem grown, fresh;
  grown.setFree(std::vector<bool>(kCount, true));
  solve(grown, chain(kCount, 1), kCount);
  EXPECT_EQ(grown.analyses(), 1);
  const Stencils more = chain(kCount, 2, {{0, 11}, {2, 9}});
  const Positions answer = solve(grown, more, kCount);
  EXPECT_EQ(grown.analyses(), 2);
  fresh.setFree(std::vector<bool>(kCount, true));
  EXPECT_LT((answer - solve(fresh, more, kCount)).norm(), 1e-14);
  solve(grown, chain(kCount, 3), kCount);
  solve(grown, chain(kCount, 4, {{2, 9}}), kCount);
  EXPECT_EQ(grown.analyses(), 2) << "these are covered";
}

void* nothing(std::size_t) { return nullptr; }
void* noZeros(std::size_t, std::size_t) { return nullptr; }

TEST(StencilSystem, SaysWhenTheMemoryIsShortAndWorksLater) {
  constexpr int kCount = 12;
  StencilSystem system;
  system.setFree(std::vector<bool>(kCount, true));
  const Stencils stencils = chain(kCount, 1);
  const SuiteSparseMemory before = suiteSparseMemory();
  SuiteSparseMemory none = before;
  none.allocate = nothing;
  none.allocate_zeros = noZeros;
  setSuiteSparseMemory(none);
  EXPECT_FALSE(system.prepare({&stencils}));
  setSuiteSparseMemory(before);
  EXPECT_TRUE(solve(system, stencils, kCount).allFinite());
}

}  // namespace
}  // namespace shell_origami
