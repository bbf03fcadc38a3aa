/// \file
/// The functions from which SuiteSparse takes its memory, which belong to the whole process.
#pragma once

#include <SuiteSparse_config.h>

#include <cstddef>

namespace shell_origami {

struct SuiteSparseMemory {
  void* (*allocate)(std::size_t size);
  void* (*allocate_zeros)(std::size_t count, std::size_t size);
  void* (*reallocate)(void* block, std::size_t size);
  void (*release)(void* block);
};

// From version 6 on the configuration is hidden behind functions.
#if SUITESPARSE_MAIN_VERSION >= 6

inline SuiteSparseMemory suiteSparseMemory() {
  return {SuiteSparse_config_malloc_func_get(), SuiteSparse_config_calloc_func_get(),
          SuiteSparse_config_realloc_func_get(), SuiteSparse_config_free_func_get()};
}

inline void setSuiteSparseMemory(const SuiteSparseMemory& memory) {
  SuiteSparse_config_malloc_func_set(memory.allocate);
  SuiteSparse_config_calloc_func_set(memory.allocate_zeros);
  SuiteSparse_config_realloc_func_set(memory.reallocate);
  SuiteSparse_config_free_func_set(memory.release);
}

#else

inline SuiteSparseMemory suiteSparseMemory() {
  return {SuiteSparse_config.malloc_func, SuiteSparse_config.calloc_func,
          SuiteSparse_config.realloc_func, SuiteSparse_config.free_func};
}

inline void setSuiteSparseMemory(const SuiteSparseMemory& memory) {
  SuiteSparse_config.malloc_func = memory.allocate;
  SuiteSparse_config.calloc_func = memory.allocate_zeros;
  SuiteSparse_config.realloc_func = memory.reallocate;
  SuiteSparse_config.free_func = memory.release;
}

#endif

}  // namespace shell_origami
