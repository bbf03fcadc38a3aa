#include <shell_origami/node/draw/markers.h>

#include <shell_origami/node/draw/ground.h>
#include <shell_origami/node/draw/marker.h>
#include <shell_origami/node/draw/obstacle_marker.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace shell_origami {
namespace {

using visualization_msgs::Marker;
using Points = Eigen::Matrix3Xd;

const std_msgs::ColorRGBA kBorder = color(0.22, 0.16, 0.14);
const std_msgs::ColorRGBA kPin = color(0.10, 0.55, 0.25);
const std_msgs::ColorRGBA kGrasp = color(0.90, 0.55, 0.10);

/// Distance of a side from the middle of the paper, over its size: rviz tells the sides apart, and
/// folded layers do not mix.
constexpr double kGap = 1.0 / 4000;

/// The colour of a face by how it looks at the light. rviz's own light would leave the sides that
/// look away from it all but black.
std_msgs::ColorRGBA shaded(const std_msgs::ColorRGBA& paper, const Eigen::Vector3d& normal) {
  const double s = 0.78 + 0.22 * normal.dot(lightDirection());
  return color(s * paper.r, s * paper.g, s * paper.b);
}

/// Faint when flat, full at pi. Mountains are red, valleys blue, as in a crease pattern.
std_msgs::ColorRGBA creaseColor(double angle) {
  const std_msgs::ColorRGBA full = angle < 0 ? color(0.55, 0.0, 0.10) : color(0.05, 0.15, 0.85);
  const std_msgs::ColorRGBA flat = color(0.62, 0.58, 0.56);
  return mixed(flat, full, std::min(1.0, 0.5 + 0.5 * std::abs(angle) / M_PI));
}

/// Yellow of a weak force, black of a strong one: no color of paper, creases and pins.
std_msgs::ColorRGBA contactColor(double force) {
  const double part = std::min(1.0, std::max(0.0, force / MarkerPainter::kFullForce));
  return mixed(color(1.0, 0.85, 0.1), color(0.05, 0.05, 0.05), part);
}

/// Normal of a triangle, twice its area long.
template <class Corners>
Eigen::Vector3d areaVector(const Points& points, const Corners& v) {
  const Eigen::Vector3d ab = points.col(v[1]) - points.col(v[0]);
  const Eigen::Vector3d ac = points.col(v[2]) - points.col(v[0]);
  return ab.cross(ac);
}

template <class Indices>
bool allBelow(const Indices& indices, std::size_t count) {
  return std::all_of(indices.begin(), indices.end(), [&](auto i) { return i < count; });
}

bool allCornersExist(const msg::Obstacle& obstacle) {
  const shape_msgs::Mesh& mesh = obstacle.mesh;
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    return allBelow(t.vertex_indices, mesh.vertices.size());
  });
}

/// A recorded sheet may be anyone's.
bool allVerticesExist(const msg::Sheet& sheet) {
  const std::size_t count = sheet.flat_positions.size();
  return std::all_of(sheet.triangles.begin(), sheet.triangles.end(),
                     [&](const auto& t) { return allBelow(t.vertex_indices, count); }) &&
         std::all_of(sheet.creases.begin(), sheet.creases.end(),
                     [&](const auto& c) { return allBelow(c.vertices, count); }) &&
         std::all_of(sheet.obstacles.begin(), sheet.obstacles.end(), allCornersExist);
}

}  // namespace

void MarkerPainter::setSheet(const msg::Sheet& sheet) {
  sheet_ = allVerticesExist(sheet) ? sheet : msg::Sheet();
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& triangle : sheet_.triangles) {
    const auto& v = triangle.vertex_indices;
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(v[k], v[(k + 1) % 3]);
      ++sides[{a, b}];
    }
  }
  border_.clear();
  for (const auto& [edge, count] : sides) {
    if (count == 1) border_.push_back(edge);
  }
  on_crease_.assign(sheet_.flat_positions.size(), false);
  for (const msg::Crease& crease : sheet_.creases) {
    for (const std::uint32_t v : crease.vertices) on_crease_[v] = true;
  }
  size_ = sheetSize(sheet_);
  colours_.setSheet(sheet_);
}

void MarkerPainter::choose(const MarkerOptions& options, Coloring colouring) {
  labels_.choose(options);
  if (colours_.coloring() == colouring) return;
  colours_.choose(colouring);
  colours_.setSheet(sheet_);
}

bool MarkerPainter::fits(const msg::SheetState& state) const {
  return state.revision == sheet_.revision && !sheet_.triangles.empty() &&
         state.positions.size() == sheet_.flat_positions.size() &&
         state.creases.size() == sheet_.creases.size() &&
         state.obstacles.size() == sheet_.obstacles.size() &&
         (state.pressures.empty() || state.pressures.size() == state.positions.size()) &&
         allBelow(state.pinned, state.positions.size()) &&
         allBelow(state.grasped, state.positions.size());
}

visualization_msgs::MarkerArray MarkerPainter::draw(const msg::SheetState& state) {
  header_.stamp = state.header.stamp;
  header_.frame_id = state.header.frame_id;
  Points middle(3, state.positions.size());
  for (std::size_t i = 0; i < state.positions.size(); ++i) {
    const auto& p = state.positions[i];
    middle.col(static_cast<Eigen::Index>(i)) << p.x, p.y, p.z;
  }
  const Points normal = normals(middle);
  // Lines lie on top of both sides: between them they would not be seen.
  const double lift = size_ / 1000;
  const std::vector<Points> tops = {middle + lift * normal, middle - lift * normal};

  visualization_msgs::MarkerArray array;
  const std::vector<SheetColours::Sides> colours = colours_.draw(middle, state.pressures);
  array.markers.push_back(side(true, middle, normal, colours));
  array.markers.push_back(side(false, middle, normal, colours));
  array.markers.push_back(creases(tops, state));
  array.markers.push_back(border(tops));
  array.markers.push_back(held("pins", middle, state.pinned, kPin));
  array.markers.push_back(held("grasps", middle, state.grasped, kGrasp));
  array.markers.push_back(contactPoints(state));
  array.markers.push_back(
      obstacleMarker(sheet_.obstacles, state.obstacles, middle, size_, header_));
  const double ground = this->ground(middle, state);
  array.markers.push_back(shadow(middle, size_, ground, sheet_, header_));
  array.markers.push_back(groundGrid(middle, size_, ground, header_));
  labels_.draw(sheet_, state, middle, normal, size_, array);
  if (showsPressures()) array.markers.push_back(pressureLabel(state, middle, size_, header_));
  return array;
}

/// The height of the table that the paper is above, or else of the ground.
double MarkerPainter::ground(const Points& points, const msg::SheetState& state) const {
  const auto table = tableHeight(sheet_.obstacles, state.obstacles, size_);
  return table ? *table : groundUnder(points, size_, sheet_.ground);
}

/// Sums of the triangles' area vectors, normalised; zero where they cancel.
Points MarkerPainter::normals(const Points& points) const {
  Points result = Points::Zero(3, points.cols());
  for (const auto& triangle : sheet_.triangles) {
    const Eigen::Vector3d area = areaVector(points, triangle.vertex_indices);
    for (const std::uint32_t i : triangle.vertex_indices) result.col(i) += area;
  }
  for (Eigen::Index i = 0; i < result.cols(); ++i) result.col(i).stableNormalize();
  return result;
}

/// Triangles a hair off the middle of the paper. Where a vertex lies on a crease, each triangle is
/// lifted along its own normal: the two flaps have no common one.
MarkerPainter::Marker MarkerPainter::side(bool front, const Points& middle, const Points& normals,
                                          const std::vector<SheetColours::Sides>& colours) const {
  const double gap = (front ? 1 : -1) * kGap * size_;
  Marker marker = newMarker(front ? "front" : "back", Marker::TRIANGLE_LIST, header_);
  marker.color.a = 1;
  marker.points.reserve(3 * sheet_.triangles.size());
  marker.colors.reserve(sheet_.triangles.size());
  for (std::size_t i = 0; i < sheet_.triangles.size(); ++i) {
    const auto& v = sheet_.triangles[i].vertex_indices;
    const Eigen::Vector3d area = areaVector(middle, v);
    if (!(area.norm() > 1e-12 * size_ * size_)) continue;  // rviz cannot draw it (rviz #925)
    const Eigen::Vector3d normal = area.normalized();
    marker.colors.push_back(front ? shaded(colours[i].front, normal)
                                  : shaded(colours[i].back, -normal));
    for (const int k : {0, front ? 1 : 2, front ? 2 : 1}) {
      const Eigen::Vector3d lift = on_crease_[v[k]] ? normal : normals.col(v[k]);
      marker.points.push_back(markerPoint(middle.col(v[k]) + gap * lift));
    }
  }
  return finished(marker);
}

MarkerPainter::Marker MarkerPainter::creases(const std::vector<Points>& sides,
                                             const msg::SheetState& state) const {
  Marker marker = newMarker("creases", Marker::LINE_LIST, header_);
  marker.scale.x = size_ / 150;
  for (std::size_t c = 0; c < sheet_.creases.size(); ++c) {
    const std::vector<std::uint32_t>& line = sheet_.creases[c].vertices;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      for (const Points& points : sides) {
        marker.points.push_back(markerPoint(points.col(line[i])));
        marker.points.push_back(markerPoint(points.col(line[i + 1])));
      }
    }
    marker.colors.resize(marker.points.size(), creaseColor(state.creases[c].angle));
  }
  return finished(marker);
}

MarkerPainter::Marker MarkerPainter::border(const std::vector<Points>& sides) const {
  Marker marker = newMarker("border", Marker::LINE_LIST, header_);
  marker.scale.x = size_ / 300;
  marker.color = kBorder;
  for (const auto& [a, b] : border_) {
    for (const Points& points : sides) {
      marker.points.push_back(markerPoint(points.col(a)));
      marker.points.push_back(markerPoint(points.col(b)));
    }
  }
  return finished(marker);
}

MarkerPainter::Marker MarkerPainter::held(const std::string& name, const Points& points,
                                          const std::vector<std::uint32_t>& vertices,
                                          const std_msgs::ColorRGBA& color) const {
  Marker marker = newMarker(name, Marker::SPHERE_LIST, header_);
  marker.scale.x = marker.scale.y = marker.scale.z = size_ / 50;
  marker.color = color;
  for (const std::uint32_t v : vertices) marker.points.push_back(markerPoint(points.col(v)));
  return finished(marker);
}

/// On both sides of the two layers, as lines are: between them nothing would be seen.
MarkerPainter::Marker MarkerPainter::contactPoints(const msg::SheetState& state) const {
  Marker marker = newMarker("contact_points", Marker::SPHERE_LIST, header_);
  marker.scale.x = marker.scale.y = marker.scale.z = size_ / 120;
  marker.color.a = 1;
  if (!showsContactPoints()) return finished(marker);
  for (const msg::ContactPoint& contact : state.contact_points) {
    const auto& p = contact.position;
    const Eigen::Vector3d force(contact.force.x, contact.force.y, contact.force.z);
    const Eigen::Vector3d lift = size_ / 150 * force.stableNormalized();
    for (const double side : {-1, 1}) {
      marker.points.push_back(markerPoint(Eigen::Vector3d(p.x, p.y, p.z) + side * lift));
      marker.colors.push_back(contactColor(force.norm()));
    }
  }
  return finished(marker);
}

}  // namespace shell_origami
