#include <shell_origami/node/draw/obstacle_marker.h>

#include <shell_origami/node/draw/coloring.h>
#include <shell_origami/node/draw/marker.h>

#include <Eigen/Geometry>

#include <array>

namespace shell_origami {
namespace {

using visualization_msgs::Marker;

/// How far a half space is drawn around the paper, over the size of the sheet.
constexpr double kTableReach = 1.2;
/// How far below the surface it is drawn, over that size: the paper's lines lie below the paper.
constexpr double kTableDepth = 1.0 / 400;
/// Cosine of the slope up to which a half space is a table.
constexpr double kLevel = 0.9999;

Eigen::Isometry3d isometry(const geometry_msgs::Pose& pose) {
  const auto& q = pose.orientation;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  return result;
}

void addFace(const std::array<Eigen::Vector3d, 3>& corners, Marker& marker) {
  const Eigen::Vector3d area = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (!(area.norm() > 1e-15)) return;  // rviz cannot draw it (rviz #925)
  const double s = 0.75 + 0.25 * area.normalized().dot(lightDirection());
  marker.colors.push_back(color(0.72 * s, 0.66 * s, 0.58 * s));
  for (const Eigen::Vector3d& corner : corners) marker.points.push_back(markerPoint(corner));
}

/// The part of the plane around the paper.
void addTable(const Eigen::Isometry3d& pose, const Eigen::Matrix3Xd& paper, double size,
              Marker& marker) {
  Eigen::Vector3d center = pose.inverse() * Eigen::Vector3d(paper.rowwise().mean());
  center.z() = -kTableDepth * size;
  const double reach = kTableReach * size;
  std::array<Eigen::Vector3d, 4> corners;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d way((i == 1 || i == 2) ? reach : -reach, i >= 2 ? reach : -reach, 0);
    corners[i] = pose * (center + way);
  }
  addFace({corners[0], corners[1], corners[2]}, marker);
  addFace({corners[0], corners[2], corners[3]}, marker);
}

}  // namespace

Marker obstacleMarker(const std::vector<msg::Obstacle>& obstacles,
                      const std::vector<geometry_msgs::Pose>& poses, const Eigen::Matrix3Xd& paper,
                      double size, const std_msgs::Header& header) {
  Marker marker = newMarker("obstacles", Marker::TRIANGLE_LIST, header);
  marker.color.a = 1;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Eigen::Isometry3d pose = isometry(poses[i]);
    if (obstacles[i].half_space) addTable(pose, paper, size, marker);
    const shape_msgs::Mesh& mesh = obstacles[i].mesh;
    for (const auto& triangle : mesh.triangles) {
      std::array<Eigen::Vector3d, 3> corners;
      for (int k = 0; k < 3; ++k) {
        const auto& p = mesh.vertices[triangle.vertex_indices[k]];
        corners[k] = pose * Eigen::Vector3d(p.x, p.y, p.z);
      }
      addFace(corners, marker);
    }
  }
  return finished(marker);
}

std::optional<double> tableHeight(const std::vector<msg::Obstacle>& obstacles,
                                  const std::vector<geometry_msgs::Pose>& poses, double size) {
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Eigen::Isometry3d pose = isometry(poses[i]);
    if (!obstacles[i].half_space || pose.linear()(2, 2) < kLevel) continue;
    return pose.translation().z() - kTableDepth / 2 * size;
  }
  return std::nullopt;
}

}  // namespace shell_origami
