/// \file
/// The one door to the core: a sheet of paper that is edited, stepped and looked at.
#pragma once

#include <shell_origami/base/parallel.h>
#include <shell_origami/contact/contact_forces.h>
#include <shell_origami/dynamics/stepper.h>
#include <shell_origami/energy/shell_potential.h>
#include <shell_origami/origami/compliance.h>
#include <shell_origami/origami/edit.h>
#include <shell_origami/origami/snapshot.h>
#include <shell_origami/sheet/fold_line.h>
#include <shell_origami/sheet/sheet.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
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
  double membrane = 0, bending = 0, kinetic = 0, gravity = 0, contact = 0;  ///< [J]

  double strain() const { return membrane + bending; }
};

/// A held vertex that paper stops.
struct Blocked {
  int vertex;
  std::string frame;
  int by;  ///< vertex of the paper in the way
};

/// A frame with the held vertices, grasps and obstacles that it carries.
struct CarriedFrame {
  Pose pose;                    ///< where it carried them last
  Pose next;                    ///< where it carries them within the next step that converges
  std::vector<Vector3> places;  ///< of vertices and of obstacles' corners, in the frame [m]
};

/// Obstacles that paper stopped or slowed in the last step.
struct Stopped {
  std::vector<std::string> ids;
  double pace;  ///< the part of their way that they made
};

/// Edits throw std::invalid_argument with a message that names the offending value, and then have
/// changed nothing. Everything is deterministic: the same calls give the same bits.
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

  /// Makes an edit and returns what it did. Every change of the paper but time passes through here.
  EditRecord apply(const Edit& edit);
  /// Makes edits in order, all of them or, where one is rejected, none.
  std::vector<EditRecord> apply(const std::vector<Edit>& edits);

  /// Where a function is set, an edit that takes long asks it now and then whether to give up: it
  /// is then rejected.
  void setInterrupt(std::function<bool()> interrupt) { interrupt_ = std::move(interrupt); }

  // Short for apply(), each with the part of the record that its callers want.
  EditRecord fold(const FoldEdit& edit) { return apply(edit); }
  std::vector<int> pin(const PinWhere& where) { return apply(PinEdit{where}).vertices; }
  std::vector<int> pin(const PinWhere& where, const std::string& frame, const Pose& pose);
  std::vector<int> unpin(const std::optional<PinWhere>& where = {});
  int addVertex(std::int64_t a, std::int64_t b, double fraction);
  void carry(const std::string& frame, const Pose& pose) { apply(CarryEdit{frame, pose}); }
  StepReport settle() { return apply(SettleEdit{}).report; }
  void stopFolds() { apply(StopEdit{}); }
  void configure(const LiveConfig& live) { apply(ConfigureEdit{live}); }

  /// Advances by SolverConfig::time_step. A step that does not converge leaves everything as it
  /// was, a frame's way to carry included, and says so in the report. Paper that has come to rest
  /// stays there, at no cost, until an edit touches it.
  StepReport step();

  const Sheet& sheet() const { return sheet_; }
  const ShellPotential& shell() const { return shell_; }
  const SimulationConfig& config() const { return config_; }
  const Positions& positions() const { return motion_.positions; }
  const Positions& velocities() const { return motion_.velocities; }
  /// Pairs of triangles that pass through each other. With contact no pair is added.
  std::vector<TrianglePair> crossings() const;
  /// The parts of the paper that touch, in a fixed order.
  std::vector<Contact> contacts() const;
  std::vector<ContactForce> contactForces() const;  ///< of contacts(), in their order
  /// Where held paper met paper in the last step and could not follow what holds it.
  const std::optional<Blocked>& blocked() const { return blocked_; }
  const HeldVertices& held() const { return held_; }
  const Obstacles& obstacles() const { return obstacles_; }
  const Grasps& grasps() const { return grasps_; }
  /// Force and torque with which each grasp holds the paper, in its frame and about its origin.
  std::map<std::string, Wrench> graspWrenches() const {
    return grasps_.wrenches(motion_.positions);
  }
  /// By the frames' names.
  std::map<std::string, CarriedFrame> carriedFrames() const;
  const std::optional<Stopped>& stopped() const { return stopped_; }
  /// The name of an obstacle that the paper cuts or is inside of, by exact predicates; empty: there
  /// is none, as by construction.
  std::string cutObstacle() const { return cutObstacle(sheet_, motion_.positions); }
  /// Force and torque of the paper on each obstacle in the last step, friction included: of one
  /// that a frame carries in that frame and about its origin, of others in the world's.
  std::map<std::string, Wrench> obstacleWrenches() const;
  /// The obstacles, in the order of their names, as surfaces that paper does not get past.
  const std::vector<Body>& bodies() const { return bodies_; }
  /// The places of their vertices [m].
  Positions obstaclePlaces() const { return obstaclesAt(0, paperCenter()); }
  /// The places of the paper's vertices, and after them those of the obstacles' [m].
  Positions positionsWithObstacles() const { return withObstacles(motion_.positions); }
  const std::set<int>& pinned() const { return held_.all(); }
  const Counters& counters() const { return counters_; }
  double time() const { return time_; }  ///< [s]

  Snapshot snapshot() const;

  std::vector<CreaseStatus> creases() const;  ///< in the order of sheet().creases()
  Energies energies() const;
  /// Force and torque of each frame on the vertices that it holds, in the frame and about its
  /// origin, by the frame's name. Under the empty name, in the world: on vertices held in place.
  std::map<std::string, Wrench> holdingWrenches() const;
  /// Largest |edge length / rest length - 1|: the rest length is the flat one, but where folding
  /// has stretched the paper for good.
  double maxStrain() const { return maxStrain(motion_.positions); }
  /// Whether a ramp is still running.
  bool folding() const;
  /// Whether the membrane is softer than the paper's, as it may be while a pattern folds.
  bool soft() const { return compliance_.soft(); }
  /// By how much folding has stretched the paper for good.
  InPlaneSet::Size inPlaneSet() const { return in_plane_.size(sheet_); }
  /// Whether no ramp runs, the membrane is hard, and speeds (the kinetic energy) and accelerations
  /// (the residual force) are too small to see.
  bool settled() const;
  /// Whether nothing moves until the next edit: time passes at no cost.
  bool resting() const { return resting_; }

 private:
  class StepConditions;
  EditRecord applyHere(const Edit& edit);
  StepReport stepHere();
  // Each makes one edit, adds what it did to the record, and returns EditRecord::edit.
  FoldEdit make(const FoldEdit& edit, EditRecord& record);
  PinEdit make(const PinEdit& edit, EditRecord& record);
  UnpinEdit make(const UnpinEdit& edit, EditRecord& record);
  AddVertexEdit make(const AddVertexEdit& edit, EditRecord& record);
  CarryEdit make(const CarryEdit& edit, EditRecord& record);
  SettleEdit make(const SettleEdit& edit, EditRecord& record);
  StopEdit make(const StopEdit& edit, EditRecord& record);
  ConfigureEdit make(const ConfigureEdit& edit, EditRecord& record);
  AddObstacleEdit make(const AddObstacleEdit& edit, EditRecord& record);
  RemoveObstacleEdit make(const RemoveObstacleEdit& edit, EditRecord& record);
  MoveObstacleEdit make(const MoveObstacleEdit& edit, EditRecord& record);
  GraspEdit make(const GraspEdit& edit, EditRecord& record);
  ReleaseEdit make(const ReleaseEdit& edit, EditRecord& record);
  FoldLine insertLine(const Segment& line, const std::string& name);
  void foldLine(const Segment& line, const FoldEdit& edit, EditRecord& record);
  void foldNamed(const std::string& name, const FoldEdit& edit, EditRecord& record);
  void startRamp(int crease, double target, const FoldEdit& edit);
  StepReport counted(StepReport report);
  void follow(const Remap& remap, const std::vector<Crease>& creases_before);
  void topologyChanged();
  void updateRestState(double time);
  void giveWay(const Positions& positions);
  const Potentials& potentials();
  void pinsChanged();
  bool atRest() const;
  Positions accelerations() const;
  bool contactOn() const;
  std::vector<TrianglePair> touching() const;
  void startContact();
  void remakeContact();
  void takeInWhatParted();
  void checkNewName(const char* what, const std::string& id) const;
  void remakeSprings();
  void moveSprings(double s);
  void remakeObstacles();
  std::string cutObstacle(const Sheet& sheet, const Positions& positions) const;
  Vector3 paperCenter() const;
  Positions obstaclesAt(double s, const Vector3& center) const;
  Positions withObstacles(const Positions& paper) const;
  Positions forcesOnObstacles(const Positions& all, Potential::Iterate& at) const;
  Motion joinedMotion() const;
  StepReport takeStep(BoundaryConditions& conditions);
  StepReport relax(const std::function<void(const Positions&)>& adapt);
  StepReport moveAmongObstacles(
      const std::function<StepReport(const Eigen::VectorXd& masses, Motion& motion)>& move);
  bool pushed() const;
  double maxStrain(const Positions& x) const;
  bool tears(const Positions& before) const;
  bool crushes(const Positions& before);
  double obstacleGap(const std::vector<Contact>& contacts) const;
  void findStopped();
  void addContactForces(Positions& forces) const;
  void findBlocked();
  int inTheWayOf(int v) const;

  SimulationConfig config_;
  Sheet sheet_;
  ShellPotential shell_;
  std::optional<ContactPotential> contact_;  ///< none where paper may pass through itself
  std::vector<Body> bodies_;                 ///< of the obstacles
  std::optional<ContactPotential>
      obstacle_contact_;  ///< paper and obstacles; none where there are none
  std::optional<Blocked> blocked_;
  std::optional<Stopped> stopped_;
  Potentials potentials_;  ///< scratch of potentials()
  Motion motion_;
  CreaseActuation creases_;
  Compliance compliance_;
  RestShape rest_;
  CurvatureFit curvature_fit_;  ///< of paper that yields where it is bent
  InPlaneSet in_plane_;
  HeldVertices held_;
  Grasps grasps_;
  SpringPotential springs_;  ///< of the grasps
  Obstacles obstacles_;
  Positions obstacle_forces_;  ///< of the paper on their vertices in the last step [N]
  Stepper stepper_;
  Counters counters_;
  double time_ = 0;
  bool resting_ = false;
  bool edited_ = false;                 ///< since the last step
  std::vector<TrianglePair> left_out_;  ///< of contact, ascending: what crossed when that began
  std::function<bool()> interrupt_;
  Threads threads_;  ///< of steps and edits
};

}  // namespace shell_origami
