/// \file
/// The fields that all markers have in common.
#pragma once

#include <geometry_msgs/Point.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include <Eigen/Core>

#include <string>

namespace shell_origami {

geometry_msgs::Point markerPoint(const Eigen::Vector3d& p);

/// A marker that is to be shown, at the origin of its frame.
visualization_msgs::Marker newMarker(const std::string& name, int type,
                                     const std_msgs::Header& header);

/// A list without points deletes the marker it would replace, since rviz warns of it.
visualization_msgs::Marker finished(visualization_msgs::Marker marker);

/// Toward the light that shades the paper and casts its shadow. A unit vector.
const Eigen::Vector3d& lightDirection();

}  // namespace shell_origami
