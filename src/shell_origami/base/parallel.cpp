#include <shell_origami/base/parallel.h>

#include <shell_origami/base/error.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

namespace shell_origami {
namespace {

/// Whether this thread works in an arena of Threads. Elsewhere TBB would take all cores.
thread_local bool in_arena = false;

/// Says so as long as it lives.
class ArenaScope {
 public:
  explicit ArenaScope(bool inside) : before_(in_arena) { in_arena = inside; }
  ~ArenaScope() { in_arena = before_; }
  ArenaScope(const ArenaScope&) = delete;
  ArenaScope& operator=(const ArenaScope&) = delete;

 private:
  bool before_;
};

}  // namespace

struct Threads::Arena {
  explicit Arena(int count) : arena(count) {}
  tbb::task_arena arena;
};

Threads::Threads(int count) {
  if (count < 0) reject("the number of threads must be at least 0, not ", count);
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  count_ = count == 0 ? cores : std::min(count, cores);  // TBB warns of each arena with more
  if (count_ > 1) arena_ = std::make_unique<Arena>(count_);
}

Threads::~Threads() = default;
Threads::Threads(Threads&&) noexcept = default;
Threads& Threads::operator=(Threads&&) noexcept = default;

void Threads::enter(const std::function<void()>& function) {
  if (!arena_) {
    const ArenaScope scope(false);
    function();
    return;
  }
  arena_->arena.execute([&] {
    const ArenaScope scope(true);
    function();
  });
}

int threadCount() { return in_arena ? tbb::this_task_arena::max_concurrency() : 1; }

void parallel_detail::forEachChunk(std::size_t count, std::size_t size,
                                   const std::function<void(const Chunk&)>& function) {
  const auto call = [&](std::size_t index) {
    function({index, index * size, std::min((index + 1) * size, count)});
  };
  const std::size_t chunks = chunkCount(count, size);
  if (!in_arena || chunks < 2) {
    for (std::size_t index = 0; index < chunks; ++index) call(index);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, chunks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        const ArenaScope scope(true);
        for (std::size_t index = range.begin(); index < range.end(); ++index) call(index);
      },
      tbb::simple_partitioner());
}

}  // namespace shell_origami
