/// \file
/// Between the words of the core and the messages. All units are SI and radians on both sides.
#pragma once

#include <shell_origami/base/error.h>
#include <shell_origami/node/messages.h>
#include <shell_origami/node/session.h>
#include <shell_origami/origami/simulation.h>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Wrench.h>
#include <std_msgs/Header.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

/// The obstacles as viewers draw them.
std::vector<msg::Obstacle> obstacleMessages(const Simulation& simulation);
msg::Sheet sheetMessage(const Session& session, const std_msgs::Header& header);
/// The sheet of a message, without its creases. Its coordinates are rounded to float.
/// \throws std::invalid_argument where it is none
Sheet sheetFrom(const msg::Sheet& message);
std::vector<msg::CreaseState> creaseStates(const Simulation& simulation);
msg::SheetState stateMessage(const Session& session, bool paused, const std_msgs::Header& header);
Positions positionsFrom(const msg::SheetState& message);
/// Adds what only some drawings show.
void addContactForces(const Simulation& simulation, bool pressures, bool points,
                      msg::SheetState& message);
msg::Energy energyMessage(const Session& session, const StepReport& step, double real_time_factor,
                          const std_msgs::Header& header);

/// Rejects z as well where it is not used: a NaN there tells of an error elsewhere.
template <class Point>
void requireFinite(const std::string& name, const Point& p) {
  if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) return;
  reject(name, " is (", p.x, ", ", p.y, ", ", p.z, "), but must be finite");
}

/// The alternatives of a request: their names, and whether each is given.
/// \throws std::invalid_argument unless exactly one is.
void requireOne(const std::vector<std::pair<std::string, bool>>& alternatives);

/// \throws std::invalid_argument unless exactly one of crease, vertices and line is given, with
///         two finite ends.
FoldEdit foldEdit(const msg::Fold::Request& request);

/// The vertices that a request pins or grasps. The center of the ball is not transformed from its
/// frame.
/// \throws std::invalid_argument unless exactly one of vertices, points, region and center with
///         radius is given, with finite numbers.
PinWhere pinWhere(const msg::Pin::Request& request);
PinWhere pinWhere(const msg::Grasp::Request& request);

geometry_msgs::Point pointMessage(const Vector3& p);
geometry_msgs::Pose poseMessage(const Pose& pose);
/// As it stands: its quaternion may be of any length.
Pose poseFrom(const geometry_msgs::Pose& message);
geometry_msgs::Wrench wrenchMessage(const Wrench& wrench);
/// \throws std::invalid_argument unless its numbers are finite.
Vector3 clickedPoint(const geometry_msgs::PointStamped& click);
/// The vertex nearest to a point of the world.
msg::Picked pickedMessage(const Session& session, const Vector3& point,
                          const std_msgs::Header& header);

std::vector<std::uint32_t> vertexIds(const std::vector<int>& vertices);
std::vector<std::int64_t> vertexIds(const std::vector<std::uint32_t>& vertices);

}  // namespace shell_origami
