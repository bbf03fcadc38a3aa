#include <shell_origami/origami/fold_ramp.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {

double FoldRamp::angleAt(double t) const {
  if (!runningAt(t)) return target + set;
  const double s = std::max(0.0, (t - start) / duration);
  const double smooth = s * s * (3 - 2 * s);
  const double begin = std::tan(lead_from / 2), end = std::tan(lead_target / 2);
  if (begin == end) return from + (target - from) * smooth;
  const double lead = std::tan((lead_from + (lead_target - lead_from) * smooth) / 2);
  const double part = (lead - begin) / (end - begin);
  return 2 * std::atan((1 - part) * std::tan(from / 2) + part * std::tan(target / 2));
}

double FoldRamp::way() const { return std::abs(std::tan(target / 2) - std::tan(from / 2)); }

bool FoldRamp::folds() const { return std::abs(target) >= std::abs(from); }

}  // namespace shell_origami
