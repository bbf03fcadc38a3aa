#include <shell_origami/node/view.h>

namespace shell_origami {
namespace {

/// Over the size of the sheet. Patterns fold to a part of their size.
constexpr double kDistance = 2.6, kPatternDistance = 1.8;
constexpr double kSlack = 0.2;

}  // namespace

View viewOf(const Recipe* recipe, double sheet_size) {
  if (recipe && recipe->states("view")) return recipe->view;
  View view;
  const bool pattern = recipe && !recipe->sheet.pattern.empty();
  view.distance = (pattern ? kPatternDistance : kDistance) * sheet_size;
  return view;
}

bool same(const View& a, const View& b) {
  return a.yaw == b.yaw && a.pitch == b.pitch && a.distance == b.distance;
}

const Vector3& CameraTarget::follow(const Positions& positions, double size) {
  const Vector3 middle = (positions.rowwise().minCoeff() + positions.rowwise().maxCoeff()) / 2;
  if (!target_) target_ = middle;
  const Vector3 way = middle - *target_;
  const double beyond = way.norm() - kSlack * size;
  if (beyond > 0) *target_ += beyond * way.normalized();
  return *target_;
}

}  // namespace shell_origami
