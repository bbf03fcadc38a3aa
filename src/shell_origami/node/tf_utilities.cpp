#include <shell_origami/node/tf_utilities.h>

#include <shell_origami/base/error.h>

#include <tf2_eigen/tf2_eigen.h>

namespace shell_origami {

geometry_msgs::TransformStamped transformToWorld(const std::string& subject,
                                                 const std_msgs::Header& header,
                                                 const std::string& world,
                                                 const tf2_ros::Buffer& tf) {
  try {
    return tf.lookupTransform(world, header.frame_id, header.stamp);
  } catch (const tf2::TransformException& error) {
    reject(subject, " \"", header.frame_id, "\", which TF cannot bring to \"", world,
           "\": ", error.what());
  }
}

Vector3 toWorld(const std::string& name, const Vector3& point, const std_msgs::Header& header,
                const std::string& world, const tf2_ros::Buffer& tf) {
  if (header.frame_id.empty() || header.frame_id == world) return point;
  return tf2::transformToEigen(transformToWorld(name + " is in frame", header, world, tf)) * point;
}

}  // namespace shell_origami
