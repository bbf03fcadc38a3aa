#include <shell_origami/rviz/plugin/fold_messages.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

geometry_msgs::Point flatMessage(const Vector2& flat) {
  geometry_msgs::Point point;
  point.x = flat.x();
  point.y = flat.y();
  return point;
}

msg::Landmark landmarkAt(const Vector2& flat) {
  msg::Landmark landmark;
  landmark.flat = flatMessage(flat);
  return landmark;
}

}  // namespace

msg::FoldThrough::Request foldThroughRequest(const LaidFold& fold, const SeenFold& seen,
                                             const std::string& name) {
  msg::FoldThrough::Request request;
  request.axiom = fold.bring ? "bring" : "through";
  request.points = {landmarkAt(fold.first.flat), landmarkAt(fold.second.flat)};
  if (!fold.bring) request.points.push_back(landmarkAt(seen.moving));
  if (fold.reach == FoldReach::kTop) {
    request.layers = "top";
    request.count = 1;
  } else if (fold.reach == FoldReach::kFlap) {
    request.layers = "flap";
    request.flap = landmarkAt(seen.moving);
  }
  request.way = fold.angle > 0 ? "front" : "behind";
  request.angle = std::abs(fold.angle);
  request.viewer.x = seen.viewer.x();
  request.viewer.y = seen.viewer.y();
  request.viewer.z = seen.viewer.z();
  request.name = name;
  return request;
}

msg::Fold::Request foldRequest(const LaidFold& fold, bool front, const std::string& name) {
  msg::Fold::Request request;
  request.line = {flatMessage(fold.first.flat), flatMessage(fold.second.flat)};
  request.angle = front ? fold.angle : -fold.angle;
  request.name = name;
  return request;
}

msg::Fold::Request foldRequest(const TurnCrease& turn, const Sheet& sheet) {
  const Crease& crease = sheet.creases()[turn.crease];
  const auto& all = sheet.creases();
  const auto same_name = [&](const Crease& other) { return other.name == crease.name; };
  msg::Fold::Request request;
  request.angle = turn.angle;
  if (std::count_if(all.begin(), all.end(), same_name) == 1) {
    request.crease = crease.name;
  } else {
    request.vertices = {static_cast<std::uint32_t>(crease.vertices.front()),
                        static_cast<std::uint32_t>(crease.vertices.back())};
  }
  return request;
}

msg::AddVertex::Request addVertexRequest(const PaperPlace& place, const Sheet& sheet) {
  const Triangle& corners = sheet.triangles()[place.triangle];
  const auto& flat = sheet.flatPositions();
  // The distance from the edge opposite to a corner is that corner's weight times its height.
  const double area = doubleArea(flat[corners[0]], flat[corners[1]], flat[corners[2]]);
  int apex = 0;
  double least = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const double edge = (flat[corners[(k + 1) % 3]] - flat[corners[(k + 2) % 3]]).norm();
    const double distance = place.weights[k] * area / edge;
    if (distance < least) {
      least = distance;
      apex = k;
    }
  }
  const int a = (apex + 1) % 3, b = (apex + 2) % 3;
  msg::AddVertex::Request request;
  request.edge = {static_cast<std::uint32_t>(corners[a]), static_cast<std::uint32_t>(corners[b])};
  request.fraction = place.weights[b] / (place.weights[a] + place.weights[b]);
  return request;
}

}  // namespace shell_origami
