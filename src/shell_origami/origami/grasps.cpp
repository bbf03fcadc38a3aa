#include <shell_origami/origami/grasps.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <utility>

namespace shell_origami {
namespace {

constexpr double kMostStiffness = 1e6, kMostForce = 1e4, kMostReach = 10;

void checkPositive(const char* what, double value, double most) {
  if (!(value > 0 && value <= most)) {
    reject("a grasp's ", what, " is ", value, ", but must be above 0 and at most ", most);
  }
}

/// The spring of one of its vertices, with the place in the world.
Spring springOf(const Grasp& grasp, int vertex, const Vector3& place) {
  const auto count = static_cast<double>(grasp.vertices.size());
  return {vertex, place, grasp.firmness.stiffness / count, grasp.firmness.max_force / count};
}

}  // namespace

void checkFirmness(const Firmness& firmness) {
  checkPositive("stiffness", firmness.stiffness, kMostStiffness);
  checkPositive("max_force", firmness.max_force, kMostForce);
  checkPositive("reach", firmness.reach, kMostReach);
}

bool Grasps::carriedBy(const std::string& frame) const {
  return std::any_of(all_.begin(), all_.end(),
                     [&](const auto& entry) { return entry.second.frame == frame; });
}

bool Grasps::moving() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const auto& entry) { return !(entry.second.pose == entry.second.next); });
}

void Grasps::add(const std::string& id, Grasp grasp, const std::vector<int>& vertices,
                 const Positions& positions) {
  for (int v : vertices) {
    const Vector3 place = grasp.pose.fromWorld(positions.col(v));
    grasp.vertices[v] = {place, place};
  }
  all_[id] = std::move(grasp);
}

void Grasps::carry(const std::string& frame, const Pose& pose) {
  for (auto& [id, grasp] : all_) {
    if (grasp.frame == frame) grasp.next = pose;
  }
}

std::vector<Spring> Grasps::springs(double s) const {
  std::vector<Spring> springs;
  for (const auto& [id, grasp] : all_) {
    const Pose pose = poseBetween(grasp.pose, grasp.next, s);
    for (const auto& [v, vertex] : grasp.vertices) {
      springs.push_back(springOf(grasp, v, pose.toWorld(vertex.place)));
    }
  }
  return springs;
}

bool Grasps::arrive(const Positions& positions) {
  bool lost = false;
  for (auto& [id, grasp] : all_) {
    grasp.pose = grasp.next;
    std::map<int, GraspedVertex> held;
    for (auto [v, vertex] : grasp.vertices) {
      const double reach = springOf(grasp, v, Vector3::Zero()).reach();
      const Vector3 at = grasp.pose.fromWorld(positions.col(v));
      const Vector3 way = vertex.place - at;
      if (way.norm() > reach) vertex.place = at + reach * way.normalized();
      if ((vertex.place - vertex.grasped).norm() <= grasp.firmness.reach) held[v] = vertex;
      else lost = true;
    }
    // The stiffness and the force of the grasp are shared by the vertices that it still holds.
    grasp.vertices = std::move(held);
  }
  return lost;
}

void Grasps::follow(const Positions& before, const Positions& after) {
  for (auto& [id, grasp] : all_) {
    for (auto& [v, vertex] : grasp.vertices) {
      if (before.col(v) == after.col(v)) continue;
      const Vector3 way = grasp.pose.fromWorld(after.col(v)) - grasp.pose.fromWorld(before.col(v));
      vertex.grasped += way;
      vertex.place += way;
    }
  }
}

std::map<std::string, Wrench> Grasps::wrenches(const Positions& positions) const {
  std::map<std::string, Wrench> wrenches;
  for (const auto& [id, grasp] : all_) {
    Wrench& wrench = wrenches[id];
    for (const auto& [v, vertex] : grasp.vertices) {
      const Vector3 at = grasp.pose.fromWorld(positions.col(v));
      const Vector3 force = springOf(grasp, v, vertex.place).forceAt(at);
      wrench.force += force;
      wrench.torque += at.cross(force);
    }
  }
  return wrenches;
}

}  // namespace shell_origami
