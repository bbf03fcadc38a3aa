/// \file
/// Parameters that may change while the node runs, by dynamic_reconfigure under ~live.
#pragma once

#include <shell_origami/node/origami_node.h>

#include <dynamic_reconfigure/server.h>
#include <shell_origami/OrigamiConfig.h>

namespace shell_origami {

/// They start as the node did and follow the paper: one that is loaded brings its own. A value out
/// of bounds is refused with a sentence in the log, and those that hold are shown again.
class LiveParameters {
 public:
  LiveParameters(ros::NodeHandle& node, OrigamiNode& origami);

 private:
  NodeConfig parameters() const;
  OrigamiConfig current() const;
  void describe();
  void change(OrigamiConfig& config);
  void apply(const NodeConfig& wanted);
  void follow();

  OrigamiNode& origami_;
  boost::recursive_mutex mutex_;
  dynamic_reconfigure::Server<OrigamiConfig> server_;
  OrigamiConfig shown_;
  ros::SteadyTimer timer_;
};

}  // namespace shell_origami
