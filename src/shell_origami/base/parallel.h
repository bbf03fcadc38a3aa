/// \file
/// Work in several threads, whose results do not depend on how many there are.
///
/// Work is divided by the size of the data alone. Each part writes to a place of its own, and sums
/// are joined in the order of the parts. Rounding then is the same with any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace shell_origami {

/// A number of threads to run work in: the calling thread and workers, which are started by the
/// first parallel work. No more take part than there are cores. With one thread there are no
/// workers.
class Threads {
 public:
  /// \throws std::invalid_argument if count is less than 1
  explicit Threads(int count);
  ~Threads();
  Threads(Threads&&) noexcept;
  Threads& operator=(Threads&&) noexcept;

  int count() const { return count_; }

  /// Calls the function. What it does in parallel uses at most count() threads. May be nested; the
  /// innermost call decides. Throws what the function throws.
  template <class Function>
  void run(const Function& function) {
    enter(std::cref(function));
  }

 private:
  struct Arena;
  void enter(const std::function<void()>& function);

  int count_;
  std::unique_ptr<Arena> arena_;
};

/// A part of a range of indices.
struct Chunk {
  std::size_t index;  ///< of the chunk
  std::size_t begin, end;
};

/// Returns the number of chunks of `size` that make up a range; the last one may be smaller.
inline std::size_t chunkCount(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
}

namespace parallel_detail {
void forEachChunk(std::size_t count, std::size_t size,
                  const std::function<void(const Chunk&)>& function);
void invoke(const std::function<void()>& first, const std::function<void()>& second);
}  // namespace parallel_detail

/// Calls function(const Chunk&) for the chunks of [0, count), in any order and in several threads
/// inside Threads::run, in their order otherwise. Throws what one of the calls throws; others may
/// not have been made then.
template <class Function>
void forEachChunk(std::size_t count, std::size_t size, const Function& function) {
  parallel_detail::forEachChunk(count, size, std::cref(function));
}

/// Calls both functions, at the same time inside Threads::run, first the first otherwise. Throws
/// what one of them throws; the other may not have been called then.
template <class First, class Second>
void parallelInvoke(const First& first, const Second& second) {
  parallel_detail::invoke(std::cref(first), std::cref(second));
}

}  // namespace shell_origami
