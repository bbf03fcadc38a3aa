#include <shell_origami/node/recipe_run.h>

#include <shell_origami/origami/fold_phase.h>
#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/report.h>

#include <ros/console.h>

#include <algorithm>
#include <array>
#include <utility>

namespace shell_origami {
namespace {

/// Of folds along lines, as manoeuvres and unfolding make them.
nlohmann::json foldsJson(const std::vector<FoldEdit>& folds) {
  nlohmann::json json = nlohmann::json::array();
  for (const FoldEdit& fold : folds) {
    const Segment& line = std::get<Segment>(fold.where);
    nlohmann::json entry{{"line", {line[0].x(), line[0].y(), line[1].x(), line[1].y()}},
                         {"angle", fold.angle},
                         {"duration", fold.duration.value_or(0)}};
    if (fold.stiffness) entry["stiffness"] = *fold.stiffness;
    json.push_back(entry);
  }
  return json;
}

std::vector<FoldEdit> foldsFrom(const nlohmann::json& json) {
  std::vector<FoldEdit> folds;
  for (const nlohmann::json& entry : json) {
    const std::array<double, 4> line = entry.at("line");
    folds.push_back(lineFold({Vector2(line[0], line[1]), Vector2(line[2], line[3])},
                             entry.at("angle"), entry.at("duration")));
    if (entry.count("stiffness")) folds.back().stiffness = entry.at("stiffness").get<double>();
  }
  return folds;
}

nlohmann::json underWayJson(const StepUnderWay& under_way) {
  nlohmann::json phases = nlohmann::json::array();
  for (const FoldPhase& phase : under_way.phases) {
    phases.push_back({{"folds", foldsJson(phase.folds)}, {"rest", phase.rest}});
  }
  return {{"phase_end", under_way.phase_end},
          {"phases", phases},
          {"result", foldsJson(under_way.result)}};
}

StepUnderWay underWayFrom(const nlohmann::json& json) {
  StepUnderWay under_way{json.at("phase_end"), {}, foldsFrom(json.at("result"))};
  for (const nlohmann::json& phase : json.at("phases")) {
    under_way.phases.push_back({foldsFrom(phase.at("folds")), phase.at("rest")});
  }
  return under_way;
}

RecipePlace placeFrom(const nlohmann::json& json) {
  return {json.at("step"),
          json.at("started"),
          json.at("step_start"),
          std::nullopt,
          json.at("failures"),
          underWayFrom(json.at("under_way")),
          foldsFrom(json.at("unfolding")),
          json.at("timeouts")};
}

}  // namespace

RecipeRun::RecipeRun(Recipe recipe, std::string output, Listener listener)
    : runner_(std::move(recipe)), output_(std::move(output)), listener_(std::move(listener)) {}

RecipeRun::RecipeRun(const nlohmann::json& checkpoint)
    : runner_(readRecipe({checkpoint.at("called"), checkpoint.at("folder"), checkpoint.at("text")},
                         configFrom(checkpoint.at("defaults"))),
              placeFrom(checkpoint)),
      output_(checkpoint.at("output")),
      start_(ros::SteadyTime::now()),
      start_time_(checkpoint.at("start")) {}

nlohmann::json RecipeRun::checkpoint() const {
  const RecipeText& source = recipe().source;
  const RecipePlace& place = runner_.place();
  return {{"called", source.called},
          {"folder", source.folder},
          {"text", source.text},
          {"step", place.step},
          {"started", place.started},
          {"step_start", place.start_time},
          {"failures", place.failures},
          {"under_way", underWayJson(place.under_way)},
          {"unfolding", foldsJson(place.unfolding)},
          {"output", output_},
          {"start", start_time_},
          {"timeouts", place.timeouts},
          {"defaults", toJson(recipe().defaults)}};
}

bool RecipeRun::update(const Simulation& simulation, const RecipeRunner::Apply& apply,
                       RecipeListener* listener) {
  if (start_.isZero()) {
    start_ = ros::SteadyTime::now();
    start_time_ = simulation.time();
  }
  before_.reset();
  const auto make = [&](const std::vector<Edit>& edits) {
    before_ = runner_.place();
    const bool made = apply(edits);
    if (made) before_.reset();
    return made;
  };
  const bool goes_on = runner_.update(simulation, make, listener);
  for (const std::string& warning : runner_.takeWarnings()) {
    ROS_WARN("%s: %s", recipe().name.c_str(), warning.c_str());
  }
  if (!goes_on) {
    finish(simulation);
    return false;
  }
  if (told_ != stepNumber()) {
    told_ = stepNumber();
    ROS_INFO("%s: %s", recipe().name.c_str(), place().c_str());
  }
  return true;
}

void RecipeRun::remember(std::uint64_t edit) {
  places_[edit] = before_ ? *before_ : runner_.place();
}

bool RecipeRun::goBack(std::uint64_t edit) {
  const auto place = places_.find(edit);
  if (place == places_.end()) return false;
  runner_.goTo(place->second);
  before_.reset();
  places_.erase(place, places_.end());
  return true;
}

std::optional<std::uint64_t> RecipeRun::firstEdit() const {
  const int step = runner_.place().step;
  const auto first = std::find_if(places_.begin(), places_.end(),
                                  [step](const auto& entry) { return entry.second.step == step; });
  if (first == places_.end() || first->second.started) return std::nullopt;
  return first->first;
}

void RecipeRun::end(const std::string& why) {
  const std::string sentence = why.empty() ? "" : "abandoned at " + place() + ": " + why;
  if (!why.empty()) ROS_WARN("%s: %s", recipe().name.c_str(), sentence.c_str());
  if (listener_) listener_(*this, sentence);
}

int RecipeRun::stepNumber() const {
  return std::min(runner_.place().step + 1, static_cast<int>(recipe().steps.size()));
}

std::string RecipeRun::place() const {
  return "step " + std::to_string(stepNumber()) + " of " + std::to_string(recipe().steps.size()) +
         ": " + runner_.doing();
}

void RecipeRun::finish(const Simulation& simulation) const {
  const double wall_time = (ros::SteadyTime::now() - start_).toSec();
  ROS_INFO("%s: done after %.2f s of simulation, %.2f s elapsed", recipe().name.c_str(),
           simulation.time() - start_time_, wall_time);
  for (const std::string& sentence : shortfalls(simulation)) {
    ROS_WARN("%s: %s", recipe().name.c_str(), sentence.c_str());
  }
  if (output_.empty()) return;
  writeResults(simulation, {recipe().name, wall_time, "", runner_.place().timeouts}, output_);
  ROS_INFO("%s: results are in %s", recipe().name.c_str(), output_.c_str());
}

}  // namespace shell_origami
