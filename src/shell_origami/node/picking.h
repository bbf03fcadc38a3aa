/// \file
/// Which vertex of the paper was clicked in rviz.
#pragma once

#include <shell_origami/node/origami_node.h>

#include <tf2_ros/buffer.h>

namespace shell_origami {

/// Answers each point on /clicked_point with the nearest vertex on ~picked. A click in a frame
/// that moves is where that frame is now, like the paper.
class Picking {
 public:
  /// \param tf  what is heard on /tf; must live as long
  Picking(ros::NodeHandle& node, OrigamiNode& origami, const tf2_ros::Buffer& tf);

 private:
  void pick(const geometry_msgs::PointStamped& click);

  OrigamiNode& origami_;
  const tf2_ros::Buffer& tf_;
  ros::Publisher picked_;
  ros::Subscriber clicks_;
};

}  // namespace shell_origami
