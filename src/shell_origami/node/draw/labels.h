/// \file
/// Texts beside the drawn paper.
#pragma once

#include <shell_origami/node/messages.h>

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>

#include <cstddef>

namespace shell_origami {

/// Markers that are drawn on demand.
struct MarkerOptions {
  bool vertex_ids = false;      ///< the number of each vertex
  bool crease_labels = false;   ///< name and angle of each crease
  bool contact_points = false;  ///< where layers push each other apart
};

/// Writes, and deletes what is not to be seen any longer.
class Labels {
 public:
  explicit Labels(const MarkerOptions& options) : options_(options) {}

  void choose(const MarkerOptions& options) { options_ = options; }
  const MarkerOptions& options() const { return options_; }

  /// Appends the numbers of vertices, the names and angles of creases, and a warning if the paper,
  /// unless it is soft, is stretched further than paper bears.
  /// \param points, normals  of the paper, a column a vertex
  /// \param size             of the flat sheet [m]
  void draw(const msg::Sheet& sheet, const msg::SheetState& state, const Eigen::Matrix3Xd& points,
            const Eigen::Matrix3Xd& normals, double size, visualization_msgs::MarkerArray& array);

 private:
  MarkerOptions options_;
  std::size_t vertices_ = 0;  ///< how many have a number in rviz
  std::size_t creases_ = 0;   ///< how many have a label in rviz
};

/// The largest pressure, and the one that has the strongest colour, above the paper.
/// \param points  of the paper
/// \param size    of the flat sheet [m]
visualization_msgs::Marker pressureLabel(const msg::SheetState& state,
                                         const Eigen::Matrix3Xd& points, double size,
                                         const std_msgs::Header& header);

}  // namespace shell_origami
