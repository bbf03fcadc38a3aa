#include <shell_origami/rviz/camera.h>

#include <Eigen/LU>

namespace shell_origami {
namespace {

/// Where points behind the eye are said to be [pixel].
constexpr double kFarOff = 1e9;

}  // namespace

Camera::Camera(const Eigen::Matrix4d& to_clip, const Vector2& size)
    : to_clip_(to_clip), from_clip_(to_clip.inverse()), size_(size) {}

Ray Camera::ray(const Vector2& pixel) const {
  const Vector2 at(2 * pixel.x() / size_.x() - 1, 1 - 2 * pixel.y() / size_.y());
  const auto unproject = [&](double depth) -> Vector3 {
    return (from_clip_ * Eigen::Vector4d(at.x(), at.y(), depth, 1)).hnormalized();
  };
  // Not up to the far plane, which may be at infinity.
  const Vector3 near = unproject(-1);
  return {near, unproject(0) - near};
}

Vector2 Camera::pixel(const Vector3& point) const {
  const Eigen::Vector4d clip = to_clip_ * point.homogeneous();
  if (!(clip.w() > 0)) return Vector2::Constant(kFarOff);
  return size_.cwiseProduct(Vector2(1 + clip.x() / clip.w(), 1 - clip.y() / clip.w())) / 2;
}

}  // namespace shell_origami
