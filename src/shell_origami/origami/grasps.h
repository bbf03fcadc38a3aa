/// \file
/// Soft holds: springs that hold vertices up to a force, beyond which the paper slips.
#pragma once

#include <shell_origami/energy/spring_potential.h>
#include <shell_origami/origami/held_vertices.h>

#include <map>
#include <string>
#include <vector>

namespace shell_origami {

/// How firm a grasp is, of all its vertices together.
struct Firmness {
  double stiffness = 1000;  ///< [N/m]
  double max_force = 1;     ///< [N]
  double reach = 0.01;      ///< a vertex that has slipped farther is lost [m]
};

/// \throws std::invalid_argument with the offending value.
void checkFirmness(const Firmness& firmness);

/// A vertex in a grasp, in its frame [m].
struct GraspedVertex {
  Vector3 grasped;  ///< where it was grasped
  Vector3 place;    ///< where its spring pulls it to: elsewhere once it has slipped
};

struct Grasp {
  Firmness firmness;
  std::string frame;  ///< that carries it; empty: the world, which does not
  Pose pose;          ///< of that frame
  Pose next;          ///< at the end of the next step
  std::map<int, GraspedVertex> vertices;
};

/// The grasps by their names. A grasp that has lost all vertices stays, and holds nothing.
class Grasps {
 public:
  Grasps() = default;
  explicit Grasps(std::map<std::string, Grasp> all) : all_(std::move(all)) {}

  const std::map<std::string, Grasp>& all() const { return all_; }
  bool empty() const { return all_.empty(); }
  bool carriedBy(const std::string& frame) const;
  bool moving() const;

  /// Holds vertices where they are in its frame.
  void add(const std::string& id, Grasp grasp, const std::vector<int>& vertices,
           const Positions& positions);
  void remove(const std::string& id) { all_.erase(id); }
  void carry(const std::string& frame, const Pose& pose);

  /// Returns the springs with the places of their ends a part s in [0, 1] of the next step on, in
  /// the order of the grasps and their vertices.
  std::vector<Spring> springs(double s) const;
  /// The step has converged: frames arrive, and springs that are at their limit give way. Returns
  /// whether a vertex was lost.
  bool arrive(const Positions& positions);
  /// An edit moved vertices, which take their places along.
  void follow(const Positions& before, const Positions& after);

  /// Force and torque with which each holds the paper, in its frame and about its origin.
  std::map<std::string, Wrench> wrenches(const Positions& positions) const;

 private:
  std::map<std::string, Grasp> all_;
};

}  // namespace shell_origami
