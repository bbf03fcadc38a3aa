#include <shell_origami/base/memory.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace shell_origami {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double systemMemory() {
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    double kilobytes = 0;
    if (word == "MemAvailable:" && file >> kilobytes) return 1024 * kilobytes;
  }
  return kInfinite;
}

double addressSpaceLeft() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kInfinite;
  double pages = 0;  // of the program's whole address space
  std::ifstream("/proc/self/statm") >> pages;
  const double used = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

}  // namespace

double availableMemory() { return std::min(systemMemory(), addressSpaceLeft()); }

}  // namespace shell_origami
