/// \file
/// Differences of ROS times. ros::Duration ends at 68 years and throws beyond, and /clock may jump
/// farther.
#pragma once

#include <ros/time.h>

namespace shell_origami {

/// Returns the time from one to the other [s].
double secondsBetween(const ros::Time& from, const ros::Time& to);

/// Returns the time so many seconds later, or the end of ROS time that is closest to it.
ros::Time later(const ros::Time& time, double seconds);

}  // namespace shell_origami
