#include <shell_origami/origami/simulation.h>

#include <shell_origami/base/error.h>

#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// Beyond this [N*m/rad per m], 20,000 times a paper's crease, the matrix of a step is too badly
/// conditioned to be factorized.
constexpr double kStiffest = 100;
void checkFold(const FoldRequest& request) {
  if (!(std::abs(request.angle) < M_PI)) {
    reject("angle ", request.angle, " rad is not inside (-pi, pi)");
  }
  if (request.duration && !(*request.duration >= 0 && std::isfinite(*request.duration))) {
    reject("duration ", *request.duration, " s is negative or not finite");
  }
  if (request.stiffness && !(*request.stiffness > 0 && *request.stiffness <= kStiffest)) {
    reject("stiffness ", *request.stiffness, " N*m/rad per m is not positive and at most ",
           kStiffest);
  }
}

}  // namespace

FoldResult Simulation::fold(const FoldRequest& request) {
  checkFold(request);
  if (const auto* named = std::get_if<CreaseName>(&request.where)) {
    return foldNamed(named->name, request);
  }
  if (const auto* line = std::get_if<Segment>(&request.where)) return foldLine(*line, request);
  const auto [a, b] = std::get<VertexPair>(request.where).vertices;
  checkVertex(sheet_, a);
  checkVertex(sheet_, b);
  if (a == b) reject("both ends of the line are vertex ", a);
  return foldLine({sheet_.flatPositions()[a], sheet_.flatPositions()[b]}, request);
}

FoldResult Simulation::foldLine(const Segment& line, const FoldRequest& request) {
  const std::vector<Crease> creases_before = sheet_.creases();
  FoldLine made = makeFoldLine(sheet_, line, request.name, {&motion_.positions, pinned()});
  follow(made.remap, creases_before);
  for (std::uint32_t id : made.crease_ids) {
    startRamp(sheet_.creaseIndex(id), request.angle, request);
  }
  creases_.synchronize(time_);
  updateRestState(time_);
  EditRecord edit = foldRecord(request, made.vertices);
  edit.line = {line[0], line[1]};
  edit.name = request.name;
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
  if (result.crease_ids.empty()) reject("no crease or group of creases is called '", name, "'");
  creases_.synchronize(time_);
  updateRestState(time_);
  EditRecord edit = foldRecord(request, result.vertices);
  edit.crease = name;
  record(std::move(edit));
  return result;
}

void Simulation::startRamp(int crease, double target, const FoldRequest& request) {
  creases_.start(crease, target, time_, request.duration.value_or(config_.fold_duration),
                 request.stiffness.value_or(config_.material.crease_stiffness), shell_.shell(),
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

std::vector<int> Simulation::pin(const PinWhere& where) {
  EditRecord edit;
  edit.vertices = verticesAt(where, sheet_, motion_.positions);
  held_.holdInPlace(edit.vertices);
  return pinned(std::move(edit));
}

std::vector<int> Simulation::pin(const PinWhere& where, const std::string& frame,
                                 const Pose& pose) {
  if (frame.empty()) reject("the frame that is to hold the paper has no name");
  checkPose(pose);
  EditRecord edit;
  edit.vertices = verticesAt(where, sheet_, motion_.positions);
  edit.frame = frame;
  edit.pose = pose;
  held_.holdByFrame(edit.vertices, frame, pose, motion_.positions);
  return pinned(std::move(edit));
}

std::vector<int> Simulation::pinned(EditRecord edit) {
  pinsChanged();
  edit.kind = EditRecord::kPin;
  std::vector<int> vertices = edit.vertices;
  record(std::move(edit));
  return vertices;
}

std::vector<int> Simulation::unpin(const std::vector<std::int64_t>& vertices) {
  std::set<int> freed;
  for (std::int64_t v : vertices) {
    checkVertex(sheet_, v);
    if (!pinned().count(static_cast<int>(v))) reject("vertex ", v, " is not pinned");
    freed.insert(static_cast<int>(v));
  }
  if (vertices.empty()) freed = pinned();
  held_.release(freed);
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

void Simulation::stopFolds() {
  if (!folding()) return;
  creases_.stop(time_);
  EditRecord edit;
  edit.kind = EditRecord::kStop;
  record(std::move(edit));
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
    for (int v : pinned()) motion_.accelerations.col(v).setZero();
  }
  config_ = changed;
  shell_.gravity = config_.gravity;
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

void Simulation::carry(const std::string& frame, const Pose& pose) {
  checkPose(pose);
  const auto grip = held_.grips().find(frame);
  if (grip == held_.grips().end()) reject("frame \"", frame, "\" holds no vertex");
  if (grip->second.pose == pose) return;
  held_.carry(frame, pose);
  EditRecord edit;
  edit.kind = EditRecord::kCarry;
  edit.frame = frame;
  edit.pose = pose;
  record(std::move(edit));
}

namespace {

FoldRequest foldRequest(const EditRecord& edit) {
  FoldRequest fold;
  if (edit.crease.empty()) {
    if (edit.line.size() != 2) reject("a recorded fold has ", edit.line.size(), " ends, not two");
    fold.where = Segment{edit.line[0], edit.line[1]};
  } else {
    fold.where = CreaseName{edit.crease};
  }
  fold.angle = edit.angle;
  fold.duration = edit.duration;
  fold.stiffness = edit.stiffness;
  fold.name = edit.name;
  return fold;
}

}  // namespace

void Simulation::redo(const EditRecord& edit) {
  const std::vector<std::int64_t> vertices(edit.vertices.begin(), edit.vertices.end());
  switch (edit.kind) {
    case EditRecord::kFold: fold(foldRequest(edit)); break;
    case EditRecord::kPin:
      if (edit.frame.empty()) pin(vertices);
      else pin(vertices, edit.frame, edit.pose);
      break;
    case EditRecord::kUnpin: unpin(vertices); break;
    case EditRecord::kAddVertex:
      if (vertices.size() < 2) reject("a recorded vertex lies on no edge");
      addVertex(vertices[0], vertices[1], edit.fraction);
      break;
    case EditRecord::kSettle: {
      const StepReport report = settle();
      if (!report.converged) reject("it does not settle again: ", report.failure);
      break;
    }
    case EditRecord::kCarry: carry(edit.frame, edit.pose); break;
    case EditRecord::kStop: stopFolds(); break;
    case EditRecord::kConfigure: configure({edit.gravity, edit.air_damping, edit.duration}); break;
  }
}

}  // namespace shell_origami
