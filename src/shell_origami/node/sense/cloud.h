/// \file
/// The paper as a cloud of points.
#pragma once

#include <shell_origami/node/sense/material_points.h>

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>

#include <optional>
#include <vector>

namespace shell_origami {

/// The points twice: on the front, then, in the same order, on the back. Both are on the middle
/// surface, as layers in contact may be closer than paper is thick. Normals point out of their
/// side.
/// \param cloud  whose memory is used again: fresh memory costs more than all the rest
void writeCloud(const std::vector<MaterialPoint>& points, const Sheet& sheet,
                const Positions& positions, sensor_msgs::PointCloud2& cloud);

/// Sends a cloud while someone listens.
class CloudPublisher {
 public:
  /// \param points  about how many a cloud has, on both sides together
  CloudPublisher(ros::NodeHandle& node, int points);

  bool heard() const { return cloud_.getNumSubscribers() > 0; }
  /// Says that the next cloud is of a sheet that is another or has changed.
  void changeSheet() { points_.reset(); }
  void publish(const Sheet& sheet, const Positions& positions, const std_msgs::Header& header);

 private:
  int count_;
  std::optional<std::vector<MaterialPoint>>
      points_;  ///< of the sheet, once there was a cloud of it
  sensor_msgs::PointCloud2 message_;
  ros::Publisher cloud_;
};

}  // namespace shell_origami
