#include <shell_origami/origami/recipe.h>

#include <shell_origami/base/error.h>
#include <shell_origami/mesh/mesh_refine.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/layer_stack.h>

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

/// The edits that begin a step, and the view of the paper after it.
struct Edits {
  const Simulation& simulation;
  Viewpoint view;

  std::vector<Edit> operator()(const PinStep& step) const { return {PinEdit{step.where}}; }
  std::vector<Edit> operator()(const UnpinStep& step) const { return {UnpinEdit{step.where}}; }
  std::vector<Edit> operator()(const FoldStep& step) const {
    std::vector<Edit> edits;
    for (FoldEdit fold : step.folds) {
      if (!fold.duration) fold.duration = step.duration;
      edits.emplace_back(std::move(fold));
    }
    return edits;
  }
  std::vector<Edit> operator()(const SettleStep& step) const {
    if (!step.quasi_static) return {};
    return {SettleEdit{}};
  }
  std::vector<Edit> operator()(const FoldThroughStep& step) {
    FoldThrough fold = step.fold;
    fold.duration = step.duration;
    const FoldPlan plan = planFold(fold, view, simulation);
    view = plan.after;
    std::vector<Edit> edits;
    for (const FoldEdit& edit : foldEdits(plan, fold)) edits.emplace_back(edit);
    return edits;
  }
  std::vector<Edit> operator()(const TurnOverStep&) {
    view.front = !view.front;
    return {};
  }
  std::vector<Edit> operator()(const LookStep& step) {
    view = viewFrom(step.from, simulation);
    return {};
  }
  std::vector<Edit> operator()(const WaitStep&) const { return {}; }
  std::vector<Edit> operator()(const AddVertexStep& step) const { return {step.edit}; }
  std::vector<Edit> operator()(const StopStep&) const { return {StopEdit{}}; }
  std::vector<Edit> operator()(const ConfigureStep& step) const {
    LiveConfig live = liveConfigOf(simulation.config());
    live.gravity = step.gravity.value_or(live.gravity);
    live.air_damping = step.air_damping.value_or(live.air_damping);
    live.fold_duration = step.fold_duration.value_or(live.fold_duration);
    return {ConfigureEdit{live}};
  }
};

/// Whether a step is over.
struct Over {
  const Simulation& simulation;
  double elapsed;

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
};

}  // namespace

bool RecipeRunner::update(const Simulation& simulation, const Apply& apply,
                          RecipeListener* listener) {
  while (!finished()) {
    const RecipeStep& step = recipe_.steps[place_.step];
    if (!place_.started) {
      Edits visitor{simulation, place_.view.value_or(frontOf(simulation.sheet()))};
      const std::vector<Edit> edits = std::visit(visitor, step);
      const bool made = edits.empty() || apply(edits);
      place_.started = true;
      place_.view = visitor.view;
      place_.start_time = simulation.time();
      if (!made) return true;
      if (listener) listener->onStepBegun(step, simulation.time());
    }
    if (!over(simulation)) return true;
    if (listener) listener->onStepOver(simulation.time());
    ++place_.step;
    place_.started = false;
  }
  return false;
}

bool RecipeRunner::update(Simulation& simulation) {
  return update(simulation, [&](const std::vector<Edit>& edits) {
    simulation.apply(edits);
    return true;
  });
}

/// Whether the step under way is.
bool RecipeRunner::over(const Simulation& simulation) {
  const Over over{simulation, simulation.time() - place_.start_time};
  const auto lasts = recipe_.lasts.find(place_.step);
  if (lasts != recipe_.lasts.end()) return over.after(lasts->second);
  const RecipeStep& step = recipe_.steps[place_.step];
  if (!std::visit(over, step)) return false;
  const auto* settle = std::get_if<SettleStep>(&step);
  if (settle && !settle->quasi_static && !over.settled()) noteTimeout(*settle);
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
