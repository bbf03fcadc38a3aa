#include <shell_origami/origami/held_vertices.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {

namespace {

/// Beyond this [m], positions published as float32 would be off by more than 0.03 mm.
constexpr double kFarthest = 1000;

}  // namespace

void checkPose(const Pose& pose) {
  const Vector3& p = pose.position;
  if (!(p.cwiseAbs().maxCoeff() <= kFarthest) || !p.allFinite()) {
    reject("a frame stands at (", p.x(), ", ", p.y(), ", ", p.z(), "), but must be within ",
           kFarthest, " m");
  }
  const double length = pose.orientation.norm();
  if (!(std::abs(length - 1) < 1e-6)) reject("a frame's quaternion has length ", length, ", not 1");
}

Pose poseBetween(const Pose& from, const Pose& to, double s) {
  if (s == 0 || from == to) return from;
  if (s == 1) return to;
  return {(1 - s) * from.position + s * to.position,
          from.orientation.slerp(s, to.orientation).normalized()};
}

HeldVertices::HeldVertices(const std::vector<int>& in_place, std::map<std::string, Grip> grips)
    : all_(in_place.begin(), in_place.end()), grips_(std::move(grips)) {
  for (const auto& [frame, grip] : grips_) {
    for (const auto& [v, place] : grip.places) {
      if (!all_.insert(v).second) reject("vertex ", v, " is held twice");
    }
  }
}

std::set<int> HeldVertices::inPlace() const {
  std::set<int> vertices = all_;
  for (const auto& [frame, grip] : grips_) {
    for (const auto& [v, place] : grip.places) vertices.erase(v);
  }
  return vertices;
}

void HeldVertices::holdInPlace(const std::vector<int>& vertices) {
  for (int v : vertices) dropFromGrips(v);
  all_.insert(vertices.begin(), vertices.end());
}

void HeldVertices::holdByFrame(const std::vector<int>& vertices, const std::string& frame,
                               const Pose& pose, const Positions& positions) {
  const auto known = grips_.find(frame);
  Grip grip = known == grips_.end() ? Grip{pose, pose, {}} : known->second;
  for (int v : vertices) {
    dropFromGrips(v);
    grip.places[v] = grip.pose.fromWorld(positions.col(v));
  }
  grips_[frame] = std::move(grip);
  all_.insert(vertices.begin(), vertices.end());
}

void HeldVertices::release(const std::set<int>& vertices) {
  for (int v : vertices) {
    dropFromGrips(v);
    all_.erase(v);
  }
}

void HeldVertices::dropFromGrips(int vertex) {
  for (auto grip = grips_.begin(); grip != grips_.end();) {
    grip->second.places.erase(vertex);
    grip = grip->second.places.empty() ? grips_.erase(grip) : std::next(grip);
  }
}

void HeldVertices::place(double s, Positions& positions) const {
  for (const auto& [frame, grip] : grips_) {
    if (grip.next == grip.pose) continue;
    const Pose pose = poseBetween(grip.pose, grip.next, s);
    for (const auto& [v, place] : grip.places) positions.col(v) = pose.toWorld(place);
  }
}

bool HeldVertices::moving() const {
  return std::any_of(grips_.begin(), grips_.end(),
                     [](const auto& grip) { return !(grip.second.pose == grip.second.next); });
}

void HeldVertices::arrive() {
  for (auto& [frame, grip] : grips_) grip.pose = grip.next;
}

void HeldVertices::follow(const Positions& positions) {
  for (auto& [frame, grip] : grips_) {
    for (auto& [v, place] : grip.places) {
      const Vector3 now = positions.col(v);
      if (grip.pose.toWorld(place) != now) place = grip.pose.fromWorld(now);
    }
  }
}

}  // namespace shell_origami
