#include "bench/allocations.h"

#include <shell_origami/linear/suitesparse_memory.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

// Of all threads.
std::atomic<std::size_t> heap_calls{0}, cholmod_calls{0};

}  // namespace

#if defined(__SANITIZE_ADDRESS__)

// The address sanitizer's malloc, which must stay, calls this.
extern "C" void __sanitizer_malloc_hook(const volatile void*, std::size_t) { ++heap_calls; }

#else

// Defined in the program, these replace glibc's functions in every library; free() stays glibc's.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++heap_calls;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  ++heap_calls;
  return __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) {
  ++heap_calls;
  return __libc_realloc(block, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++heap_calls;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  ++heap_calls;
  *block = __libc_memalign(alignment, size);
  return *block ? 0 : ENOMEM;
}

}  // extern "C"

#endif

namespace shell_origami {
namespace {

/// SuiteSparse allocates through its own function pointers, which count CHOLMOD's calls apart.
const bool installed = [] {
  SuiteSparseMemory memory = suiteSparseMemory();
  memory.allocate = [](std::size_t size) {
    ++cholmod_calls;
    return malloc(size);
  };
  memory.allocate_zeros = [](std::size_t count, std::size_t size) {
    ++cholmod_calls;
    return calloc(count, size);
  };
  memory.reallocate = [](void* block, std::size_t size) {
    ++cholmod_calls;
    return realloc(block, size);
  };
  setSuiteSparseMemory(memory);
  return true;
}();

}  // namespace

Allocations allocations() { return {heap_calls, cholmod_calls}; }

Allocations operator-(const Allocations& a, const Allocations& b) {
  return {a.all - b.all, a.cholmod - b.cholmod};
}

}  // namespace shell_origami
