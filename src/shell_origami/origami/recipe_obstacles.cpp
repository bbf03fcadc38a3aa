#include <shell_origami/origami/recipe_obstacles.h>

#include <shell_origami/base/files.h>
#include <shell_origami/origami/surface_file.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

namespace shell_origami {
namespace {

namespace fs = std::filesystem;

/// How a shape is placed: a plane has a pose of its own within the obstacle's.
struct PlacedShape {
  ObstacleShape shape;
  Pose pose = {};
};

RecipeReader::Handlers poseHandlers(const RecipeReader& reader, Pose& pose) {
  return {{"position",
           [&](const YAML::Node& value) { reader.read(value, "position", &pose.position); }},
          {"rpy_deg",
           [&](const YAML::Node& value) {
             const auto angles = reader.numbers(value, 3, "rpy_deg");
             pose.orientation = Eigen::AngleAxisd(kDegree * angles[2], Vector3::UnitZ()) *
                                Eigen::AngleAxisd(kDegree * angles[1], Vector3::UnitY()) *
                                Eigen::AngleAxisd(kDegree * angles[0], Vector3::UnitX());
           }},
          {"orientation", [&](const YAML::Node& value) {
             const auto q = reader.numbers(value, 4, "orientation");
             pose.orientation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
           }}};
}

PlacedShape readPlane(const RecipeReader& reader, const YAML::Node& node) {
  Vector3 point = Vector3::Zero(), normal = Vector3::UnitZ();
  reader.readMap(
      node, "plane",
      {{"point", [&](const YAML::Node& value) { reader.read(value, "point", &point); }},
       {"normal", [&](const YAML::Node& value) { reader.read(value, "normal", &normal); }}});
  if (!(normal.norm() > 0)) reader.refuseAt(node, "a plane's normal has no direction");
  return {HalfSpace{}, {point, Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), normal)}};
}

ObstacleShape readCylinder(const RecipeReader& reader, const YAML::Node& node) {
  Cylinder cylinder{0, 0};
  reader.readMap(node, "cylinder",
                 {{"radius", reader.into(&cylinder.radius, "radius")},
                  {"length", reader.into(&cylinder.length, "length")}});
  return cylinder;
}

ObstacleShape readMesh(const RecipeReader& reader, const YAML::Node& node,
                       const std::string& folder) {
  std::string path;
  Vector3 scale = Vector3::Ones();
  if (node.IsScalar()) {
    path = reader.text(node, "mesh");
  } else {
    reader.readMap(node, "mesh",
                   {{"path", reader.into(&path, "path")}, {"scale", [&](const YAML::Node& value) {
                                                             reader.read(value, "scale", &scale);
                                                           }}});
  }
  const std::string file = (fs::path(folder) / expandedPath(path)).string();
  try {
    return MeshShape{std::make_shared<const Surface>(readSurface(file, scale)), file, scale};
  } catch (const std::invalid_argument& error) {
    reader.refuseAt(node, error.what());
  }
}

AddObstacleEdit readObstacle(const RecipeReader& reader, const YAML::Node& node,
                             const std::string& folder) {
  AddObstacleEdit edit;
  std::vector<PlacedShape> shapes;
  RecipeReader::Handlers handlers = poseHandlers(reader, edit.pose);
  handlers["id"] = reader.into(&edit.id, "id");
  handlers["friction"] = [&](const YAML::Node& value) {
    edit.friction = reader.number(value, "friction");
  };
  handlers["plane"] = [&](const YAML::Node& value) { shapes.push_back(readPlane(reader, value)); };
  handlers["box"] = [&](const YAML::Node& value) {
    Box box{Vector3::Zero()};
    reader.read(value, "box", &box.size);
    shapes.push_back({box});
  };
  handlers["sphere"] = [&](const YAML::Node& value) {
    shapes.push_back({Sphere{reader.number(value, "sphere")}});
  };
  handlers["cylinder"] = [&](const YAML::Node& value) {
    shapes.push_back({readCylinder(reader, value)});
  };
  handlers["mesh"] = [&](const YAML::Node& value) {
    shapes.push_back({readMesh(reader, value, folder)});
  };
  reader.readMap(node, "an obstacle", handlers);
  if (edit.id.empty()) reader.refuseAt(node, "an obstacle needs an id");
  if (shapes.size() != 1) {
    reader.refuseAt(node, "obstacle '", edit.id,
                    "' takes one of plane, box, sphere, cylinder and mesh, not ", shapes.size());
  }
  edit.shape = std::move(shapes[0].shape);
  if (std::holds_alternative<HalfSpace>(edit.shape)) edit.pose = edit.pose * shapes[0].pose;
  try {
    checkShape(edit.shape);
    checkPose(edit.pose);
  } catch (const std::invalid_argument& error) {
    reader.refuseAt(node, error.what());
  }
  return edit;
}

struct ShapeText {
  YamlMap& entries;

  void operator()(const HalfSpace&) const { entries.add("plane", "{}"); }
  void operator()(const Box& box) const { entries.add("box", numbers(box.size)); }
  void operator()(const Sphere& sphere) const { entries.add("sphere", numberText(sphere.radius)); }
  void operator()(const Cylinder& cylinder) const {
    YamlMap sizes;
    sizes.add("radius", numberText(cylinder.radius)).add("length", numberText(cylinder.length));
    entries.add("cylinder", sizes.text());
  }
  void operator()(const MeshShape& mesh) const {
    YamlMap file;
    file.add("path", word(fs::absolute(mesh.path).string())).add("scale", numbers(mesh.scale));
    entries.add("mesh", file.text());
  }
};

}  // namespace

std::vector<AddObstacleEdit> readObstacles(const RecipeReader& reader, const YAML::Node& node,
                                           const std::string& folder) {
  if (node.IsMap()) return {readObstacle(reader, node, folder)};
  if (!node.IsSequence()) reader.refuseAt(node, "obstacles must be a list of them");
  std::vector<AddObstacleEdit> obstacles;
  for (const YAML::Node& entry : node) obstacles.push_back(readObstacle(reader, entry, folder));
  return obstacles;
}

Pose readPose(const RecipeReader& reader, const YAML::Node& node, const std::string& what) {
  Pose pose;
  reader.readMap(node, what, poseHandlers(reader, pose));
  return pose;
}

std::string obstacleText(const AddObstacleEdit& edit) {
  YamlMap entries;
  entries.add("id", word(edit.id));
  std::visit(ShapeText{entries}, edit.shape);
  addPose(edit.pose, entries);
  if (edit.friction) entries.add("friction", numberText(*edit.friction));
  return entries.text();
}

void addPose(const Pose& pose, YamlMap& entries) {
  entries.add("position", numbers(pose.position));
  const auto& q = pose.orientation;
  if (q.coeffs() == Eigen::Quaterniond::Identity().coeffs()) return;
  entries.add("orientation", list(std::vector<double>{q.x(), q.y(), q.z(), q.w()}, numberText));
}

}  // namespace shell_origami
