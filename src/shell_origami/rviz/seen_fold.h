/// \file
/// Where a fold that is laid lies on the paper in space, and what it would move.
#pragma once

#include <shell_origami/rviz/laid_fold.h>
#include <shell_origami/rviz/shown_paper.h>

#include <cstdint>
#include <vector>

namespace shell_origami {

/// The plane of a fold, which contains the direction of the viewer.
struct SeenFold {
  Vector3 point;   ///< on the fold [m]
  Vector3 normal;  ///< of length 1, towards what moves
  Vector3 axis;    ///< of length 1, along the fold: turning about it lifts what moves to the viewer
  Vector3 viewer;  ///< of length 1, from the paper to the viewer
  Vector2 moving;  ///< flat, on the side that moves [m]

  double distance(const Vector3& p) const { return normal.dot(p - point); }
};

/// Returns whether somebody at the eye [m] sees the front of a triangle.
bool showsFront(const ShownPaper& paper, int triangle, const Vector3& eye);

/// Returns the fold as it is seen from the eye [m], at a right angle to the paper at its first
/// point. The smaller side moves where no point, or one close to the fold, says which. None where
/// the two points lie on each other.
std::optional<SeenFold> seenFold(const LaidFold& fold, const ShownPaper& paper, const Vector3& eye);

/// Returns what the fold would move, turned by an angle about its axis: the parts of the paper
/// beyond the plane that are joined to a panel which the fold creases.
/// \param panels  that are creased
/// \param angle   [rad], towards the viewer > 0
/// \returns three corners for each triangle, one after the other [m]
std::vector<Vector3> ghostOf(const SeenFold& fold, const ShownPaper& paper,
                             const std::vector<std::uint32_t>& panels, double angle);

}  // namespace shell_origami
