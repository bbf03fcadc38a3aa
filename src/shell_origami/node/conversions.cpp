#include <shell_origami/node/conversions.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/draw/ground.h>
#include <shell_origami/node/draw/sheet_measures.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

geometry_msgs::Point32 point32(double x, double y, double z) {
  geometry_msgs::Point32 point;
  point.x = static_cast<float>(x);
  point.y = static_cast<float>(y);
  point.z = static_cast<float>(z);
  return point;
}

template <class Point>
std::vector<Vector2> flatPoints(const std::string& name, const std::vector<Point>& points) {
  std::vector<Vector2> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    requireFinite(name + "[" + std::to_string(i) + "]", points[i]);
    result.emplace_back(points[i].x, points[i].y);
  }
  return result;
}

void requireTwo(const std::string& name, std::size_t count) {
  if (count != 2) reject(name, " must hold two entries, but holds ", count);
}

/// A field of a request that is zero when it is left open.
std::optional<double> unlessZero(double value) {
  return value == 0 ? std::nullopt : std::optional<double>(value);
}

}  // namespace

void requireOne(const std::vector<std::pair<std::string, bool>>& alternatives) {
  std::string all, given;
  int count = 0;
  for (const auto& [name, is_given] : alternatives) {
    all += (all.empty() ? "" : ", ") + name;
    if (is_given) given += (count++ ? " and " : "") + name;
  }
  if (count == 1) return;
  reject("give exactly one of ", all, ": the request gives ", count ? given : "none of them");
}

std::vector<msg::Obstacle> obstacleMessages(const Simulation& simulation) {
  std::vector<msg::Obstacle> messages;
  const std::vector<Body> bodies = simulation.obstacles().bodies(0);
  auto body = bodies.begin();
  for (const auto& [id, obstacle] : simulation.obstacles().all()) {
    const Surface& surface = *(body++)->surface;
    msg::Obstacle message;
    message.id = id;
    message.half_space = surface.half_space;
    messages.push_back(message);
    if (surface.half_space) continue;
    shape_msgs::Mesh& mesh = messages.back().mesh;
    for (Eigen::Index v = 0; v < surface.vertices.cols(); ++v) {
      mesh.vertices.push_back(pointMessage(surface.vertices.col(v)));
    }
    for (const Triangle& t : surface.faces) {
      mesh.triangles.emplace_back();
      for (int k = 0; k < 3; ++k) {
        mesh.triangles.back().vertex_indices[k] = static_cast<std::uint32_t>(t[k]);
      }
    }
  }
  return messages;
}

msg::Sheet sheetMessage(const Session& session, const std_msgs::Header& header) {
  const Sheet& sheet = session.simulation().sheet();
  msg::Sheet message;
  message.header = header;
  message.revision = session.revision();
  for (const Vector2& p : sheet.flatPositions()) {
    message.flat_positions.push_back(point32(p.x(), p.y(), 0));
  }
  message.triangles.resize(sheet.triangles().size());
  for (std::size_t i = 0; i < sheet.triangles().size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      message.triangles[i].vertex_indices[k] = static_cast<std::uint32_t>(sheet.triangles()[i][k]);
    }
  }
  for (const Crease& crease : sheet.creases()) {
    msg::Crease entry;
    entry.id = crease.id;
    entry.name = crease.name;
    entry.vertices = vertexIds(crease.vertices);
    message.creases.push_back(entry);
  }
  message.obstacles = obstacleMessages(session.simulation());
  message.ground =
      static_cast<float>(groundBelow(session.original().motion.positions, sheetSize(message)));
  return message;
}

Sheet sheetFrom(const msg::Sheet& message) {
  std::vector<Vector2> points;
  for (const geometry_msgs::Point32& p : message.flat_positions) points.emplace_back(p.x, p.y);
  std::vector<Triangle> triangles;
  for (const shape_msgs::MeshTriangle& triangle : message.triangles) {
    const auto& v = triangle.vertex_indices;
    triangles.push_back({static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2])});
  }
  return Sheet(Triangulation(std::move(points), std::move(triangles)));
}

Positions positionsFrom(const msg::SheetState& message) {
  Positions positions(3, message.positions.size());
  for (std::size_t v = 0; v < message.positions.size(); ++v) {
    const geometry_msgs::Point32& p = message.positions[v];
    positions.col(static_cast<Eigen::Index>(v)) = Vector3(p.x, p.y, p.z);
  }
  return positions;
}

std::vector<msg::CreaseState> creaseStates(const Simulation& simulation) {
  std::vector<msg::CreaseState> states;
  for (const CreaseStatus& crease : simulation.creases()) {
    msg::CreaseState state;
    state.id = crease.id;
    state.angle = static_cast<float>(crease.angle);
    state.rest_angle = static_cast<float>(crease.rest_angle);
    state.target_angle = static_cast<float>(crease.target_angle);
    state.moment = static_cast<float>(crease.moment);
    states.push_back(state);
  }
  return states;
}

msg::SheetState stateMessage(const Session& session, bool paused, const std_msgs::Header& header) {
  const Simulation& simulation = session.simulation();
  msg::SheetState message;
  message.header = header;
  message.revision = session.revision();
  message.step = session.steps();
  message.edits = session.edits();
  const Positions& x = simulation.positions();
  message.positions.reserve(static_cast<std::size_t>(x.cols()));
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    message.positions.push_back(point32(x(0, i), x(1, i), x(2, i)));
  }
  message.creases = creaseStates(simulation);
  message.pinned.assign(simulation.pinned().begin(), simulation.pinned().end());
  for (const auto& [id, grasp] : simulation.grasps().all()) {
    for (const auto& [v, vertex] : grasp.vertices) {
      message.grasped.push_back(static_cast<std::uint32_t>(v));
    }
  }
  for (const auto& [id, obstacle] : simulation.obstacles().all()) {
    message.obstacles.push_back(poseMessage(obstacle.pose()));
  }
  message.settled = simulation.settled();
  message.paused = paused;
  message.max_strain = static_cast<float>(simulation.maxStrain());
  message.soft = simulation.soft();
  return message;
}

void addContactForces(const Simulation& simulation, bool pressures, bool points,
                      msg::SheetState& message) {
  if (!pressures && !points) return;
  const std::vector<ContactForce> forces = simulation.contactForces();
  if (pressures) {
    for (const double pressure : contactPressures(simulation.sheet(), forces)) {
      message.pressures.push_back(static_cast<float>(pressure));
    }
  }
  if (!points) return;
  for (const ContactForce& force : forces) {
    msg::ContactPoint point;
    point.position = point32(force.point.x(), force.point.y(), force.point.z());
    point.force.x = force.force.x();
    point.force.y = force.force.y();
    point.force.z = force.force.z();
    message.contact_points.push_back(point);
  }
}

msg::Energy energyMessage(const Session& session, const StepReport& step, double real_time_factor,
                          const std_msgs::Header& header) {
  const Energies energies = session.simulation().energies();
  const std::vector<Contact> contacts = session.simulation().contacts();
  msg::Energy message;
  message.header = header;
  message.membrane = energies.membrane;
  message.bending = energies.bending;
  message.strain_energy = energies.strain();
  message.kinetic = energies.kinetic;
  message.gravity = energies.gravity;
  message.contact = energies.contact;
  message.contacts = static_cast<std::uint32_t>(contacts.size());
  message.min_gap = smallestGap(contacts);
  message.newton_iterations = static_cast<std::uint32_t>(step.newton_iterations);
  message.residual = step.newton_step_rate;
  message.max_strain = session.simulation().maxStrain();
  message.real_time_factor = real_time_factor;
  return message;
}

FoldEdit foldEdit(const msg::Fold::Request& request) {
  requireOne({{"crease", !request.crease.empty()},
              {"vertices", !request.vertices.empty()},
              {"line", !request.line.empty()}});
  FoldEdit fold;
  if (!request.crease.empty()) {
    fold.where = CreaseName{request.crease};
  } else if (!request.vertices.empty()) {
    requireTwo("vertices", request.vertices.size());
    fold.where = VertexPair{{request.vertices[0], request.vertices[1]}};
  } else {
    requireTwo("line", request.line.size());
    const std::vector<Vector2> ends = flatPoints("line", request.line);
    for (std::size_t i = 0; i < request.line.size(); ++i) {
      const geometry_msgs::Point& p = request.line[i];
      if (p.z == 0) continue;
      reject("line[", i, "] is (", p.x, ", ", p.y, ", ", p.z,
             "), but its z must be 0: a line is given on the flat sheet, not on folded paper");
    }
    fold.where = Segment{ends[0], ends[1]};
  }
  fold.angle = request.angle;
  fold.part = request.part;
  fold.duration = unlessZero(request.duration);
  fold.stiffness = unlessZero(request.stiffness);
  if (!request.name.empty()) {
    if (!request.crease.empty()) {
      reject("name is \"", request.name, "\", but the crease \"", request.crease, "\" has its own");
    }
    checkCreaseName(request.name);
    fold.name = request.name;
  }
  return fold;
}

namespace {

/// Of requests that have the fields in which one chooses vertices.
template <class Request>
PinWhere chosenVertices(const Request& request) {
  const geometry_msgs::Point& center = request.center.point;
  const bool has_center = request.radius != 0 || !request.center.header.frame_id.empty() ||
                          center.x != 0 || center.y != 0 || center.z != 0;
  requireOne({{"vertices", !request.vertices.empty()},
              {"points", !request.points.empty()},
              {"region", !request.region.points.empty()},
              {"center with radius", has_center}});
  if (!request.vertices.empty()) return vertexIds(request.vertices);
  if (!request.points.empty()) return flatPoints("points", request.points);
  if (!request.region.points.empty()) return Region{flatPoints("region", request.region.points)};
  requireFinite("center", center);
  return Ball{{center.x, center.y, center.z}, request.radius};
}

}  // namespace

PinWhere pinWhere(const msg::Pin::Request& request) { return chosenVertices(request); }
PinWhere pinWhere(const msg::Grasp::Request& request) { return chosenVertices(request); }

geometry_msgs::Point pointMessage(const Vector3& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

geometry_msgs::Pose poseMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = pointMessage(pose.position);
  message.orientation.x = pose.orientation.x();
  message.orientation.y = pose.orientation.y();
  message.orientation.z = pose.orientation.z();
  message.orientation.w = pose.orientation.w();
  return message;
}

Pose poseFrom(const geometry_msgs::Pose& message) {
  const auto& p = message.position;
  const auto& q = message.orientation;
  return {{p.x, p.y, p.z}, {q.w, q.x, q.y, q.z}};
}

geometry_msgs::Wrench wrenchMessage(const Wrench& wrench) {
  geometry_msgs::Wrench message;
  message.force.x = wrench.force.x();
  message.force.y = wrench.force.y();
  message.force.z = wrench.force.z();
  message.torque.x = wrench.torque.x();
  message.torque.y = wrench.torque.y();
  message.torque.z = wrench.torque.z();
  return message;
}

Vector3 clickedPoint(const geometry_msgs::PointStamped& click) {
  requireFinite("the click", click.point);
  return {click.point.x, click.point.y, click.point.z};
}

msg::Picked pickedMessage(const Session& session, const Vector3& clicked,
                          const std_msgs::Header& header) {
  const Simulation& simulation = session.simulation();
  const Positions& positions = simulation.positions();
  int vertex = 0;
  const double squared = (positions.colwise() - clicked).colwise().squaredNorm().minCoeff(&vertex);
  const Vector2& flat = simulation.sheet().flatPositions()[vertex];
  msg::Picked message;
  message.header = header;
  message.revision = session.revision();
  message.vertex = static_cast<std::uint32_t>(vertex);
  message.flat_position = pointMessage({flat.x(), flat.y(), 0});
  message.position = pointMessage(positions.col(vertex));
  message.distance = std::sqrt(squared);
  for (const Crease& crease : simulation.sheet().creases()) {
    const std::vector<int>& along = crease.vertices;
    if (std::find(along.begin(), along.end(), vertex) == along.end()) continue;
    if (message.crease_ids.empty()) message.crease = crease.name;
    message.crease_ids.push_back(crease.id);
  }
  return message;
}

std::vector<std::uint32_t> vertexIds(const std::vector<int>& vertices) {
  return {vertices.begin(), vertices.end()};
}

std::vector<std::int64_t> vertexIds(const std::vector<std::uint32_t>& vertices) {
  return {vertices.begin(), vertices.end()};
}

}  // namespace shell_origami
