#include <shell_origami/origami/simulation.h>

#include <shell_origami/base/error.h>
#include <shell_origami/contact/ccd.h>
#include <shell_origami/origami/named.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// How far half spaces reach around the paper [m], beyond twice its size: farther than it moves in
/// a step. Rounding grows with it.
constexpr double kPatch = 5;
/// Part of d^ from which on nearer paper is pressed harder than it bears: with tens of newtons on a
/// vertex. An obstacle that presses so stops.
constexpr double kPressed = 0.01;
constexpr double kTrembling = 0.9;
constexpr double kLongestMove = 1e4;  ///< [s]
constexpr double kMostFriction = 10;

bool isName(const std::string& id) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !id.empty() && id.size() <= 100 && letter(id[0]) &&
         std::all_of(id.begin(), id.end(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

}  // namespace

Vector3 Simulation::paperCenter() const { return motion_.positions.rowwise().mean(); }

/// The places of obstacles' vertices a part s of the next step on, for paper that it begins with
/// about `center`.
Positions Simulation::obstaclesAt(double s, const Vector3& center) const {
  return obstacles_.places(bodies_, config_.contact.distance, s, center,
                           kPatch + 2 * sheet_.size());
}

/// The places of the paper's vertices and, after them, of those of obstacles before the next step.
Positions Simulation::withObstacles(const Positions& paper) const {
  const Positions places = obstaclesAt(0, paper.rowwise().mean());
  Positions all(3, paper.cols() + places.cols());
  all << paper, places;
  return all;
}

/// The forces of the paper on the obstacles' vertices [N], at the places of all vertices, which
/// `at` is of.
Positions Simulation::forcesOnObstacles(const Positions& all, Potential::Iterate& at) const {
  Positions gradient = Positions::Zero(3, all.cols());
  obstacle_contact_->addGradient(all, at, gradient);
  return -gradient.rightCols(all.cols() - motion_.positions.cols());
}

Motion Simulation::joinedMotion() const {
  Motion joined = motion_;
  joined.positions = positionsWithObstacles();
  const Eigen::Index count = joined.positions.cols(), own = motion_.positions.cols();
  for (Positions* rates : {&joined.velocities, &joined.accelerations}) {
    rates->conservativeResize(3, count);
    rates->rightCols(count - own).setZero();
  }
  return joined;
}

/// Lets a stepper move the paper with the obstacles' vertices after its own.
StepReport Simulation::moveAmongObstacles(
    const std::function<StepReport(const Eigen::VectorXd& masses, Motion& motion)>& move) {
  const Eigen::VectorXd& own_masses = shell_.shell().masses();
  if (obstacles_.empty()) return move(own_masses, motion_);
  Motion joined = joinedMotion();
  const Eigen::Index count = joined.positions.cols(), own = motion_.positions.cols();
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(count);
  masses.head(own) = own_masses;
  StepReport report = move(masses, joined);
  if (!report.converged) return report;
  obstacle_forces_ = forcesOnObstacles(joined.positions, stepper_.reached(*obstacle_contact_));
  for (Positions* columns : {&joined.positions, &joined.velocities, &joined.accelerations}) {
    columns->conservativeResize(3, own);
  }
  motion_ = std::move(joined);
  return report;
}

StepReport Simulation::takeStep(BoundaryConditions& conditions) {
  const bool moving = obstacles_.moving() && obstacles_.pace() > 0 && !compliance_.soft();
  const Motion before = moving ? motion_ : Motion{};
  StepReport report = moveAmongObstacles([&](const Eigen::VectorXd& masses, Motion& motion) {
    return stepper_.step(potentials(), masses, config_.material.air_damping, conditions, motion);
  });
  if (!moving || !report.converged || !pushed()) return report;
  const bool torn = tears(before.positions);
  if (torn || crushes(before.positions)) {
    motion_ = before;
    report.converged = false;
    report.failure =
        torn ? "an obstacle would tear the paper" : "an obstacle would crush the paper";
  }
  return report;
}

/// Whether the step that led from these positions has stretched the paper further than it bears.
bool Simulation::tears(const Positions& before) const {
  const double strain = maxStrain();
  return strain > kBearableStrain && strain > maxStrain(before);
}

/// Whether the step that led from these positions presses the paper too hard onto an obstacle.
/// Where it is that close gaps tremble a little, also while an obstacle retreats.
bool Simulation::crushes(const Positions& before) {
  const double pressed = kPressed * config_.contact.distance;
  const double gap = obstacleGap(obstacle_contact_->contacts(stepper_.reached(*obstacle_contact_)));
  if (gap >= pressed) return false;
  const double gap_before = obstacleGap(obstacle_contact_->contacts(withObstacles(before)));
  return gap < std::min(pressed, kTrembling * gap_before) ||
         gap < std::min(kTrembling * pressed / 2, gap_before);
}

/// The smallest distance of the contacts with obstacles; d^ where there is none.
double Simulation::obstacleGap(const std::vector<Contact>& contacts) const {
  const double gap = smallestGap(contacts);
  return gap < 0 ? config_.contact.distance : gap;
}

StepReport Simulation::relax(const std::function<void(const Positions&)>& adapt) {
  return moveAmongObstacles([&](const Eigen::VectorXd& masses, Motion& motion) {
    return stepper_.relax(potentials(), masses, adapt, motion);
  });
}

/// Whether an obstacle that moves touches the paper.
bool Simulation::pushed() const {
  Eigen::Index column = 0;
  auto body = bodies_.begin();
  for (const auto& [id, obstacle] : obstacles_.all()) {
    const Eigen::Index count = (body++)->surface->vertices.cols();
    if (!(obstacle.base == obstacle.next) &&
        !obstacle_forces_.middleCols(column, count).isZero(0)) {
      return true;
    }
    column += count;
  }
  return false;
}

void Simulation::remakeObstacles() {
  bodies_ = obstacles_.bodies(config_.contact.distance);
  obstacle_contact_.reset();
  obstacle_forces_.resize(3, 0);
  if (bodies_.empty()) return;
  obstacle_contact_.emplace(sheet_, bodies_, contactParameters(config_));
  const Positions all = positionsWithObstacles();
  const auto at = obstacle_contact_->makeIterate();
  obstacle_contact_->start(all, *at);
  obstacle_forces_ = forcesOnObstacles(all, *at);
}

/// Looks for obstacles that the last step left behind where they were to be.
void Simulation::findStopped() {
  stopped_.reset();
  if (obstacles_.pace() == 1 || !obstacles_.moving()) return;
  stopped_ = Stopped{{}, obstacles_.pace()};
  for (const auto& [id, obstacle] : obstacles_.all()) {
    if (!(obstacle.base == obstacle.next)) stopped_->ids.push_back(id);
  }
}

/// Returns the name of an obstacle that the paper would cut or be inside of, or touch closer than
/// any motion brings it; empty: there is none.
std::string Simulation::cutObstacle(const Sheet& sheet, const Positions& positions) const {
  const Positions places = obstaclePlaces();
  Eigen::Index first = 0;
  auto body = bodies_.begin();
  for (const auto& [id, obstacle] : obstacles_.all()) {
    const Surface& surface = *(body++)->surface;
    const Eigen::Index count = surface.vertices.cols();
    if (cutTriangle(sheet, positions, surface, places.middleCols(first, count)) >= 0) return id;
    first += count;
  }
  return {};
}

/// Obstacles and grasps have names that can be those of topics, each its own.
void Simulation::checkNewName(const char* what, const std::string& id) const {
  if (!isName(id)) {
    reject("'", id, "' is no name of ", what, ": letters, digits and _, a letter first");
  }
  if (obstacles_.all().count(id)) reject("there is an obstacle '", id, "' already");
  if (grasps_.all().count(id)) reject("there is a grasp '", id, "' already");
}

AddObstacleEdit Simulation::make(const AddObstacleEdit& edit, EditRecord&) {
  checkNewName("an obstacle", edit.id);
  if (config_.solver.integrator == IntegratorKind::kSymplecticEuler) {
    reject("an explicit integrator steps no paper among obstacles");
  }
  checkShape(edit.shape);
  checkPose(edit.pose);
  checkPose(edit.frame_pose);
  AddObstacleEdit made = edit;
  made.friction = edit.friction.value_or(config_.contact.friction);
  if (!(*made.friction >= 0 && *made.friction <= kMostFriction)) {
    reject("friction ", *made.friction, " is not from 0 to ", kMostFriction);
  }
  Obstacle obstacle{edit.shape, *made.friction, edit.frame, {}, {}, {}, {}, 0, 0};
  obstacle.base = edit.frame.empty() ? edit.pose : edit.frame_pose;
  obstacle.next = obstacle.base;
  if (!edit.frame.empty()) obstacle.in_base = edit.pose;
  const Obstacles before = obstacles_;
  obstacles_.add(edit.id, std::move(obstacle));
  remakeObstacles();
  const double gap = smallestGap(obstacle_contact_->contacts(positionsWithObstacles()));
  if (cutObstacle(sheet_, motion_.positions) == edit.id || (gap >= 0 && gap <= kClosestGap)) {
    obstacles_ = before;
    remakeObstacles();
    reject("obstacle '", edit.id, "' would cut the paper");
  }
  pinsChanged();
  return made;
}

RemoveObstacleEdit Simulation::make(const RemoveObstacleEdit& edit, EditRecord& record) {
  record.ids = namesOrAll(edit.ids, "obstacle", obstacles_.all());
  for (const std::string& id : record.ids) obstacles_.remove(id);
  remakeObstacles();
  pinsChanged();
  return {record.ids};
}

MoveObstacleEdit Simulation::make(const MoveObstacleEdit& edit, EditRecord&) {
  const auto place = obstacles_.all().find(edit.id);
  if (place == obstacles_.all().end()) reject("there is no obstacle '", edit.id, "'");
  if (!place->second.frame.empty()) {
    reject("obstacle '", edit.id, "' is carried by frame \"", place->second.frame, "\"");
  }
  checkPose(edit.pose);
  if (!(edit.duration >= 0 && edit.duration <= kLongestMove)) {
    reject("duration ", edit.duration, " s is not from 0 to ", kLongestMove);
  }
  obstacles_.move(edit.id, edit.pose, std::max(edit.duration, config_.solver.time_step));
  return edit;
}

std::map<std::string, CarriedFrame> Simulation::carriedFrames() const {
  std::map<std::string, CarriedFrame> frames;
  auto body = bodies_.begin();
  for (const auto& [id, obstacle] : obstacles_.all()) {
    const Surface& surface = *(body++)->surface;
    if (obstacle.frame.empty()) continue;
    CarriedFrame& frame = frames[obstacle.frame];
    frame.pose = obstacle.base;
    frame.next = obstacle.next;
    frame.places.push_back(obstacle.in_base.position);
    if (surface.half_space) continue;
    const Vector3 low = surface.vertices.rowwise().minCoeff();
    const Vector3 size = surface.vertices.rowwise().maxCoeff() - low;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 part(corner & 1, (corner >> 1) & 1, corner >> 2);
      frame.places.push_back(obstacle.in_base.toWorld(low + part.cwiseProduct(size)));
    }
  }
  for (const auto& [id, grasp] : grasps_.all()) {
    if (grasp.frame.empty()) continue;
    CarriedFrame& frame = frames[grasp.frame];
    frame.pose = grasp.pose;
    frame.next = grasp.next;
    for (const auto& [v, vertex] : grasp.vertices) frame.places.push_back(vertex.place);
  }
  for (const auto& [name, grip] : held_.grips()) {
    CarriedFrame& frame = frames[name];
    frame.pose = grip.pose;
    frame.next = grip.next;
    for (const auto& [v, place] : grip.places) frame.places.push_back(place);
  }
  return frames;
}

std::map<std::string, Wrench> Simulation::obstacleWrenches() const {
  std::map<std::string, Wrench> wrenches;
  const Positions places = obstaclePlaces();
  Eigen::Index column = 0;
  auto body = bodies_.begin();
  for (const auto& [id, obstacle] : obstacles_.all()) {
    Pose frame;
    if (!obstacle.frame.empty()) frame = obstacle.base;
    Wrench& wrench = wrenches[id];
    const Eigen::Index end = column + (body++)->surface->vertices.cols();
    for (; column < end; ++column) {
      const Vector3 force = frame.orientation.conjugate() * Vector3(obstacle_forces_.col(column));
      wrench.force += force;
      wrench.torque += frame.fromWorld(places.col(column)).cross(force);
    }
  }
  return wrenches;
}

}  // namespace shell_origami
