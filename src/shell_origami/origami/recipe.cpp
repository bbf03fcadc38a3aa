#include <shell_origami/origami/recipe.h>

#include <shell_origami/base/error.h>
#include <shell_origami/mesh/mesh_refine.h>
#include <shell_origami/mesh/triangulate.h>

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
  std::vector<Edit> operator()(const UnpinStep& step) const {
    if (step.points.empty()) return {UnpinEdit{}};
    return {UnpinEdit{step.points}};
  }
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
  bool operator()(const SettleStep& step) const { return elapsed >= step.timeout || settled(); }
  /// The residual speeds of a fold just begun are not rest.
  bool settled() const { return elapsed > 0 && simulation.settled(); }
};

struct Word {
  const char* operator()(const PinStep&) const { return "pin"; }
  const char* operator()(const UnpinStep&) const { return "unpin"; }
  const char* operator()(const FoldStep&) const { return "fold"; }
  const char* operator()(const SettleStep&) const { return "settle"; }
  const char* operator()(const FoldThroughStep&) const { return "fold_through"; }
  const char* operator()(const TurnOverStep&) const { return "turn_over"; }
};

struct Length {
  double operator()(const PinStep&) const { return 0; }
  double operator()(const UnpinStep&) const { return 0; }
  double operator()(const FoldStep& step) const { return step.duration; }
  double operator()(const SettleStep& step) const { return step.timeout; }
  double operator()(const FoldThroughStep& step) const { return step.duration; }
  double operator()(const TurnOverStep&) const { return 0; }
};

}  // namespace

bool RecipeRunner::update(const Simulation& simulation, const Apply& apply) {
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
    }
    const Over over{simulation, simulation.time() - place_.start_time};
    if (!std::visit(over, step)) return true;
    const auto* settle = std::get_if<SettleStep>(&step);
    if (settle && !settle->quasi_static && !over.settled()) noteTimeout(*settle);
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
    const double length = std::visit(Length{}, recipe_.steps[i]);
    total += length;
    if (i < place_.step) done += length;
    if (i == place_.step && place_.started)
      done += std::min(length, simulation.time() - place_.start_time);
  }
  return finished() || total == 0 ? 1 : done / total;
}

std::string RecipeRunner::doing() const {
  return finished() ? "done" : std::visit(Word{}, recipe_.steps[place_.step]);
}

}  // namespace shell_origami
