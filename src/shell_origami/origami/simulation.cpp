#include <shell_origami/origami/simulation.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace shell_origami {
namespace {

/// Slower than these parts of the sheet's size per second (squared), nothing is seen to move.
constexpr double kSettledSpeed = 0.005;
constexpr double kSettledAcceleration = 0.1;
/// Below this part of the solver's tolerance [m/s] paper is at rest: speeds, and what accelerations
/// add to them within a step.
constexpr double kAtRest = 0.01;

SimulationConfig checked(const SimulationConfig& config) {
  checkConfig(config);
  return config;
}

/// Pairs of parts of the triangles in the pairs before an edit.
std::vector<TrianglePair> followed(const std::vector<TrianglePair>& before, const Remap& remap) {
  if (before.empty()) return {};
  std::map<int, std::vector<int>> parts;
  for (std::size_t t = 0; t < remap.triangles.size(); ++t) {
    parts[remap.triangles[t]].push_back(static_cast<int>(t));
  }
  std::vector<TrianglePair> after;
  for (const auto& [f, g] : before) {
    for (int part_f : parts[f]) {
      for (int part_g : parts[g]) {
        after.push_back({std::min(part_f, part_g), std::max(part_f, part_g)});
      }
    }
  }
  std::sort(after.begin(), after.end());
  return after;
}

double rootMeanSquare(const Positions& values) {
  return std::sqrt(values.squaredNorm() / values.cols());
}

}  // namespace

Positions flatInSpace(const Sheet& sheet) {
  Positions positions = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    positions.col(v).head<2>() = sheet.flatPositions()[v];
  }
  return positions;
}

/// Moves the rest angles along their ramps within one step, and vertices that frames hold along
/// with these.
class Simulation::StepConditions : public BoundaryConditions {
 public:
  explicit StepConditions(Simulation& simulation)
      : simulation_(simulation), center_(simulation.paperCenter()) {}

  void applyAt(double s, Positions& prescribed) override {
    simulation_.updateRestState(simulation_.time_ + s * simulation_.config_.solver.time_step);
    simulation_.held_.place(s, prescribed);
    simulation_.moveSprings(s);
    const Positions places = simulation_.obstaclesAt(s * simulation_.obstacles_.pace(), center_);
    prescribed.rightCols(places.cols()) = places;
  }

  bool constant() const override {
    return !simulation_.folding() && !simulation_.compliance_.soft() &&
           !simulation_.held_.moving() && !simulation_.obstacles_.moving() &&
           !simulation_.grasps_.moving();
  }

  /// Obstacles that paper is in the way of are slowed down instead.
  int mostDivisions() const override {
    const Obstacles& obstacles = simulation_.obstacles_;
    return obstacles.moving() && obstacles.pace() > 0 ? kDivisionsWhilePushed : kMostDivisions;
  }

 private:
  static constexpr int kDivisionsWhilePushed = 3;

  Simulation& simulation_;
  Vector3 center_;  ///< of the paper where the step starts
};

Simulation::Simulation(Sheet sheet, const SimulationConfig& config)
    : Simulation(sheet, config, flatInSpace(sheet),
                 std::vector<double>(sheet.creases().size(), std::nan(""))) {}

Simulation::Simulation(Sheet sheet, const SimulationConfig& config, const Positions& positions,
                       const std::vector<double>& rest_angles)
    : config_(checked(config)),
      sheet_(std::move(sheet)),
      shell_(sheet_, config_.material, config_.gravity),
      motion_{positions, Positions::Zero(3, positions.cols()),
              Positions::Zero(3, positions.cols())},
      rest_(config_.rest, sheet_),
      in_plane_(sheet_),
      stepper_(config_.solver),
      threads_(config_.solver.threads) {
  if (positions.cols() != sheet_.vertexCount() || !positions.allFinite()) {
    reject("the sheet has ", sheet_.vertexCount(), " vertices, but ", positions.cols(),
           " finite positions are needed");
  }
  if (rest_angles.size() != sheet_.creases().size()) {
    reject("the sheet has ", sheet_.creases().size(), " creases, but ", rest_angles.size(),
           " rest angles are given");
  }
  creases_ =
      CreaseActuation(rest_angles, config_.material.crease_stiffness, shell_.shell(), positions);
  topologyChanged();
  if (config_.contact.enabled) startContact();
}

Simulation::Simulation(const Snapshot& snapshot)
    : config_(checked(snapshot.config)),
      sheet_(snapshot.sheet),
      shell_(sheet_, config_.material, config_.gravity),
      motion_(snapshot.motion),
      creases_(snapshot.creases),
      compliance_(snapshot.compliance),
      rest_(snapshot.rest),
      in_plane_(snapshot.in_plane),
      held_(snapshot.held),
      grasps_(snapshot.grasps),
      obstacles_(snapshot.obstacles),
      stepper_(config_.solver),
      counters_(snapshot.counters),
      time_(snapshot.time),
      resting_(snapshot.resting),
      edited_(snapshot.edited),
      left_out_(snapshot.left_out),
      threads_(config_.solver.threads) {
  topologyChanged();
  stepper_.restoreState(snapshot.solver);
  if ((contact_ || obstacle_contact_) && !stepper_.restorePattern(snapshot.pattern)) {
    reject("the matrix's pattern is of another paper");
  }
}

Snapshot Simulation::snapshot() const {
  Snapshot snapshot{config_,   sheet_, motion_,    creases_, compliance_,      rest_,
                    in_plane_, held_,  obstacles_, grasps_,  stepper_.state(), {},
                    counters_, time_,  resting_,   edited_,  left_out_};
  if (contact_ || obstacle_contact_) snapshot.pattern = stepper_.pattern();
  snapshot.creases.synchronize(time_);
  return snapshot;
}

void Simulation::follow(const Remap& remap, const std::vector<Crease>& creases_before) {
  creases_.follow(remap, creases_before, sheet_.creases());
  rest_.follow(remap, sheet_);
  in_plane_.follow(remap);
  const Positions before = motion_.positions;
  motion_.positions = remap.apply(motion_.positions, sheet_.vertexCount());
  grasps_.follow(before, motion_.positions);
  motion_.velocities = remap.apply(motion_.velocities, sheet_.vertexCount());
  motion_.accelerations = remap.apply(motion_.accelerations, sheet_.vertexCount());
  held_.follow(motion_.positions);
  left_out_ = followed(left_out_, remap);
  topologyChanged();
}

void Simulation::topologyChanged() {
  shell_ = ShellPotential(sheet_, config_.material, config_.gravity);
  remakeContact();
  remakeObstacles();
  remakeSprings();
  rest_.apply(shell_.shell(), shell_.rest);
  if (config_.material.yield_curvature > 0) curvature_fit_ = CurvatureFit(sheet_);
  in_plane_.apply(shell_.shell(), shell_.rest);
  updateRestState(time_);
  pinsChanged();
}

/// The energies that move the paper. Made anew at each call, for a simulation may be moved.
const Potentials& Simulation::potentials() {
  potentials_.assign(1, &shell_);
  if (contactOn()) potentials_.push_back(&*contact_);
  if (obstacle_contact_) potentials_.push_back(&*obstacle_contact_);
  if (!springs_.springs().empty()) potentials_.push_back(&springs_);
  return potentials_;
}

/// Puts the rest state where the creases' ramps are at this time.
void Simulation::updateRestState(double time) {
  creases_.apply(time, compliance_.creaseFactor(), shell_.shell(), shell_.rest);
  compliance_.apply(config_.compliance.where, shell_.shell(), shell_.rest);
}

/// Moves the rest state as far as the paper's shape makes it: free creases follow, and what is bent
/// or stretched too far yields.
void Simulation::giveWay(const Positions& positions) {
  creases_.relaxFreeCreases(time_, config_.solver.time_step, sheet_, shell_.shell(), positions);
  creases_.yield(time_, config_.material, shell_.shell(), positions);
  rest_.yield(config_.material, curvature_fit_, positions, shell_.shell(), shell_.rest);
  updateRestState(time_);
  if (compliance_.hardening() && contactOn()) {
    in_plane_.flow(kInPlaneYield, sheet_, positions, shell_.shell(), shell_.rest);
  }
}

void Simulation::pinsChanged() {
  std::vector<bool> free(sheet_.vertexCount(), true);
  for (int v : held_.all()) free[v] = false;
  for (int v : held_.inPlace()) {
    motion_.velocities.col(v).setZero();
    motion_.accelerations.col(v).setZero();
  }
  const int body_vertices = static_cast<int>(obstaclePlaces().cols());
  free.insert(free.end(), body_vertices, false);
  stepper_.setFree(std::move(free), body_vertices);
}

/// Adds to the counters, and to a failure where on the paper it happened.
StepReport Simulation::counted(StepReport report) {
  if (!report.converged && report.vertex >= 0) {
    const Vector2& p = sheet_.flatPositions()[report.vertex];
    std::ostringstream place;
    place << report.failure << ", at vertex " << report.vertex << ", (" << p.x() << ", " << p.y()
          << ") of the flat sheet";
    report.failure = place.str();
  }
  counters_.newton_iterations += report.newton_iterations;
  counters_.factorizations += report.factorizations;
  counters_.retries += report.retries;
  counters_.times += report.times;
  return report;
}

StepReport Simulation::step() {
  return threads_.run([this] { return stepHere(); });
}

/// In the thread that calls it and those that it shares its work with.
StepReport Simulation::stepHere() {
  if (resting_) {
    ++counters_.steps;
    time_ += config_.solver.time_step;
    return {};
  }
  // Here and not in each fold: of many that begin together each would look at all.
  creases_.synchronize(time_);
  const bool contact_before = contactOn();
  const double factor = complianceOf(config_.compliance, sheet_, creases_.ramps(), time_);
  if (factor > 1) compliance_.start(factor);
  obstacles_.aim(config_.solver.time_step);
  StepConditions conditions(*this);
  const SolverState solver = stepper_.state();
  StepReport report;
  do {
    report = counted(takeStep(conditions));
  } while (!report.converged && (obstacles_.slowDown() || compliance_.stiffen()));
  if (!report.converged) {
    updateRestState(time_);
    moveSprings(0);
    stepper_.restoreState(solver);
    return report;
  }
  findBlocked();
  if (!blocked_) held_.arrive();
  findStopped();
  obstacles_.arrive(config_.solver.time_step);
  if (grasps_.arrive(motion_.positions)) {
    remakeSprings();
    pinsChanged();
  } else {
    moveSprings(0);
  }
  takeInWhatParted();
  ++counters_.steps;
  time_ += config_.solver.time_step;
  compliance_.advance(folding(), config_.solver.time_step);
  if (contactOn() && !contact_before) {
    startContact();
    pinsChanged();
  }
  giveWay(motion_.positions);
  edited_ = false;
  resting_ = atRest();
  if (resting_) {
    stopped_.reset();
    motion_.velocities.setZero();
    motion_.accelerations.setZero();
  }
  return report;
}

std::vector<CreaseStatus> Simulation::creases() const {
  std::vector<CreaseStatus> result;
  for (std::size_t i = 0; i < sheet_.creases().size(); ++i) {
    CreaseStatus status;
    status.id = sheet_.creases()[i].id;
    status.name = sheet_.creases()[i].name;
    status.angle = meanAngle(static_cast<int>(i), shell_.shell(), motion_.positions);
    status.rest_angle = creases_.ramps()[i].angleAt(time_);
    status.target_angle = creases_.ramps()[i].target;
    status.driven = creases_.ramps()[i].driven;
    status.angle_min = M_PI;
    status.angle_max = -M_PI;
    double length = 0;
    for (int j : shell_.shell().creaseHinges()[i]) {
      const double angle = shell_.shell().foldAngle(j, motion_.positions);
      const double weight = shell_.shell().hinges()[j].length;
      status.moment += weight * shell_.shell().moment(j, angle, shell_.rest);
      status.angle_min = std::min(status.angle_min, angle);
      status.angle_max = std::max(status.angle_max, angle);
      length += weight;
    }
    status.moment /= length;
    result.push_back(std::move(status));
  }
  return result;
}

Energies Simulation::energies() const {
  Energies energies;
  energies.membrane = shell_.membraneEnergy(motion_.positions);
  energies.bending = shell_.bendingEnergy(motion_.positions);
  energies.gravity = shell_.gravityEnergy(motion_.positions);
  if (contactOn()) energies.contact = contact_->energy(motion_.positions);
  if (obstacle_contact_) energies.contact += obstacle_contact_->energy(positionsWithObstacles());
  energies.kinetic = kineticEnergy(motion_.velocities, shell_.shell().masses());
  return energies;
}

// Free vertices are in balance, M a + c M v + dW/dx = 0; what is missing at a held one, its holder
// adds.
std::map<std::string, Wrench> Simulation::holdingWrenches() const {
  Positions forces = (motion_.accelerations + config_.material.air_damping * motion_.velocities) *
                     shell_.shell().masses().asDiagonal();
  shell_.addGradient(motion_.positions, forces);
  addContactForces(forces);
  const auto add = [&](int v, const Pose& pose, Wrench& wrench) {
    const Vector3 force = pose.orientation.conjugate() * Vector3(forces.col(v));
    wrench.force += force;
    wrench.torque += pose.fromWorld(motion_.positions.col(v)).cross(force);
  };
  std::map<std::string, Wrench> wrenches;
  for (int v : held_.inPlace()) add(v, {}, wrenches[""]);
  for (const auto& [frame, grip] : held_.grips()) {
    for (const auto& [v, place] : grip.places) add(v, grip.pose, wrenches[frame]);
  }
  return wrenches;
}

double Simulation::maxStrain(const Positions& x) const {
  double largest = 0;
  for (int i = 0; i < static_cast<int>(sheet_.triangles().size()); ++i) {
    const Triangle& t = sheet_.triangles()[i];
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const double rest =
          in_plane_.length(i, sheet_.flatPositions()[b] - sheet_.flatPositions()[a]);
      const double now = (x.col(b) - x.col(a)).norm();
      largest = std::max(largest, std::abs(now / rest - 1));
    }
  }
  return largest;
}

bool Simulation::folding() const { return creases_.runningAt(time_); }

bool Simulation::atRest() const {
  const double still = kAtRest * config_.solver.tolerance;
  return !folding() && !compliance_.soft() && !blocked_ && !obstacles_.moving() &&
         !grasps_.moving() && rootMeanSquare(motion_.velocities) < still &&
         rootMeanSquare(motion_.accelerations) * config_.solver.time_step < still;
}

bool Simulation::settled() const {
  return !folding() && !compliance_.soft() &&
         rootMeanSquare(motion_.velocities) < kSettledSpeed * sheet_.size() &&
         rootMeanSquare(accelerations()) < kSettledAcceleration * sheet_.size();
}

/// Those of the last step, or of paper that has taken none since it was loaded or edited, those
/// that its forces give it.
Positions Simulation::accelerations() const {
  if (counters_.steps > 0 && !edited_) return motion_.accelerations;
  Positions forces = Positions::Zero(3, motion_.positions.cols());
  shell_.addGradient(motion_.positions, forces);
  addContactForces(forces);
  for (const Spring& spring : springs_.springs()) {
    forces.col(spring.vertex) -= spring.forceAt(motion_.positions.col(spring.vertex));
  }
  for (int v : pinned()) forces.col(v).setZero();
  return -forces * shell_.shell().masses().cwiseInverse().asDiagonal();
}

}  // namespace shell_origami
