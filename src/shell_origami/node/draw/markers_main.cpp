/// \file
/// Draws a recorded run: from the messages Sheet and SheetState, exactly as the live node does.
/// Sends its clouds of points as well.

#include <shell_origami/node/conversions.h>
#include <shell_origami/node/draw/marker_publisher.h>
#include <shell_origami/node/parameter_reader.h>
#include <shell_origami/node/parameters.h>
#include <shell_origami/node/sense/cloud.h>

#include <csignal>
#include <optional>
#include <set>
#include <string>

namespace {

using shell_origami::NodeConfig;

/// The node's own parameters of what is drawn and sent.
const std::set<std::string> kShown = {"vertex_ids", "crease_labels", "contact_points", "colouring",
                                      "cloud/points"};

struct Parameters {
  std::string origami = "origami";  ///< the node that was recorded
  NodeConfig shown;
};

/// \throws std::invalid_argument that names the offending parameter.
Parameters loadParameters(const ros::NodeHandle& node) {
  shell_origami::ParameterReader reader(node);
  Parameters parameters;
  reader.read("origami", &parameters.origami);
  for (const auto& [name, place, meaning, unit, bounds, live] : shell_origami::nodeParameters()) {
    if (kShown.count(name) == 0) continue;
    reader.read(name, place(parameters.shown));
    shell_origami::checkValue(name, place(parameters.shown), bounds);
  }
  reader.rejectUnread();
  return parameters;
}

class MarkersNode {
 public:
  explicit MarkersNode(const Parameters& parameters)
      : recorded_(parameters.origami),
        markers_(recorded_, {parameters.shown.markers, parameters.shown.colouring}),
        cloud_(recorded_, parameters.shown.cloud_points),
        sheet_(recorded_.subscribe("sheet", 10, &MarkersNode::onSheet, this)),
        state_(recorded_.subscribe("state", 10, &MarkersNode::onState, this)) {}

 private:
  void onSheet(const shell_origami::msg::Sheet::ConstPtr& message) {
    markers_.setSheet(*message);
    cloud_.changeSheet();
    sheet_of_cloud_.reset();
    try {
      sheet_of_cloud_ = shell_origami::sheetFrom(*message);
    } catch (const std::exception& error) {
      ROS_WARN("no cloud of a sheet that is none: %s", error.what());
    }
  }

  void onState(const shell_origami::msg::SheetState::ConstPtr& state) {
    if (!markers_.painter().fits(*state)) return;
    if (markers_.heard()) markers_.publish(*state);
    if (!cloud_.heard() || !sheet_of_cloud_) return;
    cloud_.publish(*sheet_of_cloud_, shell_origami::positionsFrom(*state), state->header);
  }

  ros::NodeHandle recorded_;
  shell_origami::MarkerPublisher markers_;
  shell_origami::CloudPublisher cloud_;
  std::optional<shell_origami::Sheet> sheet_of_cloud_;
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
