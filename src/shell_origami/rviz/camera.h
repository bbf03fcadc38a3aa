/// \file
/// Between points in space and pixels of a view.
#pragma once

#include <shell_origami/rviz/ray_caster.h>

#include <Eigen/Geometry>

namespace shell_origami {

/// A view of the world, with perspective or without.
class Camera {
 public:
  /// \param to_clip  from the world to the view's cube, from -1 to 1 along each axis, x to the
  ///                 right, y up, z away from the eye
  /// \param size     of the view [pixel]
  Camera(const Eigen::Matrix4d& to_clip, const Vector2& size);

  /// Returns the ray through a pixel, x to the right and y down from the view's upper left corner.
  Ray ray(const Vector2& pixel) const;
  /// Returns the pixel of a point; of one behind the eye a pixel that is far off.
  Vector2 pixel(const Vector3& point) const;

 private:
  Eigen::Matrix4d to_clip_, from_clip_;
  Vector2 size_;
};

}  // namespace shell_origami
