#include "origami/simulation.h"

#include "sheet/refuse.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// A free crease has this part of a crease's stiffness: it follows whatever pulls at it.
constexpr double kFreeCreaseSoftness = 0.01;
/// It gives way, too: where it rests creeps to where it is within this time [s]. Held at rest flat
/// it would bend the panels beside it by tens of degrees, towards the half turn.
constexpr double kCreepTime = 0.05;
/// Flat paper may go either of two ways at a vertex. So that it goes its pattern's, a free crease
/// of which the pattern asks for a mountain or a valley leans to that side, as stiff as any, while
/// the folds begin: by this part of the farthest one's angle, and no farther than this [rad]. Where
/// it leaned more than it will have to fold (0.71 of the others in a waterbomb base) the vertex
/// would pop the wrong way; half would not turn every fast vertex of four.
constexpr double kLean = 0.6;
constexpr double kMostLean = 2 * M_PI / 180;
/// Beyond this [N*m/rad per m], 20,000 times a paper's crease, the matrix of a step is too badly
/// conditioned to be factorized.
constexpr double kStiffest = 100;
/// Slower than these parts of the sheet's size per second (squared), nothing is seen to move.
constexpr double kSettledSpeed = 0.005;
constexpr double kSettledAcceleration = 0.1;

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

/// Moves the rest angles along their ramps within one step.
class Simulation::RampDrive : public Drive {
 public:
  explicit RampDrive(const Simulation& simulation) : simulation_(simulation) {}

  void moveTo(double s, Shell& shell) override {
    const double t = simulation_.time_ + s * simulation_.config_.solver.time_step;
    for (std::size_t i = 0; i < simulation_.ramps_.size(); ++i) {
      const FoldRamp& ramp = simulation_.ramps_[i];
      shell.setCrease(static_cast<int>(i), ramp.angleAt(t), ramp.stiffness);
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
      integrator_(config_.solver) {
  if (positions.cols() != sheet_.vertexCount() || !positions.allFinite()) {
    refuse("the sheet has ", sheet_.vertexCount(), " vertices, but ", positions.cols(),
           " finite positions are needed");
  }
  const double stiffness = config_.material.crease_stiffness;
  for (std::size_t i = 0; i < sheet_.creases().size(); ++i) {
    FoldRamp ramp;
    ramp.driven = std::isfinite(rest_angles.at(i));
    ramp.stiffness = ramp.driven ? stiffness : kFreeCreaseSoftness * stiffness;
    ramp.target = ramp.driven ? rest_angles[i] : meanAngle(static_cast<int>(i));
    ramps_.push_back(ramp);
  }
  topologyChanged();
}

FoldResult Simulation::fold(const FoldRequest& request) {
  checkFold(request);
  if (const auto* named = std::get_if<CreaseName>(&request.where)) {
    return foldNamed(named->name, request);
  }
  if (const auto* line = std::get_if<Line>(&request.where)) return foldLine(*line, request);
  const auto [a, b] = std::get<VertexPair>(request.where).vertices;
  checkVertex(a);
  checkVertex(b);
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
  keepTogether();
  EditRecord edit;
  edit.line = {line[0], line[1]};
  edit.vertices = made.vertices;
  edit.angle = request.angle;
  edit.duration = request.duration.value_or(config_.fold_duration);
  edit.stiffness = request.stiffness.value_or(config_.material.crease_stiffness);
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
  keepTogether();
  EditRecord edit;
  edit.crease = name;
  edit.vertices = result.vertices;
  edit.angle = request.angle;
  edit.duration = request.duration.value_or(config_.fold_duration);
  edit.stiffness = request.stiffness.value_or(config_.material.crease_stiffness);
  record(std::move(edit));
  return result;
}

void Simulation::startRamp(int crease, double target, const FoldRequest& request) {
  FoldRamp& ramp = ramps_[crease];
  // A driven crease starts from where it rests, so that no moment jumps; a free one from the
  // angle it has.
  ramp.from = ramp.driven ? ramp.angleAt(time_) : meanAngle(crease);
  ramp.driven = true;
  ramp.target = target;
  ramp.start = time_;
  ramp.duration = request.duration.value_or(config_.fold_duration);
  ramp.stiffness = request.stiffness.value_or(config_.material.crease_stiffness);
}

/// Gives every ramp that begins now its lead.
void Simulation::keepTogether() {
  for (FoldRamp& ramp : ramps_) {
    if (!ramp.driven || ramp.start != time_) continue;
    const FoldRamp* lead = &ramp;
    for (const FoldRamp& other : ramps_) {
      if (other.runsWith(ramp) && other.way() > lead->way()) lead = &other;
    }
    ramp.lead_from = lead->from;
    ramp.lead_target = lead->target;
  }
}

/// Lets free creases lean, and give way.
void Simulation::creep() {
  double farthest = 0;
  for (const FoldRamp& ramp : ramps_) {
    if (ramp.driven) farthest = std::max(farthest, std::abs(ramp.angleAt(time_)));
  }
  const double lean = std::min(kLean * farthest, kMostLean);
  const double part = 1 - std::exp(-config_.solver.time_step / kCreepTime);
  const double stiffness = config_.material.crease_stiffness;
  for (std::size_t i = 0; i < ramps_.size(); ++i) {
    FoldRamp& ramp = ramps_[i];
    if (ramp.driven) continue;
    const double asked = sheet_.creases()[i].pattern_angle;  // NaN: nothing
    const double side = asked > 0 ? 1 : asked < 0 ? -1 : 0;
    const double angle = meanAngle(static_cast<int>(i));
    const bool leans = side != 0 && lean > 0 && side * angle < lean;
    ramp.target = leans ? side * lean : ramp.target + part * (angle - ramp.target);
    ramp.stiffness = leans ? stiffness : kFreeCreaseSoftness * stiffness;
  }
}

void Simulation::follow(const Remap& remap, const std::vector<Crease>& creases_before) {
  std::vector<FoldRamp> ramps;
  for (const Crease& crease : sheet_.creases()) {
    std::uint32_t ancestor = crease.id;
    for (const Remap::Born& born : remap.born) {
      if (born.crease == crease.id) ancestor = born.parent;
    }
    const auto old = std::find_if(creases_before.begin(), creases_before.end(),
                                  [&](const Crease& c) { return c.id == ancestor; });
    ramps.push_back(old == creases_before.end() ? FoldRamp{}
                                                : ramps_[old - creases_before.begin()]);
  }
  ramps_ = std::move(ramps);
  motion_.positions = remap.apply(motion_.positions, sheet_.vertexCount());
  motion_.velocities = remap.apply(motion_.velocities, sheet_.vertexCount());
  motion_.accelerations = remap.apply(motion_.accelerations, sheet_.vertexCount());
  topologyChanged();
}

void Simulation::topologyChanged() {
  shell_ = Shell(sheet_, config_.material, config_.gravity);
  RampDrive(*this).moveTo(0, shell_);
  pinsChanged();
}

void Simulation::pinsChanged() {
  std::vector<bool> free(sheet_.vertexCount(), true);
  for (int v : pinned_) {
    free[v] = false;
    motion_.velocities.col(v).setZero();
    motion_.accelerations.col(v).setZero();
  }
  integrator_.setTopology(shell_, free);
}

void Simulation::checkVertex(std::int64_t vertex) const {
  if (vertex < 0 || vertex >= sheet_.vertexCount()) {
    refuse("vertex ", vertex, " does not exist: the sheet has ", sheet_.vertexCount());
  }
}

std::vector<int> Simulation::verticesAt(const PinWhere& where) const {
  std::set<int> found;
  if (const auto* ids = std::get_if<std::vector<std::int64_t>>(&where)) {
    if (ids->empty()) refuse("no vertices are given");
    for (std::int64_t v : *ids) {
      checkVertex(v);
      found.insert(static_cast<int>(v));
    }
  } else if (const auto* points = std::get_if<std::vector<Vector2>>(&where)) {
    if (points->empty()) refuse("no points are given");
    for (const Vector2& p : *points) {
      if (!p.allFinite()) refuse("the point (", p.x(), ", ", p.y(), ") is not finite");
      if (!sheet_.triangulation().locate(p, 1e-6 * sheet_.size())) {
        refuse("the point (", p.x(), ", ", p.y(), ") is off the paper");
      }
      found.insert(sheet_.nearestVertex(p));
    }
  } else if (const auto* region = std::get_if<Region>(&where)) {
    if (region->corners.size() < 3) {
      refuse("a region needs at least three corners, not ", region->corners.size());
    }
    for (const Vector2& p : region->corners) {
      if (!p.allFinite()) refuse("the corner (", p.x(), ", ", p.y(), ") is not finite");
    }
    for (int v = 0; v < sheet_.vertexCount(); ++v) {
      if (polygonContains(region->corners, sheet_.flatPositions()[v], 1e-9 * sheet_.size())) {
        found.insert(v);
      }
    }
    if (found.empty()) {
      const Vector2& corner = region->corners[0];
      refuse("no vertex lies in the region that starts at (", corner.x(), ", ", corner.y(), ")");
    }
  } else {
    const Ball& ball = std::get<Ball>(where);
    if (!ball.center.allFinite()) refuse("the center of the ball is not finite");
    if (!(ball.radius > 0 && std::isfinite(ball.radius))) {
      refuse("radius ", ball.radius, " m is not positive and finite");
    }
    for (int v = 0; v < sheet_.vertexCount(); ++v) {
      if ((motion_.positions.col(v) - ball.center).norm() <= ball.radius) found.insert(v);
    }
    if (found.empty()) {
      refuse("no vertex is within ", ball.radius, " m of (", ball.center.x(), ", ",
             ball.center.y(), ", ", ball.center.z(), ")");
    }
  }
  return {found.begin(), found.end()};
}

std::vector<int> Simulation::pin(const PinWhere& where) {
  const std::vector<int> vertices = verticesAt(where);
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
    checkVertex(v);
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
  checkVertex(a);
  checkVertex(b);
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

void Simulation::record(EditRecord edit) {
  edit.step = counters_.steps;
  edit.time = time_;
  edit.revision = sheet_.revision();
  edits_.push_back(std::move(edit));
}

std::vector<EditRecord> Simulation::takeEdits() { return std::exchange(edits_, {}); }

double Simulation::meanAngle(int crease) const {
  double weighted = 0, length = 0;
  for (int j : shell_.creaseHinges()[crease]) {
    weighted += shell_.hinges()[j].length * shell_.foldAngle(j, motion_.positions);
    length += shell_.hinges()[j].length;
  }
  return weighted / length;
}

StepReport Simulation::step() {
  RampDrive drive(*this);
  StepReport report =
      integrator_.step(shell_, config_.material.air_damping, drive, motion_);
  counters_.newton_iterations += report.newton_iterations;
  counters_.factorizations += report.factorizations;
  counters_.retries += report.retries;
  if (!report.converged) {
    drive.moveTo(0, shell_);
    return report;
  }
  ++counters_.steps;
  time_ += config_.solver.time_step;
  creep();
  return report;
}

std::vector<CreaseStatus> Simulation::creases() const {
  std::vector<CreaseStatus> result;
  for (std::size_t i = 0; i < sheet_.creases().size(); ++i) {
    CreaseStatus status;
    status.id = sheet_.creases()[i].id;
    status.name = sheet_.creases()[i].name;
    status.angle = meanAngle(static_cast<int>(i));
    status.rest_angle = ramps_[i].angleAt(time_);
    status.target_angle = ramps_[i].target;
    status.driven = ramps_[i].driven;
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

bool Simulation::folding() const {
  return std::any_of(ramps_.begin(), ramps_.end(),
                     [this](const FoldRamp& ramp) { return ramp.runningAt(time_); });
}

bool Simulation::settled() const {
  return !folding() && rootMeanSquare(motion_.velocities) < kSettledSpeed * sheet_.size() &&
         rootMeanSquare(motion_.accelerations) < kSettledAcceleration * sheet_.size();
}

}  // namespace shell_origami
