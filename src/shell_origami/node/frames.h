/// \file
/// The paper and its panels as TF frames.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <geometry_msgs/TransformStamped.h>
#include <std_msgs/Header.h>

#include <vector>

namespace shell_origami {

/// A region of triangles between creases. A crease that ends inside the paper parts nothing.
struct Panel {
  std::vector<int> vertices;
  Vector2 centroid;  ///< on the flat sheet [m]
};

/// In the order of each panel's first triangle.
std::vector<Panel> findPanels(const Sheet& sheet);

/// Frames of the paper at `positions`, stamped and rooted as the header says:
/// header.frame_id -> paper is the best rigid fit (Kabsch) of the flat sheet to the paper;
/// paper -> panel_<n> the best fit of panel n, at its centroid. While the paper is flat all
/// panels are parallel to it.
std::vector<geometry_msgs::TransformStamped> paperFrames(const Sheet& sheet,
                                                         const std::vector<Panel>& panels,
                                                         const Positions& positions,
                                                         const std_msgs::Header& header);

}  // namespace shell_origami
