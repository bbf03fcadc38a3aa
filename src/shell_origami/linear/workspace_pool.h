/// \file
/// Memory that SuiteSparse asks for again and again, kept in between.
#pragma once

#include <cstddef>
#include <vector>

namespace shell_origami {

/// CHOLMOD allocates its workspace in every factorization and frees it at the end: large blocks,
/// which the kernel maps and clears each time. A pool keeps them from one factorization to the
/// next.
///
/// SuiteSparse takes its memory through functions that belong to the whole process. They are
/// replaced only while a Use lives and are put back after the last one; until then the requests of
/// other threads go to the functions that were there before.
class WorkspacePool {
 public:
  WorkspacePool() = default;
  WorkspacePool(const WorkspacePool&) = delete;
  WorkspacePool& operator=(const WorkspacePool&) = delete;
  ~WorkspacePool();

  /// As long as it lives, SuiteSparse's requests in this thread are served from the pool. Blocks
  /// that SuiteSparse has not freed by then belong to SuiteSparse.
  class Use {
   public:
    explicit Use(WorkspacePool& pool);
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    ~Use();

   private:
    WorkspacePool& pool_;
    WorkspacePool* before_;
  };

 private:
  struct Block {
    void* start;
    std::size_t size;
    bool taken;
  };

  static void* allocate(std::size_t size);
  static void* allocateZeros(std::size_t count, std::size_t size);
  static void* reallocate(void* block, std::size_t size);
  static void release(void* block);

  void* take(std::size_t size);
  std::vector<Block>::iterator find(void* block);

  std::vector<Block> blocks_;
};

}  // namespace shell_origami
