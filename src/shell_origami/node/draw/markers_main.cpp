/// \file
/// Draws a recorded run: from the messages Sheet and SheetState, exactly as the live node does.

#include <shell_origami/node/draw/marker_publisher.h>
#include <shell_origami/node/parameter_reader.h>

#include <csignal>

namespace {

struct Parameters {
  std::string origami = "origami";  ///< the node that was recorded
  shell_origami::MarkerOptions markers;
  shell_origami::Coloring colouring = shell_origami::Coloring::kPaper;
};

/// \throws std::invalid_argument that names the offending parameter.
Parameters loadParameters(const ros::NodeHandle& node) {
  shell_origami::ParameterReader reader(node);
  Parameters parameters;
  reader.read("origami", &parameters.origami);
  reader.read("vertex_ids", &parameters.markers.vertex_ids);
  reader.read("crease_labels", &parameters.markers.crease_labels);
  reader.read("contact_points", &parameters.markers.contact_points);
  reader.read("colouring",
              shell_origami::Choice(shell_origami::coloringNames(), parameters.colouring));
  reader.rejectUnread();
  return parameters;
}

class MarkersNode {
 public:
  explicit MarkersNode(const Parameters& parameters)
      : recorded_(parameters.origami),
        markers_(recorded_, {parameters.markers, parameters.colouring}),
        sheet_(recorded_.subscribe("sheet", 10, &MarkersNode::onSheet, this)),
        state_(recorded_.subscribe("state", 10, &MarkersNode::onState, this)) {}

 private:
  void onSheet(const shell_origami::msg::Sheet::ConstPtr& sheet) { markers_.setSheet(*sheet); }

  void onState(const shell_origami::msg::SheetState::ConstPtr& state) {
    if (markers_.heard() && markers_.painter().fits(*state)) markers_.publish(*state);
  }

  ros::NodeHandle recorded_;
  shell_origami::MarkerPublisher markers_;
  ros::Subscriber sheet_;
  ros::Subscriber state_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "origami_markers");
  // roscpp ends cleanly of SIGINT alone.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  const ros::NodeHandle node("~");
  try {
    MarkersNode markers(loadParameters(node));
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
