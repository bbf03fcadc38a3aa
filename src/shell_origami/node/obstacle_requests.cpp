#include <shell_origami/node/obstacle_requests.h>

#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/origami/surface_file.h>

#include <ros/package.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

namespace shell_origami {
namespace {

using shape_msgs::SolidPrimitive;

ObstacleShape primitiveShape(const SolidPrimitive& primitive) {
  const auto need = [&](std::size_t count, const char* what) {
    if (primitive.dimensions.size() == count) return;
    reject(what, " has ", primitive.dimensions.size(), " dimensions, but needs ", count);
  };
  const auto& sizes = primitive.dimensions;
  switch (primitive.type) {
    case SolidPrimitive::BOX: need(3, "a box"); return Box{{sizes[0], sizes[1], sizes[2]}};
    case SolidPrimitive::SPHERE: need(1, "a sphere"); return Sphere{sizes[0]};
    case SolidPrimitive::CYLINDER:
      need(2, "a cylinder");
      return Cylinder{sizes[SolidPrimitive::CYLINDER_RADIUS],
                      sizes[SolidPrimitive::CYLINDER_HEIGHT]};
    default:
      reject("primitive.type is ", static_cast<int>(primitive.type),
             ", but must be a box (1), a sphere (2) or a cylinder (3)");
  }
}

/// Where the half space under a plane is, in the frame of the plane.
Pose planePose(const shape_msgs::Plane& plane) {
  const Vector3 normal(plane.coef[0], plane.coef[1], plane.coef[2]);
  const double length = normal.norm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(plane.coef[3])) {
    reject("plane has the coefficients ", plane.coef[0], ", ", plane.coef[1], ", ", plane.coef[2],
           ", ", plane.coef[3], ", of which the first three must be a finite normal");
  }
  return {-plane.coef[3] / (length * length) * normal,
          Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), normal)};
}

/// The file that a URI of a mesh names.
std::string fileOf(const std::string& mesh) {
  const std::string package = "package://", file = "file://";
  if (mesh.compare(0, file.size(), file) == 0) return mesh.substr(file.size());
  if (mesh.compare(0, package.size(), package) != 0) {
    return std::filesystem::absolute(expandedPath(mesh)).string();
  }
  const std::size_t slash = mesh.find('/', package.size());
  const std::string name = mesh.substr(package.size(), slash - package.size());
  const std::string folder = ros::package::getPath(name);
  if (folder.empty() || slash == std::string::npos) {
    reject("mesh is \"", mesh, "\", but there is no package \"", name, "\"");
  }
  return folder + mesh.substr(slash);
}

ObstacleShape meshShape(const std::string& mesh, const geometry_msgs::Vector3& scale) {
  Vector3 factors(scale.x, scale.y, scale.z);
  if (factors.isZero(0)) factors.setOnes();
  const std::string file = fileOf(mesh);
  return MeshShape{std::make_shared<const Surface>(readSurface(file, factors)), file, factors};
}

Pose requestedPose(const geometry_msgs::Pose& message) {
  Pose pose = poseFrom(message);
  // Left open.
  if (pose.orientation.coeffs().isZero(0)) pose.orientation = Eigen::Quaterniond::Identity();
  checkPose(pose);
  return pose;
}

}  // namespace

AddObstacleEdit obstacleEdit(const msg::AddObstacle::Request& request) {
  const auto& coefficients = request.plane.coef;
  const bool plane = std::any_of(coefficients.begin(), coefficients.end(),
                                 [](double number) { return number != 0; });
  requireOne({{"primitive", request.primitive.type != 0 || !request.primitive.dimensions.empty()},
              {"plane", plane},
              {"mesh", !request.mesh.empty()}});
  AddObstacleEdit edit;
  edit.id = request.id;
  edit.pose = requestedPose(request.pose.pose);
  if (plane) {
    edit.shape = HalfSpace{};
    edit.pose = edit.pose * planePose(request.plane);
  } else if (!request.mesh.empty()) {
    edit.shape = meshShape(request.mesh, request.scale);
  } else {
    edit.shape = primitiveShape(request.primitive);
  }
  checkShape(edit.shape);
  // Not a number is no negative one.
  if (!(request.friction < 0)) edit.friction = request.friction;
  return edit;
}

}  // namespace shell_origami
