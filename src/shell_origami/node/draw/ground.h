/// \file
/// The ground below the paper, which tells up from down.
#pragma once

#include <shell_origami/node/messages.h>

#include <visualization_msgs/Marker.h>

#include <Eigen/Core>

namespace shell_origami {

/// Height of the ground for paper that is loaded with these positions (a column each) [m]: below
/// what a sheet of this size reaches when it folds about its middle.
double groundBelow(const Eigen::Matrix3Xd& positions, double size);

/// Height of the ground as it is drawn [m]: that of the sheet, and below paper that has fallen
/// through it another one, every four sizes of the sheet, so that the fall is seen.
double groundUnder(const Eigen::Matrix3Xd& positions, double size, double ground);

/// Lines at whole multiples of the spacing (1, 2 or 5 of a decimal place), around the paper.
visualization_msgs::Marker groundGrid(const Eigen::Matrix3Xd& positions, double size, double ground,
                                      const std_msgs::Header& header);

/// Returns the shadow, on the ground, of the part of the paper above it. `size` of the sheet [m].
visualization_msgs::Marker shadow(const Eigen::Matrix3Xd& positions, double size, double ground,
                                  const msg::Sheet& sheet, const std_msgs::Header& header);

}  // namespace shell_origami
