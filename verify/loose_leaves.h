/// \file
/// Several leaves of paper that are not joined, to test how they touch. They are parts of one sheet
/// and lie side by side on it when it is flat.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <Eigen/Geometry>

#include <vector>

namespace shell_origami {

/// A square and its motion.
struct Leaf {
  double side;             ///< [m]
  Eigen::Isometry3d pose;  ///< takes the square around the origin in the plane z = 0 to space
  Vector3 velocity = Vector3::Zero();  ///< [m/s]
};

class LooseLeaves {
 public:
  LooseLeaves(const std::vector<Leaf>& leaves, double max_edge, const SimulationConfig& config);

  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  /// The vertices of a leaf are from first(leaf) to first(leaf + 1) - 1.
  int first(int leaf) const { return first_[leaf]; }
  std::vector<std::int64_t> vertices(int leaf) const;
  /// The sum over a leaf of its vertices' columns [m or m/s], weighted by mass, over its mass.
  Vector3 mean(int leaf, const Positions& columns) const;
  double mass(int leaf) const;  ///< [kg]
  /// The sum of the normal forces on a leaf by another one [N].
  Vector3 force(int leaf, int by) const;

  /// Advances by one time step. Throws std::runtime_error if it does not converge.
  void step();

 private:
  std::vector<int> first_;
  Simulation simulation_;
};

}  // namespace shell_origami
