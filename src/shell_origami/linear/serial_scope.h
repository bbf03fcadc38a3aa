/// \file
/// CHOLMOD in one thread.
#pragma once

#include <omp.h>

namespace shell_origami {

/// Keeps OpenMP from opening parallel regions in this thread as long as it lives. Debian's CHOLMOD
/// opens one in its inner loop whatever OMP_NUM_THREADS says, at four times the cost of the
/// factorization.
class SerialScope {
 public:
  SerialScope() : before_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  SerialScope(const SerialScope&) = delete;
  SerialScope& operator=(const SerialScope&) = delete;
  ~SerialScope() { omp_set_max_active_levels(before_); }

 private:
  int before_;
};

}  // namespace shell_origami
