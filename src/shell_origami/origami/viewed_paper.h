/// \file
/// Folded paper as somebody sees it who looks at it from one side.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <optional>

namespace shell_origami {

/// Cosine of the angle between a layer's normal and the stack's beyond which it stands on edge.
constexpr double kOnEdge = 0.5;

/// The side from which somebody looks at the paper.
struct Viewpoint {
  Vector2 point = Vector2::Zero();  ///< of the flat sheet, whose layer stays as paper is folded [m]
  bool front = true;                ///< whether that layer shows its front
};

/// Returns the viewpoint of flat paper that is seen from its front.
Viewpoint frontOf(const Sheet& sheet);

/// Where the paper seems to be. Creases that are shut leave some degrees, so that layers do not lie
/// exactly on each other; people see and fold them as if they did. Where every crease is shut or
/// flat, and panels close, the places are those of paper folded exactly flat, in a frame of their
/// own. Where one stands open, they are those in space.
struct ViewedPaper {
  Positions positions;      ///< [m], one column for each vertex
  Vector3 viewer;           ///< from the paper to the viewer, of length 1, in the same frame
  Eigen::VectorXd heights;  ///< of each vertex in space, towards the viewer [m]
};

/// \throws std::invalid_argument where the viewpoint is off the paper, or its layer stands on edge
ViewedPaper viewedPaper(const Viewpoint& view, const Simulation& simulation);

/// Returns the same view, looked at from another point of the flat sheet.
/// \pre it is on the paper
Viewpoint viewAt(const Vector2& point, const Sheet& sheet, const ViewedPaper& paper);

/// Where the viewer sees a point on a triangle: the weights of its corners, not all positive where
/// it is beside. None: the triangle is seen from its edge.
std::optional<Vector3> weightsSeen(const Vector3& point, const Triangle& triangle,
                                   const ViewedPaper& paper);

/// The normal of a triangle in space, twice its area long.
Vector3 areaNormal(const Triangle& triangle, const Positions& positions);

}  // namespace shell_origami
