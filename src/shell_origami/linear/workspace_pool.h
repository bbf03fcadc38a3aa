/// \file
/// Memory that SuiteSparse asks for again and again, kept in between.
#pragma once

#include <cstddef>
#include <vector>

namespace shell_origami {

/// CHOLMOD asks the heap for its workspace in every factorization and gives it back at the end:
/// large blocks, which the kernel maps and clears each time. SuiteSparse lets a program say where
/// its memory comes from, for the whole process; what is asked for outside of Use, or in another
/// thread, goes where it went before.
class WorkspacePool {
 public:
  WorkspacePool();
  WorkspacePool(const WorkspacePool&) = delete;
  WorkspacePool& operator=(const WorkspacePool&) = delete;
  ~WorkspacePool();

  /// As long as it lives, SuiteSparse's requests in this thread are served from the memory. What
  /// SuiteSparse has not given back by then is its own.
  class Use {
   public:
    explicit Use(WorkspacePool& memory);
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    ~Use();

   private:
    WorkspacePool& memory_;
    WorkspacePool* before_;
  };

 private:
  struct Block {
    void* start;
    std::size_t size;
    bool taken;
  };

  static void install();
  static void* allocate(std::size_t size);
  static void* allocateZeros(std::size_t count, std::size_t size);
  static void* reallocate(void* block, std::size_t size);
  static void release(void* block);

  void* take(std::size_t size);
  std::vector<Block>::iterator find(void* block);

  std::vector<Block> blocks_;
};

}  // namespace shell_origami
