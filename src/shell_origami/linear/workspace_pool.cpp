#include <shell_origami/linear/workspace_pool.h>

#include <shell_origami/linear/suitesparse_memory.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <utility>

namespace shell_origami {
namespace {

thread_local WorkspacePool* in_use = nullptr;

std::mutex uses_mutex;
int uses = 0;              ///< that live, in all threads
SuiteSparseMemory before;  ///< the functions that the first of them replaced

}  // namespace

WorkspacePool::~WorkspacePool() {
  const std::lock_guard<std::mutex> lock(uses_mutex);
  const auto release = uses > 0 ? before.release : suiteSparseMemory().release;
  for (const Block& block : blocks_) release(block.start);
}

WorkspacePool::Use::Use(WorkspacePool& pool) : pool_(pool), before_(std::exchange(in_use, &pool)) {
  const std::lock_guard<std::mutex> lock(uses_mutex);
  if (uses++ > 0) return;
  before = suiteSparseMemory();
  setSuiteSparseMemory({allocate, allocateZeros, reallocate, WorkspacePool::release});
}

WorkspacePool::Use::~Use() {
  in_use = before_;
  auto& blocks = pool_.blocks_;
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), [](const Block& b) { return b.taken; }),
               blocks.end());
  const std::lock_guard<std::mutex> lock(uses_mutex);
  if (--uses == 0) setSuiteSparseMemory(before);
}

void* WorkspacePool::allocate(std::size_t size) {
  return in_use ? in_use->take(size) : before.allocate(size);
}

void* WorkspacePool::allocateZeros(std::size_t count, std::size_t size) {
  if (!in_use) return before.allocate_zeros(count, size);
  void* block = in_use->take(count * size);  // SuiteSparse has looked for an overflow
  if (block) std::memset(block, 0, count * size);
  return block;
}

void* WorkspacePool::reallocate(void* block, std::size_t size) {
  if (in_use) {
    const auto known = in_use->find(block);
    if (known != in_use->blocks_.end()) in_use->blocks_.erase(known);
  }
  return before.reallocate(block, size);
}

void WorkspacePool::release(void* block) {
  if (in_use) {
    const auto known = in_use->find(block);
    if (known != in_use->blocks_.end()) {
      known->taken = false;
      return;
    }
  }
  before.release(block);
}

/// The smallest block that will do, or a new one.
void* WorkspacePool::take(std::size_t size) {
  auto best = blocks_.end();
  for (auto block = blocks_.begin(); block != blocks_.end(); ++block) {
    if (block->taken || block->size < size) continue;
    if (best == blocks_.end() || block->size < best->size) best = block;
  }
  if (best == blocks_.end()) {
    void* start = before.allocate(size);
    if (!start) return nullptr;
    best = blocks_.insert(blocks_.end(), {start, size, false});
  }
  best->taken = true;
  return best->start;
}

std::vector<WorkspacePool::Block>::iterator WorkspacePool::find(void* block) {
  return std::find_if(blocks_.begin(), blocks_.end(),
                      [block](const Block& known) { return known.start == block; });
}

}  // namespace shell_origami
