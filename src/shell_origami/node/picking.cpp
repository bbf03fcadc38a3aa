#include <shell_origami/node/picking.h>

#include <shell_origami/node/conversions.h>
#include <shell_origami/node/message_text.h>
#include <shell_origami/node/tf_utilities.h>

#include <stdexcept>

namespace shell_origami {

Picking::Picking(ros::NodeHandle& node, OrigamiNode& origami, const tf2_ros::Buffer& tf)
    : origami_(origami),
      tf_(tf),
      picked_(node.advertise<msg::Picked>("picked", 10)),
      clicks_(ros::NodeHandle().subscribe("clicked_point", 10, &Picking::pick, this)) {}

void Picking::pick(const geometry_msgs::PointStamped& click) {
  std_msgs::Header header;
  header.stamp = origami_.stamp();
  header.frame_id = origami_.config().world_frame;
  std_msgs::Header latest = click.header;
  latest.stamp = ros::Time();
  try {
    const Vector3 point = toWorld("the click", clickedPoint(click), latest, header.frame_id, tf_);
    const msg::Picked picked = pickedMessage(origami_.session(), point, header);
    picked_.publish(picked);
    ROS_INFO("picked vertex %u, (%g, %g) of the flat sheet%s%s", picked.vertex,
             picked.flat_position.x, picked.flat_position.y,
             picked.crease.empty() ? "" : ", on crease ", picked.crease.c_str());
  } catch (const std::invalid_argument& error) {
    ROS_WARN("nothing is picked: %s", asMessageText(error.what()).c_str());
  }
}

}  // namespace shell_origami
