/// \file
/// The node's services. A refused request changes nothing and says why in one sentence.
#pragma once

#include <shell_origami/node/held_frames.h>
#include <shell_origami/node/origami_node.h>

#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>

#include <vector>

namespace shell_origami {

class Services {
 public:
  /// \param tf  what is heard on /tf; must live as long
  Services(ros::NodeHandle& node, OrigamiNode& origami, HeldFrames& held_frames,
           const tf2_ros::Buffer& tf);

 private:
  bool fold(msg::Fold::Request& request, msg::Fold::Response& response);
  bool pin(msg::Pin::Request& request, msg::Pin::Response& response);
  bool unpin(msg::Unpin::Request& request, msg::Unpin::Response& response);
  bool addVertex(msg::AddVertex::Request& request, msg::AddVertex::Response& response);
  bool load(msg::Load::Request& request, msg::Load::Response& response);
  bool save(msg::Save::Request& request, msg::Save::Response& response);
  bool step(msg::Step::Request& request, msg::Step::Response& response);
  bool settle(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool pause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool resume(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);

  OrigamiNode& origami_;
  HeldFrames& held_frames_;
  const tf2_ros::Buffer& tf_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace shell_origami
