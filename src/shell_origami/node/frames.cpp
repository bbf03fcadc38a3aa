#include <shell_origami/node/frames.h>

#include <shell_origami/sheet/rigid_panels.h>

#include <tf2_eigen/tf2_eigen.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

/// The rotation and shift that bring the flat vertices closest to where they are.
Eigen::Isometry3d rigidFit(const Sheet& sheet, const std::vector<int>& vertices,
                           const Positions& positions) {
  Positions flat = Positions::Zero(3, static_cast<Eigen::Index>(vertices.size()));
  Positions now = flat;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    flat.col(column).head<2>() = sheet.flatPositions()[vertices[i]];
    now.col(column) = positions.col(vertices[i]);
  }
  return Eigen::Isometry3d(Eigen::umeyama(flat, now, false));
}

geometry_msgs::TransformStamped frame(const Eigen::Isometry3d& pose, const std::string& child,
                                      const std_msgs::Header& header) {
  geometry_msgs::TransformStamped transform = tf2::eigenToTransform(Eigen::Affine3d(pose));
  transform.header = header;
  transform.child_frame_id = child;
  return transform;
}

}  // namespace

std::vector<Panel> findPanels(const Sheet& sheet) {
  const std::vector<int> panel_of = panelOfTriangle(sheet);
  const std::size_t count = *std::max_element(panel_of.begin(), panel_of.end()) + 1;
  std::vector<std::vector<int>> vertices(count);
  std::vector<double> area(count, 0);
  std::vector<Vector2> moment(count, Vector2::Zero());
  for (std::size_t t = 0; t < panel_of.size(); ++t) {
    const Triangle& corners = sheet.triangles()[t];
    const Vector2& a = sheet.flatPositions()[corners[0]];
    const Vector2& b = sheet.flatPositions()[corners[1]];
    const Vector2& c = sheet.flatPositions()[corners[2]];
    const double weight = doubleArea(a, b, c);
    auto& of_panel = vertices[panel_of[t]];
    of_panel.insert(of_panel.end(), corners.begin(), corners.end());
    area[panel_of[t]] += weight;
    moment[panel_of[t]] += weight * (a + b + c) / 3;
  }
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < count; ++i) {
    std::sort(vertices[i].begin(), vertices[i].end());
    vertices[i].erase(std::unique(vertices[i].begin(), vertices[i].end()), vertices[i].end());
    panels.push_back({std::move(vertices[i]), moment[i] / area[i]});
  }
  return panels;
}

bool isPaperFrame(const std::string& frame, const std::string& prefix) {
  if (frame == prefix + "paper" || frame == prefix + kViewFrame) return true;
  const std::string panel = prefix + "panel_";
  return frame.size() > panel.size() && frame.compare(0, panel.size(), panel) == 0 &&
         std::all_of(frame.begin() + static_cast<std::ptrdiff_t>(panel.size()), frame.end(),
                     [](unsigned char letter) { return std::isdigit(letter); });
}

std::vector<geometry_msgs::TransformStamped> paperFrames(const Sheet& sheet,
                                                         const std::vector<Panel>& panels,
                                                         const Positions& positions,
                                                         const std_msgs::Header& header,
                                                         const std::string& prefix) {
  std::vector<int> all(sheet.vertexCount());
  std::iota(all.begin(), all.end(), 0);
  const Eigen::Isometry3d paper = rigidFit(sheet, all, positions);
  std::vector<geometry_msgs::TransformStamped> frames = {frame(paper, prefix + "paper", header)};

  std_msgs::Header on_paper = header;
  on_paper.frame_id = prefix + "paper";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Vector3 centroid(panels[i].centroid.x(), panels[i].centroid.y(), 0);
    const Eigen::Isometry3d panel =
        rigidFit(sheet, panels[i].vertices, positions) * Eigen::Translation3d(centroid);
    frames.push_back(
        frame(paper.inverse() * panel, prefix + "panel_" + std::to_string(i), on_paper));
  }
  return frames;
}

geometry_msgs::TransformStamped viewFrame(const Vector3& target, const std_msgs::Header& header,
                                          const std::string& prefix) {
  return frame(Eigen::Isometry3d(Eigen::Translation3d(target)), prefix + kViewFrame, header);
}

}  // namespace shell_origami
