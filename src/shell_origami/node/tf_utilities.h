/// \file
/// Frames of TF, and points in them.
#pragma once

#include <shell_origami/base/geometry.h>

#include <geometry_msgs/TransformStamped.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>

#include <string>

namespace shell_origami {

/// From the header's frame at its stamp (zero: at the latest known) to the frame `world`.
/// \param subject  what the sentence says of the frame, such as "frame_id is"
/// \throws std::invalid_argument when TF does not know the way.
geometry_msgs::TransformStamped transformToWorld(const std::string& subject,
                                                 const std_msgs::Header& header,
                                                 const std::string& world,
                                                 const tf2_ros::Buffer& tf);

/// A point of the header's frame (empty: `world`) at its stamp (zero: at the latest known), in the
/// frame `world`.
/// \param name  of the point, in the sentence
/// \throws std::invalid_argument when TF does not know the way.
Vector3 toWorld(const std::string& name, const Vector3& point, const std_msgs::Header& header,
                const std::string& world, const tf2_ros::Buffer& tf);

}  // namespace shell_origami
