/// \file
/// The bodies beside the paper.
#pragma once

#include <shell_origami/node/messages.h>

#include <visualization_msgs/Marker.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace shell_origami {

/// Draws obstacles at their poses; of half spaces the part around the paper, as wide as a few
/// sheets of this size [m].
visualization_msgs::Marker obstacleMarker(const std::vector<msg::Obstacle>& obstacles,
                                          const std::vector<geometry_msgs::Pose>& poses,
                                          const Eigen::Matrix3Xd& paper, double size,
                                          const std_msgs::Header& header);

/// Returns the height of the shadow on a level half space that paper can lie on [m]: between the
/// paper and the half space as it is drawn.
std::optional<double> tableHeight(const std::vector<msg::Obstacle>& obstacles,
                                  const std::vector<geometry_msgs::Pose>& poses, double size);

}  // namespace shell_origami
