#include <shell_origami/node/frame_listener.h>

#include <boost/function.hpp>

namespace shell_origami {
namespace {

constexpr std::uint32_t kTransformQueue = 100;

}  // namespace

FrameListener::FrameListener(ros::NodeHandle& node, tf2_ros::Buffer& tf) : tf_(tf) {
  using Callback = boost::function<void(const Event&)>;
  moving_ = node.subscribe<tf2_msgs::TFMessage>(
      "/tf", kTransformQueue, Callback([this](const Event& event) { hear(event, false); }));
  static_ = node.subscribe<tf2_msgs::TFMessage>(
      "/tf_static", kTransformQueue, Callback([this](const Event& event) { hear(event, true); }));
}

void FrameListener::hear(const Event& event, bool are_static) {
  const ros::Time now = ros::Time::now();
  if (now < last_) {
    ROS_WARN("time went back: what was known of TF frames is forgotten");
    tf_.clear();
  }
  last_ = now;
  for (const auto& transform : event.getConstMessage()->transforms) {
    set(transform, event.getPublisherName(), are_static);
  }
}

void FrameListener::set(const geometry_msgs::TransformStamped& transform,
                        const std::string& authority, bool is_static) {
  if (isSet(transform, authority, is_static)) return;
  ROS_WARN_THROTTLE(1, "the stamps of frame %s jumped: what was known of TF frames is forgotten",
                    transform.child_frame_id.c_str());
  tf_.clear();
  // In the last seconds of ROS time tf2 keeps nothing.
  if (!isSet(transform, authority, is_static)) tf_.clear();
}

/// Returns false where a stamp and what tf2 compares it with are too far apart for a ros::Duration,
/// or their sum is too large for a ros::Time.
bool FrameListener::isSet(const geometry_msgs::TransformStamped& transform,
                          const std::string& authority, bool is_static) {
  try {
    tf_.setTransform(transform, authority, is_static);
  } catch (const tf2::TransformException& error) {
    ROS_WARN_THROTTLE(1, "a transform from %s is passed over: %s", authority.c_str(), error.what());
  } catch (const std::runtime_error&) {
    return false;
  }
  return true;
}

}  // namespace shell_origami
