/// \file
/// The paper and its panels as TF frames.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <geometry_msgs/TransformStamped.h>
#include <std_msgs/Header.h>

#include <string>
#include <vector>

namespace shell_origami {

/// A region of triangles between creases. A crease that ends inside the paper parts nothing.
struct Panel {
  std::vector<int> vertices;
  Vector2 centroid;  ///< on the flat sheet [m]
};

constexpr char kViewFrame[] = "paper_view";

/// In the order of each panel's first triangle.
std::vector<Panel> findPanels(const Sheet& sheet);

/// Whether paper whose frames begin with `prefix` has or may come to have a frame of this name:
/// paper, panel_<n>, or paper_view.
bool isPaperFrame(const std::string& frame, const std::string& prefix);

/// Frames of the paper at `positions`, stamped and rooted as the header says, their names beginning
/// with `prefix`: header.frame_id -> paper is the best rigid fit (Kabsch) of the flat sheet to the
/// paper; paper -> panel_<n> the best fit of panel n, at its centroid. While the paper is flat all
/// panels are parallel to it.
std::vector<geometry_msgs::TransformStamped> paperFrames(const Sheet& sheet,
                                                         const std::vector<Panel>& panels,
                                                         const Positions& positions,
                                                         const std_msgs::Header& header,
                                                         const std::string& prefix);

/// The frame that cameras look at, parallel to the world.
geometry_msgs::TransformStamped viewFrame(const Vector3& target, const std_msgs::Header& header,
                                          const std::string& prefix);

}  // namespace shell_origami
