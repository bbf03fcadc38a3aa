#include <shell_origami/node/pace.h>

#include <shell_origami/node/time_arithmetic.h>

#include <cmath>

namespace shell_origami {

bool Pace::due(const ros::Time& stamp, double rate, double slack) const {
  const double early = secondsBetween(stamp, next_);
  return early < slack || early > 2 / rate;
}

void Pace::done(const ros::Time& stamp, double rate) {
  const double period = 1 / rate;
  next_ = later(next_, period);
  if (std::abs(secondsBetween(stamp, next_) - period) > period) next_ = later(stamp, period);
}

}  // namespace shell_origami
