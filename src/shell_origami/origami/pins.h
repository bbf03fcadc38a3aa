/// \file
/// The ways to select vertices of a sheet.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <cstdint>
#include <variant>
#include <vector>

namespace shell_origami {

/// A ball in space: every vertex now inside it.
struct Ball {
  Vector3 center;
  double radius;  ///< [m]
};
/// A polygon on the flat sheet: every vertex inside it or on it.
struct Region {
  std::vector<Vector2> corners;
};
using PinWhere = std::variant<std::vector<std::int64_t>,  // vertices
                              std::vector<Vector2>,       // nearest vertex of each flat point
                              Region, Ball>;

/// \throws std::invalid_argument naming a vertex that does not exist.
void checkVertex(const Sheet& sheet, std::int64_t vertex);

/// The vertices, ascending. \throws std::invalid_argument with one sentence when there are none.
std::vector<int> verticesAt(const PinWhere& where, const Sheet& sheet, const Positions& positions);

}  // namespace shell_origami
