#include <shell_origami/origami/recipe.h>

#include <shell_origami/base/error.h>
#include <shell_origami/mesh/mesh_refine.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/precreases.h>
#include <shell_origami/origami/step_beginning.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shell_origami {

namespace {

FoldPaper readPaper(const SheetSource& source) {
  if (!source.pattern.empty()) {
    return readPatternFile(source.pattern,
                           {source.scale, source.max_edge, source.form, source.pattern_width});
  }
  return {
      Sheet(triangulateRectangle(source.width, source.height, source.max_edge)), {}, {}, {}, {}};
}

Eigen::Isometry3d poseOf(const SheetSource& source) {
  const Vector3& angles = source.roll_pitch_yaw;
  return Eigen::Translation3d(source.position) * Eigen::AngleAxisd(angles.z(), Vector3::UnitZ()) *
         Eigen::AngleAxisd(angles.y(), Vector3::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Vector3::UnitX());
}

}  // namespace

Simulation makeSimulation(const SheetSource& source, const SimulationConfig& config,
                          std::vector<std::string>* notes) {
  FoldPaper paper = readPaper(source);
  if (notes) *notes = paper.notes;
  checkMemory(static_cast<double>(paper.sheet.triangles().size()));
  if (!paper.positions) {
    paper.positions = flatInSpace(paper.sheet);
    paper.rest_angles.assign(paper.sheet.creases().size(), std::nan(""));
  }
  const Eigen::Isometry3d pose = poseOf(source);
  const Positions positions = (pose.linear() * *paper.positions).colwise() + pose.translation();
  return Simulation(std::move(paper.sheet), config, positions, paper.rest_angles);
}

RecipeRunner::RecipeRunner(Recipe recipe, const RecipePlace& place)
    : recipe_(std::move(recipe)), place_(place) {}

namespace {

/// How often a step is tried before the recipe ends.
constexpr int kMostTries = 2;

/// Whether a step, or the phase of it that is under way, is over.
struct Over {
  const Simulation& simulation;
  double elapsed;
  double phase_end;  ///< at the latest [s]

  bool operator()(const PinStep&) const { return true; }
  bool operator()(const UnpinStep&) const { return true; }
  bool operator()(const FoldStep&) const { return !simulation.folding(); }
  bool operator()(const FoldThroughStep&) const { return !simulation.folding(); }
  bool operator()(const TurnOverStep&) const { return true; }
  bool operator()(const LookStep&) const { return true; }
  bool operator()(const WaitStep& step) const { return after(step.seconds); }
  bool operator()(const AddVertexStep&) const { return true; }
  bool operator()(const StopStep&) const { return true; }
  bool operator()(const ConfigureStep&) const { return true; }
  bool operator()(const SettleStep& step) const { return elapsed >= step.timeout || settled(); }
  bool operator()(const ManoeuvreStep&) const {
    return !simulation.folding() && (simulation.time() >= phase_end || settled());
  }
  bool operator()(const UnfoldStep&) const { return !simulation.folding(); }
  bool operator()(const LoosenStep&) const { return true; }
  bool operator()(const AddObstacleStep&) const { return true; }
  bool operator()(const RemoveObstacleStep&) const { return true; }
  bool operator()(const GraspStep&) const { return true; }
  bool operator()(const ReleaseStep&) const { return true; }
  bool operator()(const MoveObstacleStep& step) const {
    const auto& obstacles = simulation.obstacles().all();
    const auto place = obstacles.find(step.id);
    return place == obstacles.end() || place->second.left == 0;
  }
  /// The residual speeds of a fold just begun are not rest.
  bool settled() const { return elapsed > 0 && simulation.settled(); }
  /// Whether so many seconds have passed. Times are rounded as steps are added up, and as people
  /// write them.
  bool after(double seconds) const {
    return elapsed > seconds - kRounding * simulation.config().solver.time_step;
  }
  static constexpr double kRounding = 0.01;
};

struct Word {
  const char* operator()(const PinStep&) const { return "pin"; }
  const char* operator()(const UnpinStep&) const { return "unpin"; }
  const char* operator()(const FoldStep&) const { return "fold"; }
  const char* operator()(const SettleStep&) const { return "settle"; }
  const char* operator()(const FoldThroughStep&) const { return "fold_through"; }
  const char* operator()(const TurnOverStep&) const { return "turn_over"; }
  const char* operator()(const LookStep&) const { return "look_from"; }
  const char* operator()(const WaitStep&) const { return "wait"; }
  const char* operator()(const AddVertexStep&) const { return "add_vertex"; }
  const char* operator()(const StopStep&) const { return "stop"; }
  const char* operator()(const ConfigureStep&) const { return "configure"; }
  const char* operator()(const ManoeuvreStep& step) const { return wordOf(*step.manoeuvre); }
  const char* operator()(const UnfoldStep&) const { return "unfold"; }
  const char* operator()(const LoosenStep&) const { return "loosen"; }
  const char* operator()(const AddObstacleStep&) const { return "add_obstacle"; }
  const char* operator()(const RemoveObstacleStep&) const { return "remove_obstacle"; }
  const char* operator()(const MoveObstacleStep&) const { return "obstacle"; }
  const char* operator()(const GraspStep&) const { return "grasp"; }
  const char* operator()(const ReleaseStep&) const { return "release"; }
};

struct Length {
  template <class Step>
  double operator()(const Step&) const {
    return 0;
  }
  double operator()(const FoldStep& step) const { return step.duration; }
  double operator()(const SettleStep& step) const { return step.timeout; }
  double operator()(const FoldThroughStep& step) const { return step.duration; }
  double operator()(const WaitStep& step) const { return step.seconds; }
  double operator()(const ManoeuvreStep& step) const { return step.manner.duration; }
  double operator()(const UnfoldStep& step) const { return step.duration; }
  double operator()(const MoveObstacleStep& step) const { return step.duration; }
};

}  // namespace

bool RecipeRunner::update(const Simulation& simulation, const Apply& apply,
                          RecipeListener* listener) {
  while (!finished()) {
    const RecipeStep& step = recipe_.steps[place_.step];
    if (recipe_.precrease && place_.step == 0 && !place_.started) {
      drawLines(simulation, apply, listener);
    }
    if (!place_.started) {
      if (!begin(step, simulation, apply)) return true;
      if (listener) listener->onStepBegun(step, simulation.time());
    }
    if (!over(simulation)) return true;
    if (!place_.under_way.phases.empty()) {
      beginPhase(simulation, apply);
      continue;
    }
    if (std::holds_alternative<ManoeuvreStep>(step)) checkResult(simulation);
    if (listener) listener->onStepOver(simulation.time());
    ++place_.step;
    place_.started = false;
    place_.failures = 0;
    place_.under_way = {};
  }
  return false;
}

/// Draws the recipe's lines on the flat sheet.
void RecipeRunner::drawLines(const Simulation& simulation, const Apply& apply,
                             RecipeListener* listener) {
  FoldStep drawing{precreasesOf(recipe_), {}, 0};
  if (drawing.folds.empty()) return;
  apply({drawing.folds.begin(), drawing.folds.end()});
  if (!listener) return;
  listener->onStepBegun(drawing, simulation.time());
  listener->onStepOver(simulation.time());
}

bool RecipeRunner::begin(const RecipeStep& step, const Simulation& simulation, const Apply& apply) {
  StepBeginning beginning = beginningOf(step, place_, simulation);
  std::vector<FoldEdit> unfolding = unfoldingOf(foldsOf(beginning), simulation);
  const bool made = beginning.edits.empty() || apply(beginning.edits);
  if (!unfolding.empty()) place_.unfolding = std::move(unfolding);
  place_.started = true;
  place_.view = beginning.view;
  place_.under_way = std::move(beginning.under_way);
  place_.start_time = simulation.time();
  return made;
}

void RecipeRunner::beginPhase(const Simulation& simulation, const Apply& apply) {
  StepUnderWay& under_way = place_.under_way;
  const FoldPhase phase = std::move(under_way.phases.front());
  under_way.phases.erase(under_way.phases.begin());
  under_way.phase_end = simulation.time() + lengthOf(phase);
  apply({phase.folds.begin(), phase.folds.end()});
}

bool RecipeRunner::update(Simulation& simulation) {
  return update(simulation, [&](const std::vector<Edit>& edits) {
    simulation.apply(edits);
    return true;
  });
}

void RecipeRunner::checkResult(const Simulation& simulation) const {
  const std::vector<std::string> failures = failuresOf(place_.under_way.result, simulation);
  if (failures.empty()) return;
  std::ostringstream sentence;
  sentence << "step " << place_.step + 1 << ", " << doing() << ", failed: " << failures.front();
  if (failures.size() > 1) sentence << ", and " << failures.size() - 1 << " more";
  throw StepFailed(sentence.str(), place_.failures + 1);
}

bool RecipeRunner::tryAgain(const StepFailed& failed, const RecipePlace& before) {
  place_ = before;
  if (failed.failures() >= kMostTries) return false;
  place_.failures = failed.failures();
  warnings_.push_back(failed.what() + std::string("; it is tried again, looser and slower"));
  return true;
}

/// Whether the step under way, or its phase, is over.
bool RecipeRunner::over(const Simulation& simulation) {
  const bool last_phase = place_.under_way.phases.empty();
  const Over over{simulation, simulation.time() - place_.start_time, place_.under_way.phase_end};
  const auto lasts = recipe_.lasts.find(place_.step);
  if (lasts != recipe_.lasts.end() && last_phase) {
    return over.after(lasts->second);
  }
  const RecipeStep& step = recipe_.steps[place_.step];
  if (!std::visit(over, step)) return false;
  const auto* settle = std::get_if<SettleStep>(&step);
  if (settle && !settle->quasi_static && !over.settled()) noteTimeout(*settle);
  if (const auto* move = std::get_if<MoveObstacleStep>(&step)) noteStopped(*move, simulation);
  return true;
}

/// About how long a step takes [s].
double RecipeRunner::length(int step) const {
  const auto lasts = recipe_.lasts.find(step);
  if (lasts != recipe_.lasts.end()) return lasts->second;
  return std::visit(Length{}, recipe_.steps[step]);
}

void RecipeRunner::noteTimeout(const SettleStep& step) {
  place_.timeouts.push_back(place_.step);
  std::ostringstream warning;
  warning << "step " << place_.step + 1 << ": the paper had not settled after " << step.timeout
          << " s, its timeout";
  warnings_.push_back(warning.str());
}

/// Says how far the paper kept an obstacle from where it was to be.
void RecipeRunner::noteStopped(const MoveObstacleStep& step, const Simulation& simulation) {
  const auto place = simulation.obstacles().all().find(step.id);
  if (place == simulation.obstacles().all().end() || place->second.base == step.pose) return;
  const Pose& pose = place->second.base;
  std::ostringstream warning;
  warning << "step " << place_.step + 1 << ": the paper stopped obstacle '" << step.id << "' "
          << (pose.position - step.pose.position).norm() << " m and "
          << pose.orientation.angularDistance(step.pose.orientation)
          << " rad before where it was to be";
  warnings_.push_back(warning.str());
}

double RecipeRunner::progress(const Simulation& simulation) const {
  double total = 0, done = 0;
  for (int i = 0; i < static_cast<int>(recipe_.steps.size()); ++i) {
    const double whole = length(i);
    total += whole;
    if (i < place_.step) done += whole;
    if (i == place_.step && place_.started)
      done += std::min(whole, simulation.time() - place_.start_time);
  }
  return finished() || total == 0 ? 1 : done / total;
}

std::string RecipeRunner::doing() const {
  return finished() ? "done" : std::visit(Word{}, recipe_.steps[place_.step]);
}

}  // namespace shell_origami
