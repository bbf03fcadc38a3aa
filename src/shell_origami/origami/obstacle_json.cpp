#include <shell_origami/origami/obstacle_json.h>

#include <shell_origami/base/error.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

using Json = nlohmann::json;

Vector3 pointFrom(const Json& json) {
  const auto values = json.get<std::array<double, 3>>();
  return {values[0], values[1], values[2]};
}

Json pointOf(const Vector3& p) { return {p.x(), p.y(), p.z()}; }

struct WriteShape {
  Json operator()(const HalfSpace&) const { return {{"half_space", true}}; }
  Json operator()(const Box& box) const { return {{"box", pointOf(box.size)}}; }
  Json operator()(const Sphere& sphere) const { return {{"sphere", sphere.radius}}; }
  Json operator()(const Cylinder& cylinder) const {
    return {{"cylinder", {cylinder.radius, cylinder.length}}};
  }
  Json operator()(const MeshShape& mesh) const {
    const Positions& places = mesh.surface->vertices;
    return {{"vertices", std::vector<double>(places.data(), places.data() + places.size())},
            {"triangles", mesh.surface->faces},
            {"path", mesh.path},
            {"scale", pointOf(mesh.scale)}};
  }
};

Surface surfaceFrom(const Json& json) {
  Surface surface;
  const auto numbers = json.at("vertices").get<std::vector<double>>();
  if (numbers.size() % 3 != 0)
    reject("the corners of a mesh have ", numbers.size(), " coordinates");
  surface.vertices = Eigen::Map<const Positions>(numbers.data(), 3, numbers.size() / 3);
  surface.faces = json.at("triangles").get<std::vector<Triangle>>();
  return surface;
}

Json write(const Obstacle& obstacle) {
  Json json{{"shape", toJson(obstacle.shape)},
            {"friction", obstacle.friction},
            {"base", toJson(obstacle.base)},
            {"next", toJson(obstacle.next)}};
  if (!obstacle.frame.empty()) {
    json["frame"] = obstacle.frame;
    json["in_base"] = toJson(obstacle.in_base);
  }
  if (obstacle.left > 0) {
    json["left"] = obstacle.left;
    json["due"] = obstacle.due;
    json["target"] = toJson(obstacle.target);
  }
  return json;
}

double positive(double number, const char* what) {
  if (!(number >= 0 && std::isfinite(number))) reject(what, " ", number, " is not positive");
  return number;
}

Obstacle readObstacle(const Json& json) {
  Obstacle obstacle;
  obstacle.shape = shapeFrom(json.at("shape"));
  obstacle.friction = positive(json.at("friction"), "a friction of");
  obstacle.base = poseFrom(json.at("base"));
  obstacle.next = poseFrom(json.at("next"));
  if (json.contains("frame")) {
    obstacle.frame = json.at("frame");
    obstacle.in_base = poseFrom(json.at("in_base"));
  }
  if (json.contains("left")) {
    obstacle.left = positive(json.at("left"), "a time of");
    obstacle.due = json.at("due");
    obstacle.target = poseFrom(json.at("target"));
  }
  return obstacle;
}

}  // namespace

namespace {

Json write(const Grasp& grasp) {
  const Firmness& firmness = grasp.firmness;
  Json vertices = Json::array();
  for (const auto& [v, vertex] : grasp.vertices) {
    vertices.push_back(
        {{"vertex", v}, {"grasped", pointOf(vertex.grasped)}, {"place", pointOf(vertex.place)}});
  }
  return {{"firmness", {firmness.stiffness, firmness.max_force, firmness.reach}},
          {"frame", grasp.frame},
          {"pose", toJson(grasp.pose)},
          {"next", toJson(grasp.next)},
          {"vertices", vertices}};
}

Grasp readGrasp(const Json& json, int vertex_count) {
  const auto numbers = json.at("firmness").get<std::array<double, 3>>();
  Grasp grasp{{numbers[0], numbers[1], numbers[2]},
              json.at("frame"),
              poseFrom(json.at("pose")),
              poseFrom(json.at("next")),
              {}};
  checkFirmness(grasp.firmness);
  for (const Json& entry : json.at("vertices")) {
    const int v = entry.at("vertex");
    if (v < 0 || v >= vertex_count) reject("there is no vertex ", v);
    grasp.vertices[v] = {pointFrom(entry.at("grasped")), pointFrom(entry.at("place"))};
  }
  return grasp;
}

}  // namespace

Json toJson(const Grasps& grasps) {
  Json all = Json::object();
  for (const auto& [id, grasp] : grasps.all()) all[id] = write(grasp);
  return all;
}

Grasps graspsFrom(const Json& json, int vertex_count) {
  std::map<std::string, Grasp> all;
  for (const auto& [id, entry] : json.items()) all[id] = readGrasp(entry, vertex_count);
  return Grasps(std::move(all));
}

Json toJson(const Pose& pose) {
  const auto& q = pose.orientation.coeffs();
  return {{"position", pointOf(pose.position)}, {"orientation", {q[0], q[1], q[2], q[3]}}};
}

Pose poseFrom(const Json& json) {
  const auto q = json.at("orientation").get<std::array<double, 4>>();
  const Pose pose{pointFrom(json.at("position")), Eigen::Quaterniond(q[3], q[0], q[1], q[2])};
  checkPose(pose);
  return pose;
}

Json toJson(const ObstacleShape& shape) { return std::visit(WriteShape{}, shape); }

ObstacleShape shapeFrom(const Json& json) {
  ObstacleShape shape = HalfSpace{};
  if (json.contains("box")) {
    shape = Box{pointFrom(json.at("box"))};
  } else if (json.contains("sphere")) {
    shape = Sphere{json.at("sphere")};
  } else if (json.contains("cylinder")) {
    const auto sizes = json.at("cylinder").get<std::array<double, 2>>();
    shape = Cylinder{sizes[0], sizes[1]};
  } else if (json.contains("vertices")) {
    shape = MeshShape{std::make_shared<const Surface>(surfaceFrom(json)), json.at("path"),
                      pointFrom(json.at("scale"))};
  } else if (!json.contains("half_space")) {
    reject("an obstacle of no shape");
  }
  checkShape(shape);
  return shape;
}

Json toJson(const Obstacles& obstacles) {
  Json all = Json::object();
  for (const auto& [id, obstacle] : obstacles.all()) all[id] = write(obstacle);
  return {{"all", all}, {"pace", obstacles.pace()}};
}

Obstacles obstaclesFrom(const Json& json) {
  std::map<std::string, Obstacle> all;
  for (const auto& [id, entry] : json.at("all").items()) all[id] = readObstacle(entry);
  const double pace = json.at("pace");
  if (!(pace >= 0 && pace <= 1)) reject("a pace of ", pace);
  return Obstacles(std::move(all), pace);
}

}  // namespace shell_origami
