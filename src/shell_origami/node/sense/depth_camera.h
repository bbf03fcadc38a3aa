/// \file
/// A depth camera that looks at the paper and the obstacles around it.
#pragma once

#include <shell_origami/node/origami_node.h>
#include <shell_origami/node/pace.h>
#include <shell_origami/node/sense/depth_config.h>

#include <sensor_msgs/Image.h>
#include <tf2_ros/buffer.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace shell_origami {

/// Sends ~depth/image, ~depth/label and ~depth/camera_info while someone listens. The node's thread
/// keeps the paper as it is; a thread of the camera's own waits until TF knows where the camera was
/// at that time, and draws.
class DepthCamera {
 public:
  /// \param tf  what is heard on /tf; must live as long
  DepthCamera(ros::NodeHandle& node, OrigamiNode& origami, const tf2_ros::Buffer& tf);
  DepthCamera(const DepthCamera&) = delete;
  DepthCamera& operator=(const DepthCamera&) = delete;
  ~DepthCamera();

 private:
  /// The paper and the obstacles at a time.
  struct Shot {
    ros::Time stamp;
    ros::SteadyTime taken;
    std::shared_ptr<const Sheet> sheet;
    std::vector<Body> bodies;
    Positions positions;  ///< of the sheet's vertices and of the bodies'
  };

  bool heard() const;

  // In the node's thread.
  void watch();

  // In the camera's.
  void work();
  std::optional<Eigen::Isometry3d> waitForPose(const Shot& shot,
                                               std::unique_lock<std::mutex>& lock);
  void send(const Shot& shot, const Eigen::Isometry3d& world_in_camera);

  OrigamiNode& origami_;
  const DepthConfig config_;
  const std::string world_frame_;
  const tf2_ros::Buffer& tf_;
  ros::Publisher image_, label_, info_;
  std::uint32_t revision_ = 0;          ///< of the sheet of the last shot
  std::shared_ptr<const Sheet> sheet_;  ///< that sheet
  ros::Time last_stamp_;
  Pace pace_;
  DepthRenderer renderer_;  ///< of the camera's thread, as the images are
  sensor_msgs::Image depths_, labels_;

  std::mutex mutex_;  ///< of what follows
  std::condition_variable news_;
  std::deque<Shot> shots_;
  bool ending_ = false;

  std::thread thread_;
  ros::SteadyTimer timer_;  ///< wakes the node's thread where it sleeps beside resting paper
};

}  // namespace shell_origami
