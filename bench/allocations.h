/// \file
/// Counts the allocations of the program that this is linked with.
#pragma once

#include <cstdint>

namespace shell_origami {

/// Since the program began.
struct Allocations {
  std::uint64_t all = 0;
  std::uint64_t cholmod = 0;  ///< of those, by CHOLMOD
};

Allocations allocations();
Allocations operator-(const Allocations& a, const Allocations& b);

}  // namespace shell_origami
