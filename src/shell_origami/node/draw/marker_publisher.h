/// \file
/// Sends what rviz shows, as often as it changes.
#pragma once

#include <shell_origami/node/draw/markers.h>

#include <ros/ros.h>

#include <optional>

namespace shell_origami {

/// Draws while someone listens. A drawing in which nothing has moved is not sent again, but for a
/// few times: a message may have been dropped on the way, or have come before its TF frame. Whoever
/// begins to listen is sent the last drawing and the next.
class MarkerPublisher {
 public:
  MarkerPublisher(ros::NodeHandle& node, MarkerPainter painter);
  MarkerPublisher(const MarkerPublisher&) = delete;
  MarkerPublisher& operator=(const MarkerPublisher&) = delete;

  /// The next drawing is sent, whether it differs or not.
  void setSheet(const msg::Sheet& sheet);
  void choose(const MarkerOptions& options, Coloring colouring) {
    painter_.choose(options, colouring);
  }
  const MarkerPainter& painter() const { return painter_; }
  bool heard() const { return markers_.getNumSubscribers() > 0; }
  /// When the last of those who listen began to; zero: nobody listens.
  ros::SteadyTime heardSince() const { return heard() ? heard_since_ : ros::SteadyTime(); }
  /// \pre painter().fits(state)
  void publish(const msg::SheetState& state);

 private:
  void beginToSend();

  MarkerPainter painter_;
  std::optional<visualization_msgs::MarkerArray> sent_;
  ros::SteadyTime heard_since_;
  int repeats_ = 0;  ///< of the drawing that was sent last
  ros::Publisher markers_;
};

/// Whether two drawings of a sheet look the same: all points within a distance [m], all colors
/// within a hundredth.
bool looksTheSame(const visualization_msgs::MarkerArray& a,
                  const visualization_msgs::MarkerArray& b, double distance);

}  // namespace shell_origami
