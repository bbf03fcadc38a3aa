/// \file
/// Every topic the node publishes, but /clock.
#pragma once

#include <shell_origami/node/draw/marker_publisher.h>
#include <shell_origami/node/frames.h>
#include <shell_origami/node/parameters.h>
#include <shell_origami/node/sense/cloud.h>
#include <shell_origami/node/session.h>
#include <shell_origami/node/view.h>

#include <tf2_ros/transform_broadcaster.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

class Publishers {
 public:
  /// \param whole_paper  makes the edit that whoever begins to listen is sent first
  Publishers(ros::NodeHandle& node, const NodeConfig& config,
             std::function<msg::Edit()> whole_paper);

  /// The paper as it is now, and its sheet when the revision is a new one.
  void publish(const Session& session, bool paused, const StepReport& step, double real_time_factor,
               const ros::Time& stamp);

  void publishEdit(msg::Edit edit, const ros::Time& stamp);
  bool editsHeard() const { return edit_.getNumSubscribers() > 0; }

  void choose(const MarkerOptions& options, Coloring colouring) {
    markers_.choose(options, colouring);
  }

  /// Where a camera is to stand that looks at the paper. Returns false where it stands there.
  bool publishView(const View& view, const ros::Time& stamp);
  /// Another paper has taken the place of the one before.
  void lookAnew() { camera_target_.forget(); }

  /// Whether someone listens to all that a recording needs.
  bool recorded() const;
  /// Since when someone shows the paper; zero: nobody does.
  ros::SteadyTime viewedSince() const { return markers_.heardSince(); }
  /// Whether someone aims a camera by publishView().
  bool aimed() const { return view_.getNumSubscribers() > 0; }

 private:
  std_msgs::Header header(const ros::Time& stamp) const;
  void publishSheet(const Session& session, const ros::Time& stamp);
  void publishFrames(const Session& session, const ros::Time& stamp);
  void publishWrenches(const Session& session, const ros::Time& stamp);
  void publishNamedWrenches(const Simulation& simulation, const ros::Time& stamp);
  void advertiseWrench(const std::string& frame);

  std::string world_frame_, frame_prefix_;
  std::optional<std::uint32_t> revision_;  ///< of the sheet last published
  Obstacles obstacles_;                    ///< that were published with it
  std::vector<Panel> panels_;              ///< of that sheet
  CameraTarget camera_target_;
  std::optional<View> published_view_;
  ros::Time frames_stamp_;

  ros::Publisher sheet_;
  ros::Publisher state_;
  ros::Publisher energy_;
  MarkerPublisher markers_;
  CloudPublisher cloud_;
  ros::Publisher edit_;
  ros::Publisher view_;
  ros::NodeHandle node_;
  std::map<std::string, ros::Publisher> wrenches_;  ///< by the names of frames that hold paper
  std::map<std::string, ros::Publisher> named_wrenches_;  ///< of obstacles and grasps
  tf2_ros::TransformBroadcaster broadcaster_;
};

}  // namespace shell_origami
