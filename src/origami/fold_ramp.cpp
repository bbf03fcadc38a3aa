#include "origami/fold_ramp.h"

#include <algorithm>

namespace shell_origami {

double FoldRamp::angleAt(double t) const {
  if (!runningAt(t)) return target;
  const double s = std::max(0.0, (t - start) / duration);
  return from + (target - from) * s * s * (3 - 2 * s);
}

}  // namespace shell_origami
