/// \file
/// The plane in space along which folded paper is folded, from what people say of a fold: Huzita's
/// axioms 1 to 4 in words (Huzita, Axiomatic development of origami geometry, 1989).
#pragma once

#include <shell_origami/origami/landmark.h>

#include <array>
#include <cmath>
#include <variant>

namespace shell_origami {

/// By which layers turn where no angle is given: shut, with some room for layers between [rad].
constexpr double kShutAngle = 178 * M_PI / 180;

/// Brings one point to another.
struct BringPoint {
  Landmark from, to;
};
/// Brings the line through two points onto that through two others. The first one moves.
struct BringEdge {
  std::array<Landmark, 2> edge, to_edge;
};
/// Folds at a right angle to an edge, through a point.
struct FoldAcross {
  std::array<Landmark, 2> edge;
  Landmark at;
  Landmark move;  ///< on the side that moves
};
/// Folds along the line through two points.
struct FoldAlong {
  std::array<Landmark, 2> points;
  Landmark move;  ///< on the side that moves
};
using FoldAxiom = std::variant<BringPoint, BringEdge, FoldAcross, FoldAlong>;

struct FoldPlane {
  Vector3 point;   ///< [m]
  Vector3 normal;  ///< of length 1, towards what moves
  Vector3 mover;   ///< a point that moves [m]

  double distance(const Vector3& x) const { return normal.dot(x - point); }
};

/// Returns the plane, which contains the viewer's direction: paper is folded along lines as they
/// are seen.
/// \param viewer  of length 1, from the paper to who looks at it
/// \throws std::invalid_argument with one sentence where the landmarks make no fold
FoldPlane foldPlane(const FoldAxiom& axiom, const Sheet& sheet, const Positions& positions,
                    const Vector3& viewer);

}  // namespace shell_origami
