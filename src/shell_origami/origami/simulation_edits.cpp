#include <shell_origami/origami/simulation.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/parameter_table.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

namespace shell_origami {
namespace {

void checkFold(const FoldEdit& edit) {
  if (!(std::abs(edit.angle) < M_PI)) {
    reject("angle ", edit.angle, " rad is not inside (-pi, pi)");
  }
  if (!(edit.part >= 0 && edit.part <= 1)) reject("part ", edit.part, " is not from 0 to 1");
  if (edit.part > 0 && !std::holds_alternative<CreaseName>(edit.where)) {
    reject("part ", edit.part, " of which angle? The pattern asks for none of a line");
  }
  if (edit.duration && !(*edit.duration >= 0 && std::isfinite(*edit.duration))) {
    reject("duration ", *edit.duration, " s is negative or not finite");
  }
  if (double stiffness = edit.stiffness.value_or(0); edit.stiffness) {
    checkValue("stiffness", &stiffness, boundsOf("material/crease_stiffness"));
  }
}

}  // namespace

EditRecord Simulation::apply(const Edit& edit) {
  return threads_.run([&] { return applyHere(edit); });
}

EditRecord Simulation::applyHere(const Edit& edit) {
  EditRecord record;
  record.step = counters_.steps;
  record.time = time_;
  record.edit = std::visit([&](const auto& kind) -> Edit { return make(kind, record); }, edit);
  record.revision = sheet_.revision();
  resting_ = false;
  edited_ = !std::holds_alternative<SettleEdit>(edit);  // which leaves it in equilibrium
  return record;
}

std::vector<EditRecord> Simulation::apply(const std::vector<Edit>& edits) {
  std::vector<EditRecord> records;
  if (edits.size() == 1) return {apply(edits[0])};
  const Snapshot before = snapshot();
  try {
    for (const Edit& edit : edits) records.push_back(apply(edit));
  } catch (const std::invalid_argument&) {
    std::function<bool()> interrupt = std::move(interrupt_);
    *this = Simulation(before);
    interrupt_ = std::move(interrupt);
    throw;
  }
  return records;
}

FoldEdit Simulation::make(const FoldEdit& edit, EditRecord& record) {
  checkFold(edit);
  FoldEdit made = edit;
  made.duration = edit.duration.value_or(config_.fold_duration);
  made.stiffness = edit.stiffness.value_or(config_.material.crease_stiffness);
  if (const auto* named = std::get_if<CreaseName>(&edit.where)) {
    foldNamed(named->name, made, record);
  } else if (const auto* line = std::get_if<Segment>(&edit.where)) {
    foldLine(*line, made, record);
  } else {
    const auto [a, b] = std::get<VertexPair>(edit.where).vertices;
    checkVertex(sheet_, a);
    checkVertex(sheet_, b);
    if (a == b) reject("both ends of the line are vertex ", a);
    const Segment between{sheet_.flatPositions()[a], sheet_.flatPositions()[b]};
    foldLine(between, made, record);
    made.where = between;
  }
  updateRestState(time_);
  stepper_.restoreState({});
  return made;
}

void Simulation::foldLine(const Segment& line, const FoldEdit& edit, EditRecord& record) {
  const std::vector<Crease> creases_before = sheet_.creases();
  FoldLine line_made = insertLine(line, edit.name);
  follow(line_made.remap, creases_before);
  for (std::uint32_t id : line_made.crease_ids) {
    startRamp(sheet_.creaseIndex(id), edit.angle, edit);
  }
  record.crease_ids = std::move(line_made.crease_ids);
  record.vertices = std::move(line_made.vertices);
  record.parts = line_made.parts;
}

/// Makes the line in the sheet. Where the repair of slivers would push paper through paper, edges
/// are split only.
FoldLine Simulation::insertLine(const Segment& line, const std::string& name) {
  EditContext context{&motion_.positions, pinned()};
  const bool separate = contactOn() && left_out_.empty();
  if (separate || obstacle_contact_) {
    Sheet trial = sheet_;
    FoldLine made = makeFoldLine(trial, line, name, context);
    const Positions moved = made.remap.apply(motion_.positions, trial.vertexCount());
    const bool apart = !separate || shell_origami::crossings(trial, moved).empty();
    if (apart && cutObstacle(trial, moved).empty()) {
      sheet_ = std::move(trial);
      return made;
    }
    context.exact = true;
  }
  return makeFoldLine(sheet_, line, name, context);
}

namespace {

double targetAngle(const Crease& crease, const FoldEdit& edit, bool by_group) {
  if (edit.part > 0) {
    return std::clamp(edit.part * crease.pattern_angle, -kLargestRestAngle, kLargestRestAngle);
  }
  return by_group ? std::copysign(edit.angle, crease.pattern_angle) : edit.angle;
}

}  // namespace

void Simulation::foldNamed(const std::string& name, const FoldEdit& edit, EditRecord& record) {
  std::vector<std::pair<int, double>> targets;
  for (std::size_t i = 0; i < sheet_.creases().size(); ++i) {
    const Crease& crease = sheet_.creases()[i];
    const bool by_group = inGroup(crease, name);
    if (!by_group && crease.name != name) continue;
    const double target = targetAngle(crease, edit, by_group);
    if (std::isnan(target)) {
      reject("part ", edit.part, " of which angle? The pattern asks for none of crease '", name,
             "'");
    }
    targets.emplace_back(static_cast<int>(i), target);
    record.crease_ids.push_back(crease.id);
    record.vertices.insert(record.vertices.end(), crease.vertices.begin(), crease.vertices.end());
  }
  if (targets.empty()) reject("no crease or group of creases is called '", name, "'");
  for (const auto& [crease, target] : targets) startRamp(crease, target, edit);
}

void Simulation::startRamp(int crease, double target, const FoldEdit& edit) {
  const bool of_pattern = std::holds_alternative<CreaseName>(edit.where) &&
                          !std::isnan(sheet_.creases()[crease].pattern_angle);
  creases_.start(crease, target, time_, *edit.duration, *edit.stiffness, of_pattern, shell_.shell(),
                 motion_.positions);
}

namespace {

PinWhere numbersOf(const std::vector<int>& vertices) {
  return std::vector<std::int64_t>(vertices.begin(), vertices.end());
}

}  // namespace

PinEdit Simulation::make(const PinEdit& edit, EditRecord& record) {
  if (!edit.frame.empty()) checkPose(edit.pose);
  record.vertices = verticesAt(edit.where, sheet_, motion_.positions);
  if (edit.frame.empty()) held_.holdInPlace(record.vertices);
  else held_.holdByFrame(record.vertices, edit.frame, edit.pose, motion_.positions);
  pinsChanged();
  return {numbersOf(record.vertices), edit.frame, edit.pose};
}

UnpinEdit Simulation::make(const UnpinEdit& edit, EditRecord& record) {
  const std::set<int>& held = pinned();
  if (edit.where) record.vertices = verticesAt(*edit.where, sheet_, motion_.positions);
  else record.vertices.assign(held.begin(), held.end());
  for (int v : record.vertices) {
    if (!held.count(v)) reject("vertex ", v, " is not pinned");
  }
  held_.release({record.vertices.begin(), record.vertices.end()});
  pinsChanged();
  // No vertices at all is more than verticesAt() takes.
  if (record.vertices.empty()) return {};
  return {numbersOf(record.vertices)};
}

AddVertexEdit Simulation::make(const AddVertexEdit& edit, EditRecord& record) {
  const auto [a, b] = edit.edge;
  checkVertex(sheet_, a);
  checkVertex(sheet_, b);
  const std::vector<Crease> creases_before = sheet_.creases();
  const AddedVertex added =
      shell_origami::addVertex(sheet_, static_cast<int>(a), static_cast<int>(b), edit.fraction);
  follow(added.remap, creases_before);
  record.vertices = {added.vertex};
  return edit;
}

CarryEdit Simulation::make(const CarryEdit& edit, EditRecord&) {
  checkPose(edit.pose);
  const bool holds = held_.grips().count(edit.frame) > 0;
  if (!holds && !obstacles_.carriedBy(edit.frame) && !grasps_.carriedBy(edit.frame)) {
    reject("frame \"", edit.frame, "\" holds no vertex");
  }
  if (holds) held_.carry(edit.frame, edit.pose);
  obstacles_.carry(edit.frame, edit.pose);
  grasps_.carry(edit.frame, edit.pose);
  return edit;
}

SettleEdit Simulation::make(const SettleEdit& edit, EditRecord& record) {
  const CreaseActuation creases = creases_;
  const RestShape rest = rest_;
  const Compliance compliance = compliance_;
  const RestState rest_state = shell_.rest;
  const SolverState solver = stepper_.state();
  const auto adapt = [this](const Positions& positions) {
    if (interrupt_ && interrupt_()) reject("the paper was interrupted before it found equilibrium");
    giveWay(positions);
  };
  try {
    if (!folding()) compliance_ = {};
    updateRestState(time_);
    record.report = counted(relax(adapt));
    if (!record.report.converged) reject(record.report.failure);
  } catch (const std::invalid_argument&) {
    creases_ = creases;
    rest_ = rest;
    compliance_ = compliance;
    shell_.rest = rest_state;
    stepper_.restoreState(solver);
    throw;
  }
  return edit;
}

StopEdit Simulation::make(const StopEdit& edit, EditRecord&) {
  creases_.stop(time_);
  obstacles_.stop();
  return edit;
}

ConfigureEdit Simulation::make(const ConfigureEdit& edit, EditRecord&) {
  const LiveConfig& live = edit.live;
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
  return edit;
}

std::vector<int> Simulation::pin(const PinWhere& where, const std::string& frame,
                                 const Pose& pose) {
  if (frame.empty()) reject("the name of the frame that is to hold the paper is empty");
  return apply(PinEdit{where, frame, pose}).vertices;
}

std::vector<int> Simulation::unpin(const std::optional<PinWhere>& where) {
  return apply(UnpinEdit{where}).vertices;
}

int Simulation::addVertex(std::int64_t a, std::int64_t b, double fraction) {
  return apply(AddVertexEdit{{a, b}, fraction}).vertices.front();
}

}  // namespace shell_origami
