#include <shell_origami/node/sense/cloud.h>

#include <Eigen/Geometry>

#include <array>
#include <cstring>
#include <iterator>

namespace shell_origami {
namespace {

constexpr const char* kCloudFields[] = {"x",        "y", "z", "normal_x", "normal_y",
                                        "normal_z", "u", "v", "side"};
using CloudPoint = std::array<float, std::size(kCloudFields)>;

/// Those of the front.
std::vector<Vector3> triangleNormals(const Sheet& sheet, const Positions& x) {
  std::vector<Vector3> normals;
  normals.reserve(sheet.triangles().size());
  for (const auto& [a, b, c] : sheet.triangles()) {
    const Vector3 ab = x.col(b) - x.col(a), ac = x.col(c) - x.col(a);
    normals.push_back(ab.cross(ac).normalized());
  }
  return normals;
}

std::vector<sensor_msgs::PointField> cloudFields() {
  std::vector<sensor_msgs::PointField> fields;
  for (const char* name : kCloudFields) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    fields.push_back(field);
  }
  return fields;
}

CloudPoint cloudPoint(const Vector3& position, const Vector3& normal, const Vector2& flat,
                      float side) {
  const Eigen::Vector3f x = position.cast<float>(), n = normal.cast<float>();
  const Eigen::Vector2f u = flat.cast<float>();
  return {x[0], x[1], x[2], n[0], n[1], n[2], u[0], u[1], side};
}

}  // namespace

void writeCloud(const std::vector<MaterialPoint>& points, const Sheet& sheet,
                const Positions& positions, sensor_msgs::PointCloud2& cloud) {
  if (cloud.fields.empty()) cloud.fields = cloudFields();
  cloud.point_step = sizeof(CloudPoint);
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(2 * points.size());
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = 1;
  cloud.data.resize(cloud.row_step);
  const std::vector<Vector3> normals = triangleNormals(sheet, positions);
  std::uint8_t* front = cloud.data.data();
  std::uint8_t* back = front + points.size() * sizeof(CloudPoint);
  const auto write = [](const CloudPoint& point, std::uint8_t*& to) {
    std::memcpy(to, point.data(), sizeof point);
    to += sizeof point;
  };
  for (const MaterialPoint& point : points) {
    const Vector3 position = inSpace(point, sheet, positions);
    const Vector3& normal = normals[point.place.triangle];
    write(cloudPoint(position, normal, point.flat, kFrontSide), front);
    write(cloudPoint(position, -normal, point.flat, kBackSide), back);
  }
}

CloudPublisher::CloudPublisher(ros::NodeHandle& node, int points)
    : count_(points), cloud_(node.advertise<sensor_msgs::PointCloud2>("cloud", 5)) {}

void CloudPublisher::publish(const Sheet& sheet, const Positions& positions,
                             const std_msgs::Header& header) {
  if (!heard()) return;
  if (!points_) points_ = sampleSheet(sheet, count_ / 2.0);
  message_.header = header;
  writeCloud(*points_, sheet, positions, message_);
  cloud_.publish(message_);
}

}  // namespace shell_origami
