/// \file
/// The start of a node that waits for a viewer or a recorder.
#pragma once

#include <shell_origami/node/parameters.h>
#include <shell_origami/node/publishers.h>

#include <ros/time.h>

#include <string>

namespace shell_origami {

/// Holds time back until someone records and someone shows the paper, as far as the parameters ask
/// for them.
class StartWait {
 public:
  explicit StartWait(const NodeConfig& config);

  /// Whether there is anything to wait for.
  bool wanted() const { return recorder_ || viewer_; }
  /// For the log: "a recorder", for example.
  std::string what() const;
  /// Waits for a viewer to show the paper from another view. Returns false where there is none to
  /// wait for.
  bool waitForTurn(const Publishers& publishers);
  /// Whether the start needs to wait no longer. A viewer that does not come in time is given up,
  /// with a warning.
  bool over(const Publishers& publishers);

 private:
  bool viewerDraws(const ros::SteadyTime& viewed_since);

  double patience_;  ///< for the viewer [s]; 0: none is to be waited for
  bool recorder_;
  bool viewer_;
  ros::SteadyTime begin_;
  ros::SteadyTime turned_;  ///< the viewer listens anew after this time
};

}  // namespace shell_origami
