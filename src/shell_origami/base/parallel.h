/// \file
/// Work in several threads, whose results do not depend on how many there are.
///
/// Either work is divided by the size of the data alone, and what the chunks give is joined in
/// their order (forEachChunk(), gatherChunks()), or each part computes values of its own as one
/// thread would (forEachPart()). Rounding then is the same with any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace shell_origami {

/// A number of threads to run work in: the calling thread and workers, which are started by the
/// first parallel work. No more take part than there are cores. With one thread there are no
/// workers.
class Threads {
 public:
  /// \param count 0: one for each core
  /// \throws std::invalid_argument if it is negative
  explicit Threads(int count);
  ~Threads();
  Threads(Threads&&) noexcept;
  Threads& operator=(Threads&&) noexcept;

  int count() const { return count_; }

  /// Calls the function and returns what it returns. What it does in parallel uses at most count()
  /// threads. May be nested; the innermost call decides. Throws what the function throws.
  template <class Function>
  auto run(const Function& function) {
    using Result = std::invoke_result_t<const Function&>;
    if constexpr (std::is_void_v<Result>) {
      enter(std::cref(function));
    } else {
      std::optional<Result> result;
      enter([&] { result.emplace(function()); });
      return std::move(*result);
    }
  }

 private:
  struct Arena;
  void enter(const std::function<void()>& function);

  int count_ = 1;
  std::unique_ptr<Arena> arena_;
};

/// A part of a range of indices.
struct Chunk {
  std::size_t index;  ///< of the chunk
  std::size_t begin, end;

  bool contains(std::size_t i) const { return begin <= i && i < end; }
};

/// Returns the number of chunks of `size` that make up a range; the last one may be smaller.
inline std::size_t chunkCount(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
}

/// Returns how many threads share the parallel work that is begun here: 1 outside Threads::run.
int threadCount();

namespace parallel_detail {
void forEachChunk(std::size_t count, std::size_t size,
                  const std::function<void(const Chunk&)>& function);
}  // namespace parallel_detail

/// Calls function(const Chunk&) for the chunks of [0, count), in any order and in several threads
/// inside Threads::run, in their order otherwise. Throws what one of the calls throws; others may
/// not have been made then.
template <class Function>
void forEachChunk(std::size_t count, std::size_t size, const Function& function) {
  parallel_detail::forEachChunk(count, size, std::cref(function));
}

/// Calls function(const Chunk&) for parts that make up [0, count), at the same time inside
/// Threads::run: one for each thread, or fewer where they would be smaller than `smallest`. What
/// the calls compute must not depend on how many there are.
template <class Function>
void forEachPart(std::size_t count, std::size_t smallest, const Function& function) {
  const std::size_t most = std::max<std::size_t>(1, count / smallest);
  const std::size_t parts = std::min<std::size_t>(threadCount(), most);
  forEachChunk(count, std::max<std::size_t>(1, chunkCount(count, parts)), function);
}

/// Calls function(const Chunk&, std::vector<Value>& out) for the chunks of [0, count), as
/// forEachChunk() does, and appends to `all` what each appended to its `out`, in the chunks' order.
template <class Value, class Function>
void gatherChunks(std::size_t count, std::size_t size, std::vector<Value>& all,
                  const Function& function) {
  if (threadCount() == 1) {
    forEachChunk(count, size, [&](const Chunk& chunk) { function(chunk, all); });
    return;
  }
  std::vector<std::vector<Value>> parts(chunkCount(count, size));
  forEachChunk(count, size, [&](const Chunk& chunk) { function(chunk, parts[chunk.index]); });
  std::size_t total = all.size();
  for (const auto& part : parts) total += part.size();
  all.reserve(total);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
}

}  // namespace shell_origami
