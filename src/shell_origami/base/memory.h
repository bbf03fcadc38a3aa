/// \file
/// Available memory.
#pragma once

namespace shell_origami {

/// Returns the memory that the program can still take [bytes]: what the system has available, or
/// what is left of the limit on the program's address space (ulimit -v) where that is less.
/// Infinite where neither is known.
double availableMemory();

}  // namespace shell_origami
