#include <shell_origami/linear/workspace_pool.h>

#include <SuiteSparse_config.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <utility>

namespace shell_origami {
namespace {

thread_local WorkspacePool* in_use = nullptr;

/// Where SuiteSparse's memory comes from otherwise.
SuiteSparse_config_struct plain;

}  // namespace

WorkspacePool::WorkspacePool() {
  static std::once_flag installed;
  std::call_once(installed, install);
}

WorkspacePool::~WorkspacePool() {
  for (const Block& block : blocks_) plain.free_func(block.start);
}

void WorkspacePool::install() {
  plain = SuiteSparse_config;
  SuiteSparse_config.malloc_func = allocate;
  SuiteSparse_config.calloc_func = allocateZeros;
  SuiteSparse_config.realloc_func = reallocate;
  SuiteSparse_config.free_func = release;
}

WorkspacePool::Use::Use(WorkspacePool& memory)
    : memory_(memory), before_(std::exchange(in_use, &memory)) {}

WorkspacePool::Use::~Use() {
  in_use = before_;
  auto& blocks = memory_.blocks_;
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), [](const Block& b) { return b.taken; }),
               blocks.end());
}

void* WorkspacePool::allocate(std::size_t size) {
  return in_use ? in_use->take(size) : plain.malloc_func(size);
}

void* WorkspacePool::allocateZeros(std::size_t count, std::size_t size) {
  if (!in_use) return plain.calloc_func(count, size);
  void* block = in_use->take(count * size);  // SuiteSparse has looked for an overflow
  if (block) std::memset(block, 0, count * size);
  return block;
}

void* WorkspacePool::reallocate(void* block, std::size_t size) {
  if (in_use) {
    const auto known = in_use->find(block);
    if (known != in_use->blocks_.end()) in_use->blocks_.erase(known);
  }
  return plain.realloc_func(block, size);
}

void WorkspacePool::release(void* block) {
  if (in_use) {
    const auto known = in_use->find(block);
    if (known != in_use->blocks_.end()) {
      known->taken = false;
      return;
    }
  }
  plain.free_func(block);
}

/// The smallest block that will do, or a new one.
void* WorkspacePool::take(std::size_t size) {
  auto best = blocks_.end();
  for (auto block = blocks_.begin(); block != blocks_.end(); ++block) {
    if (block->taken || block->size < size) continue;
    if (best == blocks_.end() || block->size < best->size) best = block;
  }
  if (best == blocks_.end()) {
    void* start = plain.malloc_func(size);
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
