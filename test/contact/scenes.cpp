#include "test/contact/scenes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shell_origami {

Positions pleated(const Sheet& sheet, double pitch, double gap) {
  Positions x(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& flat = sheet.flatPositions()[v];
    // What lies on a fold belongs to the layer before.
    const double layer = std::max(0.0, std::ceil(flat.x() / pitch - 1e-9) - 1);
    const double along = flat.x() - layer * pitch;
    const bool back = std::fmod(layer, 2) != 0;
    x.col(v) << (back ? pitch - along : along), flat.y(), layer * gap;
  }
  return x;
}

Positions shaken(const Positions& x, double amount, Random& random) {
  Positions moved = x;
  for (int v = 0; v < x.cols(); ++v) moved(2, v) += random.between(-amount, amount);
  return moved;
}

Positions turned(const Positions& x, Random& random) {
  const Eigen::Matrix3d rotation = random.rotation();
  const Vector3 place = random.inCube(1);
  return (rotation * x).colwise() + place;
}

Positions folded(const Sheet& sheet, int folds, Random& random) {
  Positions x = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) x.col(v).head<2>() = sheet.flatPositions()[v];
  for (int i = 0; i < folds; ++i) {
    const Vector3 on_line = x.col(random.below(sheet.vertexCount()));
    const Vector3 side = random.direction(), axis = side.cross(random.direction()).normalized();
    const Eigen::AngleAxisd fold(random.between(-M_PI, M_PI), axis);
    for (int v = 0; v < x.cols(); ++v) {
      const Vector3 arm = x.col(v) - on_line;
      if (arm.dot(side) > 0) x.col(v) = on_line + fold * arm;
    }
  }
  return x;
}

}  // namespace shell_origami
