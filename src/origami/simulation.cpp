#include "origami/simulation.h"

#include "sheet/refuse.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace shell_origami {
namespace {

/// Beyond this [N*m/rad per m], 20,000 times a paper's crease, the matrix of a step is too badly
/// conditioned to be factorized.
constexpr double kStiffest = 100;
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

void checkFold(const FoldRequest& request) {
  if (!(std::abs(request.angle) < M_PI)) {
    refuse("angle ", request.angle, " rad is not inside (-pi, pi)");
  }
  if (request.duration && !(*request.duration >= 0 && std::isfinite(*request.duration))) {
    refuse("duration ", *request.duration, " s is negative or not finite");
  }
  if (request.stiffness && !(*request.stiffness > 0 && *request.stiffness <= kStiffest)) {
    refuse("stiffness ", *request.stiffness, " N*m/rad per m is not positive and at most ",
           kStiffest);
  }
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

Counters& Counters::operator+=(const Counters& other) {
  steps += other.steps;
  newton_iterations += other.newton_iterations;
  factorizations += other.factorizations;
  retries += other.retries;
  times += other.times;
  return *this;
}

/// Moves the rest angles along their ramps within one step, and pins that are carried straight to
/// where they go.
class Simulation::StepDrive : public Drive {
 public:
  explicit StepDrive(const Simulation& simulation) : simulation_(simulation) {}

  void moveTo(double s, Shell& shell, Positions& held) override {
    const double t = simulation_.time_ + s * simulation_.config_.solver.time_step;
    simulation_.creases_.apply(t, shell);
    for (const auto& [v, way] : simulation_.carried_) {
      held.col(v) = (1 - s) * way.from + s * way.to;
    }
  }

 private:
  const Simulation& simulation_;
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
      stepper_(config_.solver) {
  if (positions.cols() != sheet_.vertexCount() || !positions.allFinite()) {
    refuse("the sheet has ", sheet_.vertexCount(), " vertices, but ", positions.cols(),
           " finite positions are needed");
  }
  if (rest_angles.size() != sheet_.creases().size()) {
    refuse("the sheet has ", sheet_.creases().size(), " creases, but ", rest_angles.size(),
           " rest angles are given");
  }
  creases_ = CreaseDrive(rest_angles, config_.material.crease_stiffness, shell_, positions);
  topologyChanged();
}

FoldResult Simulation::fold(const FoldRequest& request) {
  checkFold(request);
  if (const auto* named = std::get_if<CreaseName>(&request.where)) {
    return foldNamed(named->name, request);
  }
  if (const auto* line = std::get_if<Line>(&request.where)) return foldLine(*line, request);
  const auto [a, b] = std::get<VertexPair>(request.where).vertices;
  checkVertex(sheet_, a);
  checkVertex(sheet_, b);
  if (a == b) refuse("both ends of the line are vertex ", a);
  return foldLine({sheet_.flatPositions()[a], sheet_.flatPositions()[b]}, request);
}

FoldResult Simulation::foldLine(const Line& line, const FoldRequest& request) {
  const std::vector<Crease> creases_before = sheet_.creases();
  FoldLine made = makeFoldLine(sheet_, line, request.name, {&motion_.positions, pinned_});
  follow(made.remap, creases_before);
  for (std::uint32_t id : made.crease_ids) {
    startRamp(sheet_.creaseIndex(id), request.angle, request);
  }
  creases_.keepTogether(time_);
  EditRecord edit = foldRecord(request, made.vertices);
  edit.line = {line[0], line[1]};
  record(std::move(edit));
  return {std::move(made.crease_ids), std::move(made.vertices), made.parts};
}

FoldResult Simulation::foldNamed(const std::string& name, const FoldRequest& request) {
  FoldResult result;
  for (std::size_t i = 0; i < sheet_.creases().size(); ++i) {
    const Crease& crease = sheet_.creases()[i];
    const bool in_group = (name == "mountains" && crease.pattern_angle < 0) ||
                          (name == "valleys" && crease.pattern_angle > 0) ||
                          (name == "all" && std::abs(crease.pattern_angle) > 0);
    if (!in_group && crease.name != name) continue;
    const bool flips = name == "all" && crease.pattern_angle < 0;
    startRamp(static_cast<int>(i), flips ? -request.angle : request.angle, request);
    result.crease_ids.push_back(crease.id);
    result.vertices.insert(result.vertices.end(), crease.vertices.begin(), crease.vertices.end());
  }
  if (result.crease_ids.empty()) refuse("no crease or group of creases is called '", name, "'");
  creases_.keepTogether(time_);
  EditRecord edit = foldRecord(request, result.vertices);
  edit.crease = name;
  record(std::move(edit));
  return result;
}

void Simulation::startRamp(int crease, double target, const FoldRequest& request) {
  creases_.start(crease, target, time_, request.duration.value_or(config_.fold_duration),
                 request.stiffness.value_or(config_.material.crease_stiffness), shell_,
                 motion_.positions);
}

EditRecord Simulation::foldRecord(const FoldRequest& request,
                                  const std::vector<int>& vertices) const {
  EditRecord edit;
  edit.vertices = vertices;
  edit.angle = request.angle;
  edit.duration = request.duration.value_or(config_.fold_duration);
  edit.stiffness = request.stiffness.value_or(config_.material.crease_stiffness);
  return edit;
}

void Simulation::follow(const Remap& remap, const std::vector<Crease>& creases_before) {
  creases_.follow(remap, creases_before, sheet_.creases());
  rest_.follow(remap, sheet_);
  motion_.positions = remap.apply(motion_.positions, sheet_.vertexCount());
  motion_.velocities = remap.apply(motion_.velocities, sheet_.vertexCount());
  motion_.accelerations = remap.apply(motion_.accelerations, sheet_.vertexCount());
  topologyChanged();
}

void Simulation::topologyChanged() {
  shell_ = Shell(sheet_, config_.material, config_.gravity);
  creases_.apply(time_, shell_);
  rest_.apply(shell_);
  pinsChanged();
}

void Simulation::pinsChanged() {
  std::vector<bool> free(sheet_.vertexCount(), true);
  for (int v : pinned_) {
    free[v] = false;
    motion_.velocities.col(v).setZero();
    motion_.accelerations.col(v).setZero();
  }
  stepper_.setTopology(std::move(free));
}

std::vector<int> Simulation::pin(const PinWhere& where) {
  const std::vector<int> vertices = verticesAt(where, sheet_, motion_.positions);
  pinned_.insert(vertices.begin(), vertices.end());
  pinsChanged();
  EditRecord edit;
  edit.kind = EditRecord::kPin;
  edit.vertices = vertices;
  record(std::move(edit));
  return vertices;
}

std::vector<int> Simulation::unpin(const std::vector<std::int64_t>& vertices) {
  std::set<int> freed;
  for (std::int64_t v : vertices) {
    checkVertex(sheet_, v);
    if (!pinned_.count(static_cast<int>(v))) refuse("vertex ", v, " is not pinned");
    freed.insert(static_cast<int>(v));
  }
  if (vertices.empty()) freed = pinned_;
  for (int v : freed) pinned_.erase(v);
  pinsChanged();
  EditRecord edit;
  edit.kind = EditRecord::kUnpin;
  edit.vertices.assign(freed.begin(), freed.end());
  record(edit);
  return edit.vertices;
}

int Simulation::addVertex(std::int64_t a, std::int64_t b, double fraction) {
  checkVertex(sheet_, a);
  checkVertex(sheet_, b);
  const std::vector<Crease> creases_before = sheet_.creases();
  const AddedVertex added =
      shell_origami::addVertex(sheet_, static_cast<int>(a), static_cast<int>(b), fraction);
  follow(added.remap, creases_before);
  EditRecord edit;
  edit.kind = EditRecord::kAddVertex;
  edit.vertices = {static_cast<int>(a), static_cast<int>(b), added.vertex};
  edit.fraction = fraction;
  record(std::move(edit));
  return added.vertex;
}

void Simulation::configure(const LiveConfig& live) {
  SimulationConfig changed = config_;
  changed.gravity = live.gravity;
  changed.material.air_damping = live.air_damping;
  changed.fold_duration = live.fold_duration;
  checkConfig(changed);
  // A step starts from the accelerations of the one before, which jump as what causes them does.
  if (counters_.steps > 0) {
    const Vector3 jump = changed.gravity - config_.gravity;
    const double drag = changed.material.air_damping - config_.material.air_damping;
    motion_.accelerations.colwise() += jump;
    motion_.accelerations -= drag * motion_.velocities;
    for (int v : pinned_) motion_.accelerations.col(v).setZero();
  }
  config_ = changed;
  shell_.setGravity(config_.gravity);
  EditRecord edit;
  edit.kind = EditRecord::kConfigure;
  edit.gravity = live.gravity;
  edit.air_damping = live.air_damping;
  edit.duration = live.fold_duration;
  record(std::move(edit));
}

/// Every edit ends here. It wakes paper that rests.
void Simulation::record(EditRecord edit) {
  resting_ = false;
  edit.step = counters_.steps;
  edit.time = time_;
  edit.revision = sheet_.revision();
  edits_.push_back(std::move(edit));
}

std::vector<EditRecord> Simulation::takeEdits() { return std::exchange(edits_, {}); }

void Simulation::carry(const std::vector<int>& vertices, const Positions& places) {
  if (places.cols() != static_cast<Eigen::Index>(vertices.size()) || !places.allFinite()) {
    refuse(vertices.size(), " vertices need as many finite places, not ", places.cols());
  }
  for (int v : vertices) {
    if (!pinned_.count(v)) refuse("vertex ", v, " is not pinned");
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    carried_[vertices[i]] = {motion_.positions.col(vertices[i]), places.col(i)};
  }
  resting_ = false;
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
  if (resting_) {
    ++counters_.steps;
    time_ += config_.solver.time_step;
    return {};
  }
  StepDrive drive(*this);
  const StepReport report =
      counted(stepper_.step(shell_, config_.material.air_damping, drive, motion_));
  carried_.clear();
  if (!report.converged) {
    creases_.apply(time_, shell_);
    return report;
  }
  ++counters_.steps;
  time_ += config_.solver.time_step;
  creases_.creep(time_, config_.solver.time_step, sheet_, shell_, motion_.positions);
  creases_.yield(time_, config_.material, shell_, motion_.positions);
  rest_.yield(config_.material, motion_.positions, shell_);
  resting_ = atRest();
  if (resting_) {
    motion_.velocities.setZero();
    motion_.accelerations.setZero();
  }
  return report;
}

StepReport Simulation::settle() {
  const CreaseDrive before = creases_;
  const auto give_way = [this](Shell& shell, const Positions& positions) {
    creases_.creep(time_, config_.solver.time_step, sheet_, shell, positions);
    creases_.apply(time_, shell);
  };
  const StepReport report = counted(stepper_.relax(shell_, give_way, motion_));
  if (!report.converged) {
    creases_ = before;
    creases_.apply(time_, shell_);
    return report;
  }
  EditRecord edit;
  edit.kind = EditRecord::kSettle;
  record(std::move(edit));
  return report;
}

std::vector<CreaseStatus> Simulation::creases() const {
  std::vector<CreaseStatus> result;
  for (std::size_t i = 0; i < sheet_.creases().size(); ++i) {
    CreaseStatus status;
    status.id = sheet_.creases()[i].id;
    status.name = sheet_.creases()[i].name;
    status.angle = meanAngle(static_cast<int>(i), shell_, motion_.positions);
    status.rest_angle = creases_.ramps()[i].angleAt(time_);
    status.target_angle = creases_.ramps()[i].target;
    status.driven = creases_.ramps()[i].driven;
    status.angle_min = M_PI;
    status.angle_max = -M_PI;
    double length = 0;
    for (int j : shell_.creaseHinges()[i]) {
      const double angle = shell_.foldAngle(j, motion_.positions);
      const double weight = shell_.hinges()[j].length;
      status.moment += weight * shell_.moment(j, angle);
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
  energies.kinetic =
      motion_.velocities.colwise().squaredNorm().dot(shell_.masses().transpose()) / 2;
  return energies;
}

double Simulation::maxStrain() const {
  double largest = 0;
  for (const Edge& edge : sheet_.edges()) {
    const auto [a, b] = edge.vertices;
    const double flat = (sheet_.flatPositions()[a] - sheet_.flatPositions()[b]).norm();
    const double now = (motion_.positions.col(a) - motion_.positions.col(b)).norm();
    largest = std::max(largest, std::abs(now / flat - 1));
  }
  return largest;
}

bool Simulation::folding() const { return creases_.runningAt(time_); }

bool Simulation::atRest() const {
  const double still = kAtRest * config_.solver.tolerance;
  return !folding() && rootMeanSquare(motion_.velocities) < still &&
         rootMeanSquare(motion_.accelerations) * config_.solver.time_step < still;
}

bool Simulation::settled() const {
  return !folding() && rootMeanSquare(motion_.velocities) < kSettledSpeed * sheet_.size() &&
         rootMeanSquare(motion_.accelerations) < kSettledAcceleration * sheet_.size();
}

}  // namespace shell_origami
