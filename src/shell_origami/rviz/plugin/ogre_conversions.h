/// \file
/// Between Eigen and Ogre, which rviz draws with.
#pragma once

#include <shell_origami/rviz/camera.h>

#include <OgreCamera.h>
#include <OgreQuaternion.h>
#include <OgreVector3.h>

#include <Eigen/Geometry>

namespace shell_origami {

inline Ogre::Vector3 toOgre(const Vector3& v) {
  return {static_cast<Ogre::Real>(v.x()), static_cast<Ogre::Real>(v.y()),
          static_cast<Ogre::Real>(v.z())};
}

inline Vector3 fromOgre(const Ogre::Vector3& v) { return {v.x, v.y, v.z}; }

/// From the paper's world frame to rviz's fixed frame.
struct FramePose {
  Ogre::Vector3 position = Ogre::Vector3::ZERO;
  Ogre::Quaternion orientation = Ogre::Quaternion::IDENTITY;

  Eigen::Isometry3d transform() const {
    const Ogre::Quaternion& q = orientation;
    return Eigen::Translation3d(fromOgre(position)) * Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  }
};

inline Eigen::Matrix4d fromOgre(const Ogre::Matrix4& m) {
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix(row, column) = m[row][column];
  }
  return matrix;
}

/// Returns rviz's view of the paper's world frame. \param size  of the view [pixel]
inline Camera cameraFrom(const Ogre::Camera& camera, const FramePose& world, const Vector2& size) {
  const Eigen::Matrix4d view = fromOgre(Ogre::Matrix4(camera.getViewMatrix()));
  const Eigen::Matrix4d projection = fromOgre(camera.getProjectionMatrix());
  return {projection * view * world.transform().matrix(), size};
}

/// Returns where the camera is in the paper's world frame [m].
inline Vector3 eyeOf(const Ogre::Camera& camera, const FramePose& world) {
  return world.transform().inverse() * fromOgre(camera.getDerivedPosition());
}

}  // namespace shell_origami
