/// \file
/// The one door to the core: a sheet of paper that is edited, stepped and looked at.
#pragma once

#include "dynamics/stepper.h"
#include "origami/crease_drive.h"
#include "origami/pins.h"
#include "sheet/fold_line.h"
#include "sheet/sheet.h"
#include "shell/shell.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {

/// The flat sheet in the plane z = 0.
Positions flatInSpace(const Sheet& sheet);

/// Everything about a simulation but the sheet.
struct SimulationConfig {
  Material material;
  Vector3 gravity = Vector3::Zero();  ///< [m/s^2]; zero: the paper floats
  SolverConfig solver;
  double fold_duration = 1.0;  ///< of a fold that states none [s]
  Roll rest;                   ///< how the sheet is rolled up when it rests
};

/// Bounds of what a configuration may hold.
struct Bounds {
  double low, high;
};
constexpr Bounds kGravityBounds{-1e4, 1e4};  ///< of each component [m/s^2]
constexpr Bounds kAirDampingBounds{0, 1e6};  ///< [1/s]

/// What of a configuration may change while the paper moves.
struct LiveConfig {
  Vector3 gravity = Vector3::Zero();  ///< [m/s^2]
  double air_damping = 0;             ///< [1/s]
  double fold_duration = 1;           ///< of a fold that states none [s]
};

/// \throws std::invalid_argument with a sentence that names the offending parameter and value.
void checkConfig(const SimulationConfig& config);

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
  std::variant<CreaseName, VertexPair, Line> where;
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

/// One crease now. Angles in radians, valley > 0, means weighted by length.
struct CreaseStatus {
  std::uint32_t id = 0;
  std::string name;
  double angle = 0, angle_min = 0, angle_max = 0;
  double rest_angle = 0;
  double target_angle = 0;  ///< of a free crease, where it rests
  double moment = 0;        ///< mean [N*m per m], positive towards a valley
  bool driven = false;      ///< a fold has named it
};

struct Energies {
  double membrane = 0, bending = 0, kinetic = 0, gravity = 0;  ///< [J]

  double strain() const { return membrane + bending; }
};

/// Sums over the life of the simulation.
struct Counters {
  std::uint64_t steps = 0;
  std::uint64_t newton_iterations = 0;
  std::uint64_t factorizations = 0;
  std::uint64_t retries = 0;
  SolverTimes times;

  Counters& operator+=(const Counters& other);
};

/// An edit the paper took. Fields that a kind does not use are empty.
struct EditRecord {
  enum Kind { kFold, kPin, kUnpin, kAddVertex, kSettle, kConfigure } kind = kFold;
  std::uint64_t step = 0;      ///< steps completed before it
  double time = 0;             ///< [s]
  std::uint32_t revision = 0;  ///< of the sheet after it
  std::string crease;          ///< fold: the crease or group that was named
  std::vector<Vector2> line;   ///< fold: the two ends on the flat sheet [m]
  std::vector<int> vertices;   ///< fold: the polyline; pin, unpin: the vertices;
                               ///< add_vertex: the edge and the new vertex
  double angle = 0, duration = 0, stiffness = 0, fraction = 0;
  Vector3 gravity = Vector3::Zero();  ///< configure, with air_damping and duration
  double air_damping = 0;
};

/// Edits throw std::invalid_argument with one sentence that names the offending value, and then
/// have changed nothing. Everything is deterministic: the same calls give the same bits.
class Simulation {
 public:
  /// A sheet at rest, flat in the plane z = 0, or at `positions` (one column a vertex) with the
  /// creases at rest at `rest_angles` (one for each crease; NaN: a free crease).
  Simulation(Sheet sheet, const SimulationConfig& config);
  Simulation(Sheet sheet, const SimulationConfig& config, const Positions& positions,
             const std::vector<double>& rest_angles);

  /// Folds that begin at the same time and take equally long run together (FoldRamp). Creases
  /// that no fold has named are free: soft, they follow what the others ask of them, to the side
  /// that Crease::pattern_angle asks for.
  FoldResult fold(const FoldRequest& request);
  /// Returns the vertices that are held by this request, ascending.
  std::vector<int> pin(const PinWhere& where);
  /// Lets go of these vertices (none given: of all) and returns them.
  std::vector<int> unpin(const std::vector<std::int64_t>& vertices = {});
  /// Adds a vertex on the edge a, b at `fraction` of its flat length from a.
  int addVertex(std::int64_t a, std::int64_t b, double fraction);
  /// From here on the paper moves under these.
  void configure(const LiveConfig& live);

  /// The edits taken since the last call, oldest first.
  std::vector<EditRecord> takeEdits();

  /// Carries held vertices to these places (one column each) [m] within the next step.
  void carry(const std::vector<int>& vertices, const Positions& places);

  /// Advances by SolverConfig::time_step. A step that does not converge leaves everything as it
  /// was and says so in the report. Paper that has come to rest stays there, at no cost, until an
  /// edit touches it.
  StepReport step();
  /// Goes to equilibrium at once, without time passing, everything at rest where ramps are now. If
  /// there is none (paper that is not pinned falls) it leaves everything as it was and says so.
  StepReport settle();

  const Sheet& sheet() const { return sheet_; }
  const Shell& shell() const { return shell_; }
  const SimulationConfig& config() const { return config_; }
  const Positions& positions() const { return motion_.positions; }
  const Positions& velocities() const { return motion_.velocities; }
  const std::set<int>& pinned() const { return pinned_; }
  const Counters& counters() const { return counters_; }
  double time() const { return time_; }  ///< [s]

  std::vector<CreaseStatus> creases() const;  ///< in the order of sheet().creases()
  Energies energies() const;
  /// Largest |edge length / flat length - 1|.
  double maxStrain() const;
  /// Whether a ramp is still running.
  bool folding() const;
  /// Whether no ramp runs, and speeds (the kinetic energy) and accelerations (the residual force)
  /// are too small to see.
  bool settled() const;

 private:
  class StepDrive;
  FoldResult foldLine(const Line& line, const FoldRequest& request);
  FoldResult foldNamed(const std::string& name, const FoldRequest& request);
  void startRamp(int crease, double target, const FoldRequest& request);
  EditRecord foldRecord(const FoldRequest& request, const std::vector<int>& vertices) const;
  StepReport counted(StepReport report);
  void follow(const Remap& remap, const std::vector<Crease>& creases_before);
  void topologyChanged();
  void pinsChanged();
  void record(EditRecord edit);
  bool atRest() const;

  SimulationConfig config_;
  Sheet sheet_;
  Shell shell_;
  Motion motion_;
  CreaseDrive creases_;
  RestShape rest_;
  std::set<int> pinned_;
  struct Way {
    Vector3 from, to;
  };
  std::map<int, Way> carried_;  ///< of pins within the next step
  Stepper stepper_;
  Counters counters_;
  std::vector<EditRecord> edits_;
  double time_ = 0;
  bool resting_ = false;
};

}  // namespace shell_origami
