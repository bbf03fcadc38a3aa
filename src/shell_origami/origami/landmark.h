/// \file
/// Places on the paper, as people name them when they tell how to fold.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {

struct Landmark;

/// The corner of the paper's outline that is nearest to a point of the flat sheet.
struct CornerNear {
  Vector2 point;  ///< [m]
};
/// A point of the way from one landmark to another.
struct PartOfWay {
  std::vector<Landmark> ends;  ///< two
  double part = 0.5;           ///< 0 to 1
};
/// Where the line through two landmarks meets the line through two others.
struct LinesMeet {
  std::vector<Landmark> ends;  ///< four
};

struct Landmark {
  std::variant<Vector2, CornerNear, PartOfWay, LinesMeet> place = Vector2::Zero().eval();
  std::string name = {};  ///< by which it was given; empty: by its place
};

/// The landmarks that a recipe has names for.
using LandmarkNames = std::map<std::string, Landmark>;

/// Returns the landmark's place on the flat sheet [m]. Throws std::invalid_argument with one
/// sentence if it is off the paper, or lines do not meet.
Vector2 flatPoint(const Landmark& landmark, const Sheet& sheet);

/// Returns the vertices at which the paper's outline turns, ascending.
std::vector<int> cornersOf(const Sheet& sheet);
/// Returns the vertices at which creases end, meet or turn, and the corners, ascending.
std::vector<int> featuresOf(const Sheet& sheet);

/// Returns where a point of the flat sheet is in space [m]. \pre it is on the paper
Vector3 pointInSpace(const Vector2& flat, const Sheet& sheet, const Positions& positions);
/// Returns the place on the flat sheet [m] of the paper's point that is nearest to a point in
/// space. \throws std::invalid_argument where the point is too far away for its distance to be a
/// number
Vector2 nearestFlatPoint(const Vector3& point, const Sheet& sheet, const Positions& positions);

}  // namespace shell_origami
