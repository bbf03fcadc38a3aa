#include <shell_origami/node/time_arithmetic.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace shell_origami {
namespace {

constexpr std::int64_t kNanoseconds = 1000000000;                               ///< of a second
constexpr double kLongestDuration = std::numeric_limits<std::uint32_t>::max();  ///< [s]

}  // namespace

double secondsBetween(const ros::Time& from, const ros::Time& to) {
  const std::int64_t seconds = std::int64_t{to.sec} - from.sec;
  const std::int64_t nanoseconds = std::int64_t{to.nsec} - from.nsec;
  return static_cast<double>(seconds) + 1e-9 * static_cast<double>(nanoseconds);
}

ros::Time later(const ros::Time& time, double seconds) {
  const double wanted = std::clamp(seconds, -kLongestDuration, kLongestDuration);
  const double whole = std::floor(wanted);
  const std::int64_t nanoseconds =
      (static_cast<std::int64_t>(whole) + time.sec) * kNanoseconds + time.nsec +
      std::llround((wanted - whole) * static_cast<double>(kNanoseconds));
  const auto first = std::int64_t{0};
  const auto last = static_cast<std::int64_t>(ros::TIME_MAX.toNSec());
  ros::Time result;
  return result.fromNSec(static_cast<std::uint64_t>(std::clamp(nanoseconds, first, last)));
}

}  // namespace shell_origami
