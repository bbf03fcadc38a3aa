/// \file
/// What a person asks of the paper, and the record of what it took.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/origami/held_vertices.h>
#include <shell_origami/origami/pins.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {

/// A named crease, or a group of creases of the loaded pattern: `mountains`, `valleys`, or `all`,
/// of which each is folded to the side that the pattern asks for.
struct CreaseName {
  std::string name;
};
/// Two vertices: the straight flat line between them.
struct VertexPair {
  std::array<std::int64_t, 2> vertices;
};

struct FoldRequest {
  std::variant<CreaseName, VertexPair, Segment> where;
  double angle = 0;                 ///< [rad], inside (-pi, pi), valley > 0
  std::optional<double> duration;   ///< [s]; none: SimulationConfig::fold_duration
  std::optional<double> stiffness;  ///< [N*m/rad per m]; none: Material::crease_stiffness
  std::string name;                 ///< of the new crease; empty: one is made up
};

struct FoldResult {
  std::vector<std::uint32_t> crease_ids;
  std::vector<int> vertices;  ///< the polyline in order; of a group, one crease after the other
  int parts = 1;              ///< of a line, that lie on the paper; more where it has holes
};

/// An edit the paper took. Fields that a kind does not use are empty.
struct EditRecord {
  enum Kind { kFold, kPin, kUnpin, kAddVertex, kSettle, kCarry, kStop, kConfigure } kind = kFold;
  std::uint64_t number = 0;    ///< of this edit, from 1 on, once someone counts them
  std::uint64_t step = 0;      ///< steps completed before it
  double time = 0;             ///< [s]
  std::uint32_t revision = 0;  ///< of the sheet after it
  std::string crease;          ///< fold: the crease or group that was named
  std::string name;            ///< fold: asked for the new crease
  std::vector<Vector2> line;   ///< fold: the two ends on the flat sheet [m]
  std::vector<int> vertices;   ///< fold: the polyline; pin, unpin: the vertices;
                               ///< add_vertex: the edge and the new vertex
  double angle = 0, duration = 0, stiffness = 0, fraction = 0;
  std::string frame;  ///< pin: the frame that carries the vertices; carry: the one that moves
  Pose pose;          ///< pin, carry: of the frame
  Vector3 gravity = Vector3::Zero();  ///< configure, with air_damping and duration
  double air_damping = 0;
};

}  // namespace shell_origami
