#include "node/tf_point.h"

#include "sheet/refuse.h"

#include <tf2_eigen/tf2_eigen.h>

namespace shell_origami {

Vector3 toWorld(const std::string& name, const Vector3& point, const std_msgs::Header& header,
                const std::string& world, const tf2_ros::Buffer& tf) {
  if (header.frame_id.empty() || header.frame_id == world) return point;
  try {
    return tf2::transformToEigen(tf.lookupTransform(world, header.frame_id, header.stamp)) * point;
  } catch (const tf2::TransformException& error) {
    refuse(name, " is in frame \"", header.frame_id, "\", which TF cannot bring to \"", world,
           "\": ", error.what());
  }
}

}  // namespace shell_origami
