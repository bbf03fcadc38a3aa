#include <shell_origami/node/recipe_run.h>

#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/report.h>

#include <ros/console.h>

#include <algorithm>
#include <utility>

namespace shell_origami {

RecipeRun::RecipeRun(Recipe recipe, std::string output, Listener listener)
    : runner_(std::move(recipe)), output_(std::move(output)), listener_(std::move(listener)) {}

RecipeRun::RecipeRun(const nlohmann::json& checkpoint)
    : runner_(readRecipe({checkpoint.at("called"), checkpoint.at("folder"), checkpoint.at("text")},
                         configFrom(checkpoint.at("defaults"))),
              {checkpoint.at("step"), checkpoint.at("started"), checkpoint.at("step_start"),
               std::nullopt, checkpoint.at("timeouts")}),
      output_(checkpoint.at("output")),
      start_(ros::SteadyTime::now()),
      start_time_(checkpoint.at("start")) {}

nlohmann::json RecipeRun::checkpoint() const {
  const RecipeText& source = recipe().source;
  const RecipePlace& place = runner_.place();
  return {{"called", source.called},    {"folder", source.folder},
          {"text", source.text},        {"step", place.step},
          {"started", place.started},   {"step_start", place.start_time},
          {"output", output_},          {"start", start_time_},
          {"timeouts", place.timeouts}, {"defaults", toJson(recipe().defaults)}};
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
