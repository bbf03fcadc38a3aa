/// \file
/// The TF frames that the node listens to.
#pragma once

#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

namespace shell_origami {

/// Fills a buffer from /tf and /tf_static, in the queue of the node handle. tf2's own listener lets
/// through what tf2 throws where two stamps of a frame are 68 years apart, as those before and
/// after a jump of /clock may be, and the node would end.
class FrameListener {
 public:
  /// \param tf  must outlive the listener
  FrameListener(ros::NodeHandle& node, tf2_ros::Buffer& tf);

 private:
  using Event = ros::MessageEvent<const tf2_msgs::TFMessage>;

  void hear(const Event& event, bool are_static);
  void set(const geometry_msgs::TransformStamped& transform, const std::string& authority,
           bool is_static);

  bool isSet(const geometry_msgs::TransformStamped& transform, const std::string& authority,
             bool is_static);

  tf2_ros::Buffer& tf_;
  ros::Time last_;  ///< when it last heard of a frame
  ros::Subscriber moving_, static_;
};

}  // namespace shell_origami
