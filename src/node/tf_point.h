/// \file
/// Points in the frames of TF.
#pragma once

#include "sheet/geometry.h"

#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>

#include <string>

namespace shell_origami {

/// A point of the header's frame (empty: `world`) at its stamp (zero: at the latest known), in the
/// frame `world`.
/// \param name  of the point, in the sentence
/// \throws std::invalid_argument when TF does not know the way.
Vector3 toWorld(const std::string& name, const Vector3& point, const std_msgs::Header& header,
                const std::string& world, const tf2_ros::Buffer& tf);

}  // namespace shell_origami
