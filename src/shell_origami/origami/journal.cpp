#include <shell_origami/origami/journal.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/recipe_writer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// Part of a time step by which times that are sums of the same steps differ at most.
constexpr double kSameTime = 1e-3;

/// The step that an edit makes; none of a frame that moves.
struct StepOf {
  const EditRecord& made;
  const LiveConfig& before;

  std::optional<RecipeStep> operator()(const FoldEdit&) const {
    FoldEdit fold = std::get<FoldEdit>(made.edit);
    const double duration = *std::exchange(fold.duration, std::nullopt);
    return FoldStep{{fold}, {}, duration};
  }
  std::optional<RecipeStep> operator()(const PinEdit& given) const {
    // Recipes have no balls in space.
    const bool by_number = std::holds_alternative<Ball>(given.where);
    return PinStep{by_number ? std::get<PinEdit>(made.edit).where : given.where};
  }
  std::optional<RecipeStep> operator()(const UnpinEdit& given) const {
    return UnpinStep{given.where ? std::get<UnpinEdit>(made.edit).where : std::nullopt};
  }
  std::optional<RecipeStep> operator()(const AddVertexEdit& given) const {
    return AddVertexStep{given};
  }
  std::optional<RecipeStep> operator()(const CarryEdit&) const { return std::nullopt; }
  std::optional<RecipeStep> operator()(const SettleEdit&) const {
    SettleStep step;
    step.quasi_static = true;
    return step;
  }
  std::optional<RecipeStep> operator()(const StopEdit&) const { return StopStep{}; }
  std::optional<RecipeStep> operator()(const ConfigureEdit& given) const {
    const LiveConfig& live = given.live;
    ConfigureStep step;
    if (live.gravity != before.gravity) step.gravity = live.gravity;
    if (live.air_damping != before.air_damping) step.air_damping = live.air_damping;
    if (live.fold_duration != before.fold_duration) step.fold_duration = live.fold_duration;
    if (!step.gravity && !step.air_damping && !step.fold_duration) return std::nullopt;
    return step;
  }
  std::optional<RecipeStep> operator()(const AddObstacleEdit&) const {
    AddObstacleEdit held = std::get<AddObstacleEdit>(made.edit);
    // Recipes have no frames.
    held.pose = held.frame_pose * held.pose;
    held.frame.clear();
    held.frame_pose = {};
    return AddObstacleStep{{held}};
  }
  std::optional<RecipeStep> operator()(const RemoveObstacleEdit&) const {
    return RemoveObstacleStep{made.ids};
  }
  std::optional<RecipeStep> operator()(const MoveObstacleEdit& given) const {
    return MoveObstacleStep{given.id, given.pose, given.duration};
  }
  std::optional<RecipeStep> operator()(const GraspEdit& given) const {
    GraspEdit held = given;
    if (std::holds_alternative<Ball>(given.where))
      held.where = std::get<GraspEdit>(made.edit).where;
    // Recipes have no frames.
    held.frame.clear();
    return GraspStep{held};
  }
  std::optional<RecipeStep> operator()(const ReleaseEdit&) const { return ReleaseStep{made.ids}; }
};

/// Whether a step may take time by itself.
struct TakesTime {
  template <class Step>
  bool operator()(const Step&) const {
    return true;
  }
  bool operator()(const PinStep&) const { return false; }
  bool operator()(const UnpinStep&) const { return false; }
  bool operator()(const TurnOverStep&) const { return false; }
  bool operator()(const LookStep&) const { return false; }
  bool operator()(const AddVertexStep&) const { return false; }
  bool operator()(const StopStep&) const { return false; }
  bool operator()(const ConfigureStep&) const { return false; }
  bool operator()(const LoosenStep&) const { return false; }
  bool operator()(const AddObstacleStep&) const { return false; }
  bool operator()(const RemoveObstacleStep&) const { return false; }
  bool operator()(const GraspStep&) const { return false; }
  bool operator()(const ReleaseStep&) const { return false; }
};

/// Adds a step to the one before where one step can do both, without time between them.
bool merge(const WrittenStep& next, WrittenStep& before) {
  auto* folds = std::get_if<FoldStep>(&before.step);
  const auto* more_folds = std::get_if<FoldStep>(&next.step);
  if (folds && more_folds && before.lasts == 0.0 && folds->duration == more_folds->duration) {
    for (const auto& [i, ends] : more_folds->lines) {
      folds->lines[folds->folds.size() + i] = ends;
    }
    folds->folds.insert(folds->folds.end(), more_folds->folds.begin(), more_folds->folds.end());
    before.lasts = next.lasts;
    return true;
  }
  auto* values = std::get_if<ConfigureStep>(&before.step);
  const auto* more_values = std::get_if<ConfigureStep>(&next.step);
  if (!values || !more_values) return false;
  if (more_values->gravity) values->gravity = more_values->gravity;
  if (more_values->air_damping) values->air_damping = more_values->air_damping;
  if (more_values->fold_duration) values->fold_duration = more_values->fold_duration;
  return true;
}

}  // namespace

Journal::Journal(const nlohmann::json& json)
    : moved_first_(json.at("moved_first")), of_recipe_(json.at("of_recipe")) {
  const Recipe recipe = readRecipe({"the journal", "", json.at("recipe")});
  origin_ = {recipe.sheet, recipe.config, recipe.names};
  const nlohmann::json& times = json.at("times");
  if (times.size() != recipe.steps.size()) {
    reject("a journal has ", recipe.steps.size(), " steps, but times of ", times.size());
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    DoneStep done{recipe.steps[i], times[i].at(0), times[i].at(1)};
    if (!times[i].at(2).is_null()) done.over = times[i].at(2).get<double>();
    done.frame = times[i].at(3).get<std::string>();
    steps_.push_back(std::move(done));
  }
}

nlohmann::json Journal::toJson() const {
  std::vector<WrittenStep> steps;
  nlohmann::json times = nlohmann::json::array();
  for (const DoneStep& done : steps_) {
    steps.push_back({done.step});
    const nlohmann::json over = done.over ? nlohmann::json(*done.over) : nlohmann::json();
    times.push_back({done.start, done.moved_until, over, done.frame});
  }
  return {{"recipe", recipeText(origin_, steps)},
          {"moved_first", moved_first_},
          {"of_recipe", of_recipe_},
          {"times", times}};
}

void Journal::addNames(const LandmarkNames& names) {
  for (const auto& [name, landmark] : names) origin_.names[name] = landmark;
}

void Journal::add(RecipeStep step, double time) { steps_.push_back({std::move(step), time, time}); }

void Journal::add(const Edit& given, const EditRecord& made, const LiveConfig& before) {
  std::optional<RecipeStep> step = std::visit(StepOf{made, before}, given);
  if (!step) return;
  add(std::move(*step), made.time);
  if (const auto* pin = std::get_if<PinEdit>(&given)) steps_.back().frame = pin->frame;
  if (const auto* added = std::get_if<AddObstacleEdit>(&given)) steps_.back().frame = added->frame;
  if (const auto* grasp = std::get_if<GraspEdit>(&given)) steps_.back().frame = grasp->frame;
}

void Journal::moved(double time) {
  (steps_.empty() ? moved_first_ : steps_.back().moved_until) = time;
}

void Journal::onStepBegun(const RecipeStep& step, double time) {
  add(step, time);
  of_recipe_ = steps_.size();
}

/// An edit that somebody made meanwhile is a step of its own, and ended the recipe's step before.
void Journal::onStepOver(double time) {
  if (!steps_.empty() && of_recipe_ == steps_.size()) steps_.back().over = time;
}

void Journal::keepFirst(std::size_t count) {
  steps_.resize(count);
  if (of_recipe_ > count) of_recipe_ = 0;
}

std::vector<WrittenStep> Journal::written(bool folding) const {
  std::vector<WrittenStep> steps;
  const double same_time = kSameTime * origin_.config.solver.time_step;
  double now = 0;  // of the recipe
  const auto wait = [&](double seconds) {
    if (seconds < same_time) return;
    steps.push_back({WaitStep{seconds}});
    now += seconds;
  };
  wait(moved_first_);
  for (const DoneStep& done : steps_) {
    WrittenStep step{done.step, std::nullopt, done.frame};
    double until = done.start;
    if (std::visit(TakesTime{}, done.step)) {
      until = done.over.value_or(done.moved_until);
      // Where time was left out before, rounding could end a step at another step of time.
      const bool ends_itself =
          done.over ? std::abs(now - done.start) < same_time : folding && &done == &steps_.back();
      if (!ends_itself) step.lasts = until - done.start;
      now += until - done.start;
    }
    if (steps.empty() || !merge(step, steps.back())) steps.push_back(std::move(step));
    wait(done.moved_until - until);
  }
  return steps;
}

std::set<std::string> Journal::frames() const {
  std::set<std::string> frames;
  for (const DoneStep& done : steps_) {
    if (!done.frame.empty()) frames.insert(done.frame);
  }
  return frames;
}

}  // namespace shell_origami
