/// \file
/// The vertices that are held: in place, or carried along by frames.
#pragma once

#include <shell_origami/base/geometry.h>

#include <Eigen/Geometry>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace shell_origami {

/// The pose of a frame in the world.
struct Pose {
  Vector3 position = Vector3::Zero();                               ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of length 1

  Vector3 toWorld(const Vector3& p) const { return orientation * p + position; }
  Vector3 fromWorld(const Vector3& p) const { return orientation.conjugate() * (p - position); }
  /// Where `pose`, given in this frame, is in the world.
  Pose operator*(const Pose& pose) const {
    return {toWorld(pose.position), (orientation * pose.orientation).normalized()};
  }
  bool operator==(const Pose& other) const {
    return position == other.position && orientation.coeffs() == other.orientation.coeffs();
  }
};

/// \throws std::invalid_argument unless it is finite, within 1000 m, and its quaternion of
/// length 1.
void checkPose(const Pose& pose);

/// A part s in [0, 1] of the way from one pose to another, each end exactly.
Pose poseBetween(const Pose& from, const Pose& to, double s);

/// Vertices that a frame carries rigidly.
struct Grip {
  Pose pose;                      ///< of the frame, where it carried them last
  Pose next;                      ///< where it carries them within the next step that converges
  std::map<int, Vector3> places;  ///< of the vertices, in the frame [m]
};

/// A force [N] and a torque [N*m].
struct Wrench {
  Vector3 force = Vector3::Zero();
  Vector3 torque = Vector3::Zero();
};

/// A vertex is held in place or by one frame.
class HeldVertices {
 public:
  HeldVertices() = default;
  HeldVertices(const std::vector<int>& in_place, std::map<std::string, Grip> grips);

  const std::set<int>& all() const { return all_; }
  /// By the frames' names; each holds a vertex or more.
  const std::map<std::string, Grip>& grips() const { return grips_; }
  /// Those that no frame holds.
  std::set<int> inPlace() const;

  void holdInPlace(const std::vector<int>& vertices);
  /// The vertices keep their present places relative to the frame, which stands at `pose`, or, if
  /// it carries others already, where it carried those.
  void holdByFrame(const std::vector<int>& vertices, const std::string& frame, const Pose& pose,
                   const Positions& positions);
  void release(const std::set<int>& vertices);

  /// Sets Grip::next. \pre the frame carries vertices
  void carry(const std::string& frame, const Pose& pose) { grips_.at(frame).next = pose; }
  /// Puts carried vertices where they stand a part s in (0, 1] of the next step on.
  void place(double s, Positions& positions) const;
  /// Whether the next step carries vertices to other places.
  bool moving() const;
  /// The step has converged.
  void arrive();

  /// An edit may have shifted vertices, which keep their new places.
  void follow(const Positions& positions);

 private:
  void dropFromGrips(int vertex);

  std::set<int> all_;
  std::map<std::string, Grip> grips_;
};

}  // namespace shell_origami
