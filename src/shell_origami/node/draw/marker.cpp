#include <shell_origami/node/draw/marker.h>

namespace shell_origami {

using visualization_msgs::Marker;

geometry_msgs::Point markerPoint(const Eigen::Vector3d& p) {
  geometry_msgs::Point result;
  result.x = p.x();
  result.y = p.y();
  result.z = p.z();
  return result;
}

Marker newMarker(const std::string& name, int type, const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  return marker;
}

Marker finished(Marker marker) {
  if (marker.points.empty()) marker.action = Marker::DELETE;
  return marker;
}

const Eigen::Vector3d& lightDirection() {
  static const Eigen::Vector3d kLight = Eigen::Vector3d(0.35, -0.25, 0.9).normalized();
  return kLight;
}

}  // namespace shell_origami
