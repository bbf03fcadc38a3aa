/// \file
/// Rigid bodies that paper lies on, is pushed by, and does not pass through.
#pragma once

#include <shell_origami/contact/collision_mesh.h>
#include <shell_origami/origami/held_vertices.h>

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {

/// Everything below the plane z = 0 of its frame.
struct HalfSpace {};
/// With its center at the origin of its frame; size along each axis [m].
struct Box {
  Vector3 size;
};
struct Sphere {
  double radius;  ///< [m]
};
/// About the z axis of its frame, with the origin in its middle [m].
struct Cylinder {
  double radius, length;
};
/// A closed surface.
struct MeshShape {
  std::shared_ptr<const Surface> surface;
  std::string path = {};            ///< of the file that it is of; empty: of none
  Vector3 scale = Vector3::Ones();  ///< by which its coordinates are multiplied
};
using ObstacleShape = std::variant<HalfSpace, Box, Sphere, Cylinder, MeshShape>;

/// Where paper that lies on it is, its middle surface, is the surface of the shape: the paper is
/// pushed from there on, within the distance d^ below it. (A mesh is pushed away from d^ above it.)
struct Obstacle {
  ObstacleShape shape;
  double friction = 0;  ///< Coulomb's coefficient, paper on it
  std::string frame;    ///< that carries it; empty: none
  Pose base;            ///< of that frame in the world; of one that none carries its own
  Pose in_base;         ///< where it is in that frame
  Pose next;            ///< of the base at the end of the next step, if nothing is in the way
  Pose target;          ///< of a move under way
  double left = 0;      ///< time until it gets there, if nothing stops it [s]
  double due = 0;       ///< time until it was to be there, from its start on [s]

  Pose pose() const { return base * in_base; }
};

/// \throws std::invalid_argument with the offending value unless the shape is finite, of a size
/// between 1 mm and 100 m and, a mesh, closed.
void checkShape(const ObstacleShape& shape);

/// The obstacles by their names. Their vertices are columns of positions, in the order of the
/// names.
class Obstacles {
 public:
  Obstacles() = default;
  /// \param pace of all that move, as pace()
  Obstacles(std::map<std::string, Obstacle> all, double pace);

  const std::map<std::string, Obstacle>& all() const { return all_; }
  bool empty() const { return all_.empty(); }
  bool carriedBy(const std::string& frame) const;
  /// Whether they have the same names and shapes as others, wherever they are.
  bool sameShapes(const Obstacles& others) const;

  void add(const std::string& id, Obstacle obstacle) { all_[id] = std::move(obstacle); }
  void remove(const std::string& id) { all_.erase(id); }
  /// Moves the obstacles that a frame carries within the next step.
  void carry(const std::string& frame, const Pose& pose);
  /// Ends all moves.
  void stop();
  /// Moves one at a constant speed.
  void move(const std::string& id, const Pose& target, double duration);

  /// Returns the bodies that paper is pushed by from `distance` [m] on.
  std::vector<Body> bodies(double distance) const;
  /// Returns the places of their vertices, a part s in [0, 1] of the next step on. A half space
  /// reaches `size` [m] around `center`, a place of the paper.
  Positions places(const std::vector<Body>& bodies, double distance, double s,
                   const Vector3& center, double size) const;

  /// Sets Obstacle::next of those that a move is under way for.
  void aim(double time_step);
  /// Whether any of them moves within the next step.
  bool moving() const;
  /// The part of that motion that is made: less than all where paper is in the way.
  double pace() const { return pace_; }
  /// Makes a smaller part of it. Returns false where none was made or nothing moves.
  bool slowDown();
  /// The step has converged. The next one tries a larger part again. A move that is late ends where
  /// it is stopped.
  void arrive(double time_step);

 private:
  static void end(Obstacle& obstacle);

  std::map<std::string, Obstacle> all_;
  double pace_ = 1;
};

}  // namespace shell_origami
