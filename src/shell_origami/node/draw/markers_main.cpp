/// \file
/// Draws a recorded run: from the messages Sheet and SheetState, exactly as the live node does.

#include <shell_origami/node/draw/markers.h>
#include <shell_origami/node/parameter_reader.h>

#include <csignal>

namespace {

/// \throws std::invalid_argument with one sentence that names the offending parameter.
shell_origami::MarkerPainter configuredPainter(const ros::NodeHandle& node) {
  shell_origami::ParameterReader reader(node);
  bool vertex_ids = false;
  auto colouring = shell_origami::Coloring::kPaper;
  reader.read("vertex_ids", vertex_ids);
  readChoice(reader, "colouring", shell_origami::coloringNames(), colouring);
  reader.rejectUnread();
  return {vertex_ids, colouring};
}

class MarkersNode {
 public:
  explicit MarkersNode(ros::NodeHandle& node)
      : painter_(configuredPainter(node)),
        markers_(node.advertise<visualization_msgs::MarkerArray>("markers", 5)),
        sheet_(node.subscribe("sheet", 10, &MarkersNode::onSheet, this)),
        state_(node.subscribe("state", 10, &MarkersNode::onState, this)) {}

 private:
  void onSheet(const shell_origami::msg::Sheet::ConstPtr& sheet) { painter_.setSheet(*sheet); }

  void onState(const shell_origami::msg::SheetState::ConstPtr& state) {
    if (markers_.getNumSubscribers() == 0 || !painter_.fits(*state)) return;
    markers_.publish(painter_.draw(*state));
  }

  shell_origami::MarkerPainter painter_;
  ros::Publisher markers_;
  ros::Subscriber sheet_;
  ros::Subscriber state_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "origami");
  // roscpp ends cleanly of SIGINT alone.
  std::signal(SIGTERM, [](int) { ros::requestShutdown(); });
  ros::NodeHandle node("~");
  try {
    MarkersNode markers(node);
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
