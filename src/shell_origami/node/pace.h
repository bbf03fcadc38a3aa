/// \file
/// Actions that are repeated at a rate in ROS time.
#pragma once

#include <ros/time.h>

namespace shell_origami {

/// Stamps advance by time steps, and jump where the clock does.
class Pace {
 public:
  /// \param slack  by how much it may come early [s]
  bool due(const ros::Time& stamp, double rate, double slack) const;
  /// It was done, due or not.
  void done(const ros::Time& stamp, double rate);

 private:
  ros::Time next_;
};

}  // namespace shell_origami
