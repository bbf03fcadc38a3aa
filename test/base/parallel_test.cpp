#include <shell_origami/base/parallel.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace shell_origami {
namespace {

/// The sum of square roots, chunk by chunk.
double sumOfRoots(std::size_t count) {
  constexpr std::size_t kChunk = 7;
  std::vector<double> sums(chunkCount(count, kChunk), 0.);
  forEachChunk(count, kChunk, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) sums[chunk.index] += std::sqrt(i);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.);
}

TEST(Parallel, ChunksCoverTheRangeOnce) {
  for (const int count : {1, 2, 3}) {
    Threads threads(count);
    for (const std::size_t size : {0, 1, 6, 7, 8, 1000}) {
      std::vector<int> calls(size, 0);
      threads.run([&] {
        forEachChunk(size, 7, [&](const Chunk& chunk) {
          EXPECT_EQ(chunk.begin, 7 * chunk.index);
          EXPECT_LE(chunk.end, size);
          for (std::size_t i = chunk.begin; i < chunk.end; ++i) ++calls[i];
        });
      });
      EXPECT_EQ(calls, std::vector<int>(size, 1)) << size << " in " << count << " threads";
    }
  }
}

TEST(Parallel, SumsAreTheSameWithAnyNumberOfThreads) {
  const double outside = sumOfRoots(10000);
  for (const int count : {1, 2, 3}) {
    double inside = 0;
    Threads(count).run([&] { inside = sumOfRoots(10000); });
    EXPECT_EQ(inside, outside) << count;
  }
}

TEST(Parallel, GatheredValuesAreInOrder) {
  for (const int count : {1, 2, 3}) {
    std::vector<std::size_t> odd{1000};
    Threads(count).run([&] {
      gatherChunks(100, 7, odd, [](const Chunk& chunk, std::vector<std::size_t>& out) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
          if (i % 2 == 1) out.push_back(i);
        }
      });
    });
    ASSERT_EQ(odd.size(), 51u) << "what was there stays";
    for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(odd[i + 1], 2 * i + 1);
  }
}

TEST(Parallel, RunReturnsWhatTheFunctionReturns) {
  EXPECT_EQ(Threads(1).run([] { return threadCount(); }), 1);
  if (std::thread::hardware_concurrency() > 1) {
    EXPECT_EQ(Threads(2).run([] { return threadCount(); }), 2);
  }
  EXPECT_EQ(threadCount(), 1);
}

/// Two chunks, each of which waits for the other where there is a second core: they end only in two
/// threads.
TEST(Parallel, ChunksRunAtTheSameTime) {
  Threads threads(2);
  std::atomic<int> arrived{0};
  threads.run([&] {
    forEachChunk(2, 1, [&](const Chunk&) {
      ++arrived;
      while (arrived < threads.count()) std::this_thread::yield();
    });
  });
  EXPECT_EQ(arrived, 2);
}

TEST(Parallel, ParallelWorkInAWorkerIsParallelToo) {
  std::atomic<int> calls{0};
  const auto nested = [&] { forEachChunk(100, 1, [&](const Chunk&) { ++calls; }); };
  Threads(2).run([&] { forEachChunk(2, 1, [&](const Chunk&) { nested(); }); });
  EXPECT_EQ(calls, 200);
}

TEST(Parallel, OneThreadIsTheCallingOne) {
  const auto here = std::this_thread::get_id();
  const auto check = [&] {
    std::set<std::size_t> order;
    forEachChunk(100, 3, [&](const Chunk& chunk) {
      EXPECT_EQ(std::this_thread::get_id(), here);
      EXPECT_EQ(chunk.index, order.size());
      order.insert(chunk.index);
    });
  };
  check();
  Threads(1).run(check);
  Threads(2).run([&] { Threads(1).run(check); });
}

TEST(Parallel, ExceptionsPropagate) {
  for (const int count : {1, 2}) {
    Threads threads(count);
    EXPECT_THROW(threads.run([] {
      forEachChunk(100, 1, [](const Chunk& chunk) {
        if (chunk.index == 50) throw std::runtime_error("the fifty-first");
      });
    }),
                 std::runtime_error);
    double sum = 0;
    threads.run([&] { sum = sumOfRoots(100); });
    EXPECT_EQ(sum, sumOfRoots(100)) << "works again";
  }
}

TEST(Parallel, ZeroThreadsAreAllCores) {
  EXPECT_GE(Threads(0).count(), 1);
  EXPECT_EQ(Threads(0).count(), Threads(1000).count());
}

TEST(Parallel, RejectsANegativeNumberOfThreads) {
  EXPECT_THROW(Threads(-1), std::invalid_argument);
}

}  // namespace
}  // namespace shell_origami
