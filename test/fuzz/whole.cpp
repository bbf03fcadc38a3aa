#include "test/fuzz/whole.h"

#include <shell_origami/origami/outcome.h>

#include <Eigen/Geometry>

#include <cmath>
#include <stdexcept>

namespace shell_origami {

void checkWhole(const Simulation& simulation) {
  const Positions& x = simulation.positions();
  if (!x.allFinite()) throw std::logic_error("a position is not finite");
  if (!simulation.velocities().allFinite()) throw std::logic_error("a velocity is not finite");
  const auto& flat = simulation.sheet().flatPositions();
  for (const Triangle& t : simulation.sheet().triangles()) {
    const Vector3 a = x.col(t[0]), b = x.col(t[1]), c = x.col(t[2]);
    const double part =
        (b - a).cross(c - a).norm() / doubleArea(flat[t[0]], flat[t[1]], flat[t[2]]);
    if (!(part > 0.05)) throw std::logic_error("a triangle collapsed");
  }
  for (const CreaseStatus& crease : simulation.creases()) {
    const double angle = std::max(std::abs(crease.angle_min), std::abs(crease.angle_max));
    if (!(angle < M_PI)) throw std::logic_error("crease " + crease.name + " is shut");
  }
}

void checkApart(const Simulation& simulation) {
  if (simulation.counters().steps % 5 != 0) return;
  const std::string crossing = crossingSentence(simulation);
  if (!crossing.empty()) throw std::logic_error(crossing);
}

}  // namespace shell_origami
