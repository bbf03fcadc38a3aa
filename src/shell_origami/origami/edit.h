/// \file
/// The edits: everything that changes paper, other than time.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/dynamics/integrator.h>
#include <shell_origami/origami/config.h>
#include <shell_origami/origami/grasps.h>
#include <shell_origami/origami/held_vertices.h>
#include <shell_origami/origami/obstacles.h>
#include <shell_origami/origami/pins.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {

/// A named crease, or a group of creases of the loaded pattern: `mountains`, `valleys` or `all`.
/// Each crease of a group is folded to the side that the pattern asks for, whatever the angle's
/// sign.
struct CreaseName {
  std::string name;
};
/// Two vertices: the straight flat line between them.
struct VertexPair {
  std::array<std::int64_t, 2> vertices;
};

/// Starts a fold. Folds that start at the same time and take equally long run together (FoldRamp).
struct FoldEdit {
  std::variant<CreaseName, VertexPair, Segment> where;
  double angle = 0;                 ///< [rad], inside (-pi, pi), valley > 0
  std::optional<double> duration;   ///< [s]; none: SimulationConfig::fold_duration
  std::optional<double> stiffness;  ///< [N*m/rad per m]; none: Material::crease_stiffness
  std::string name;                 ///< of the new crease; empty: generated
  double part = 0;                  ///< (0, 1]: of the pattern's angle; 0: `angle` counts
};

/// Holds vertices: where they are, or by a frame, which CarryEdit moves.
struct PinEdit {
  PinWhere where;
  std::string frame = {};  ///< empty: they are held where they are
  Pose pose = {};          ///< of the frame, in the world
};

/// Lets go of held vertices.
struct UnpinEdit {
  std::optional<PinWhere> where = {};  ///< none: all that are held
};

/// Adds a vertex on an edge.
struct AddVertexEdit {
  std::array<std::int64_t, 2> edge;
  double fraction = 0;  ///< of the edge's flat length, from its first vertex, in (0, 1)
};

/// Moves the vertices that a frame holds and the obstacles that it carries along with it, within
/// the next step that converges.
struct CarryEdit {
  std::string frame;
  Pose pose;  ///< at the end of that step
};

/// Moves the paper to static equilibrium, at once, with every rest angle where its ramp is now.
struct SettleEdit {};

/// Stops every fold under way, whose crease keeps the rest angle that its ramp has reached, and
/// every obstacle that a MoveObstacleEdit moves.
struct StopEdit {};

/// Changes parameters that may change while the paper moves.
struct ConfigureEdit {
  LiveConfig live;
};

/// Puts an obstacle beside the paper.
struct AddObstacleEdit {
  std::string id;
  ObstacleShape shape;
  Pose pose = {};                  ///< in the frame
  std::optional<double> friction;  ///< none: ContactConfig::friction
  std::string frame = {};          ///< that carries it; empty: the world, which does not
  Pose frame_pose = {};            ///< of the frame, in the world
};

/// Takes obstacles away.
struct RemoveObstacleEdit {
  std::vector<std::string> ids;  ///< none: all
};

/// Moves an obstacle that no frame carries, at a constant speed.
struct MoveObstacleEdit {
  std::string id;
  Pose pose;            ///< where it arrives
  double duration = 0;  ///< [s]; 0: within a step
};

/// Holds vertices softly.
struct GraspEdit {
  std::string id;
  PinWhere where;
  Firmness firmness = {};
  std::string frame = {};  ///< that carries it; empty: the world, which does not
  Pose pose = {};          ///< of the frame, in the world
};

/// Ends grasps.
struct ReleaseEdit {
  std::vector<std::string> ids;  ///< none: all
};

using Edit = std::variant<FoldEdit, PinEdit, UnpinEdit, AddVertexEdit, CarryEdit, SettleEdit,
                          StopEdit, ConfigureEdit, AddObstacleEdit, RemoveObstacleEdit,
                          MoveObstacleEdit, GraspEdit, ReleaseEdit>;

/// An edit that was made, and what it did.
struct EditRecord {
  /// The edit with every default filled in and every vertex by its number: applied to the same
  /// paper it does the same, to the bit.
  Edit edit;
  std::uint64_t number = 0;    ///< in its session, from 1 on; 0 outside of one
  std::uint64_t step = 0;      ///< steps completed before it
  double time = 0;             ///< [s]
  std::uint32_t revision = 0;  ///< of the sheet after it

  std::vector<std::uint32_t> crease_ids;  ///< fold: of every crease that folds
  /// Fold: the polyline in order, of a group one crease after the other; pin, unpin: the vertices,
  /// ascending; add_vertex: the new one.
  std::vector<int> vertices;
  int parts = 1;      ///< fold: of the line, that lie on the paper; more where it has holes
  StepReport report;  ///< settle: the solver's work
  std::vector<std::string> ids;  ///< of obstacles that were removed, of grasps that were ended
};

}  // namespace shell_origami
