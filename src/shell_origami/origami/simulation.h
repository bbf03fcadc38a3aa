/// \file
/// The one door to the core: a sheet of paper that is edited, stepped and looked at.
#pragma once

#include <shell_origami/dynamics/stepper.h>
#include <shell_origami/energy/shell_potential.h>
#include <shell_origami/origami/edit.h>
#include <shell_origami/origami/snapshot.h>
#include <shell_origami/sheet/fold_line.h>
#include <shell_origami/sheet/sheet.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace shell_origami {

/// The flat sheet in the plane z = 0.
Positions flatInSpace(const Sheet& sheet);

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

/// Edits throw std::invalid_argument with one sentence that names the offending value, and then
/// have changed nothing. Everything is deterministic: the same calls give the same bits.
class Simulation {
 public:
  /// A sheet at rest, flat in the plane z = 0, or at `positions` (one column a vertex) with the
  /// creases at rest at `rest_angles` (one for each crease; NaN: a free crease).
  Simulation(Sheet sheet, const SimulationConfig& config);
  Simulation(Sheet sheet, const SimulationConfig& config, const Positions& positions,
             const std::vector<double>& rest_angles);
  /// Goes on where another stood. \throws std::invalid_argument when the parts do not belong
  /// together.
  explicit Simulation(const Snapshot& snapshot);

  /// Folds that begin at the same time and take equally long run together (FoldRamp). Creases
  /// that no fold has named are free: soft, they follow what the others ask of them, to the side
  /// that Crease::pattern_angle asks for.
  FoldResult fold(const FoldRequest& request);
  /// Holds vertices where they are and returns them, ascending.
  std::vector<int> pin(const PinWhere& where);
  /// Lets the frame, which stands at `pose`, hold them: carry() takes them along.
  std::vector<int> pin(const PinWhere& where, const std::string& frame, const Pose& pose);
  /// Lets go of these vertices (none given: of all) and returns them.
  std::vector<int> unpin(const std::vector<std::int64_t>& vertices = {});
  /// Stops every fold under way: its crease rests from now on at the angle its ramp has reached.
  void stopFolds();
  /// Adds a vertex on the edge a, b at `fraction` of its flat length from a.
  int addVertex(std::int64_t a, std::int64_t b, double fraction);
  /// From here on the paper moves under these.
  void configure(const LiveConfig& live);

  /// Takes a frame's vertices along, within the next step, to where the frame then stands.
  void carry(const std::string& frame, const Pose& pose);

  /// The edits taken since the last call, oldest first.
  std::vector<EditRecord> takeEdits();
  /// Takes an edit once more, on paper as it was then.
  void redo(const EditRecord& edit);

  /// Advances by SolverConfig::time_step. A step that does not converge leaves everything as it
  /// was and says so in the report. Paper that has come to rest stays there, at no cost, until an
  /// edit touches it.
  StepReport step();
  /// Goes to equilibrium at once, without time passing, everything at rest where ramps are now. If
  /// there is none (paper that is not pinned falls) it leaves everything as it was and says so.
  StepReport settle();

  const Sheet& sheet() const { return sheet_; }
  const ShellPotential& shell() const { return shell_; }
  const SimulationConfig& config() const { return config_; }
  const Positions& positions() const { return motion_.positions; }
  const Positions& velocities() const { return motion_.velocities; }
  const HeldVertices& held() const { return held_; }
  const std::set<int>& pinned() const { return held_.all(); }
  const Counters& counters() const { return counters_; }
  double time() const { return time_; }  ///< [s]

  Snapshot snapshot() const;

  std::vector<CreaseStatus> creases() const;  ///< in the order of sheet().creases()
  Energies energies() const;
  /// What holds the paper, by its frame: force and torque on the vertices it holds, in the frame
  /// and about its origin. Under no name, in the world: of vertices held in place.
  std::map<std::string, Wrench> holdingWrenches() const;
  /// Largest |edge length / flat length - 1|.
  double maxStrain() const;
  /// Whether a ramp is still running.
  bool folding() const;
  /// Whether no ramp runs, and speeds (the kinetic energy) and accelerations (the residual force)
  /// are too small to see.
  bool settled() const;

 private:
  class StepConditions;
  FoldResult foldLine(const Segment& line, const FoldRequest& request);
  FoldResult foldNamed(const std::string& name, const FoldRequest& request);
  void startRamp(int crease, double target, const FoldRequest& request);
  EditRecord foldRecord(const FoldRequest& request, const std::vector<int>& vertices) const;
  StepReport counted(StepReport report);
  void follow(const Remap& remap, const std::vector<Crease>& creases_before);
  void topologyChanged();
  void updateRestState(double time);
  const Potentials& potentials();
  void pinsChanged();
  std::vector<int> pinned(EditRecord edit);
  void record(EditRecord edit);
  bool atRest() const;

  SimulationConfig config_;
  Sheet sheet_;
  ShellPotential shell_;
  Potentials potentials_;  ///< scratch of potentials()
  Motion motion_;
  CreaseActuation creases_;
  RestShape rest_;
  HeldVertices held_;
  Stepper stepper_;
  Counters counters_;
  std::vector<EditRecord> edits_;
  double time_ = 0;
  bool resting_ = false;
};

}  // namespace shell_origami
