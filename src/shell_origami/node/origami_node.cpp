#include <shell_origami/node/origami_node.h>

#include <shell_origami/node/message_text.h>
#include <shell_origami/node/paper_sources.h>
#include <shell_origami/node/record/edit_messages.h>

#include <ros/callback_queue.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

/// How often a paused paper is published, for whoever came late and to keep its frames alive [s].
constexpr double kIdlePeriod = 0.5;
/// How often to look whether the start may be over [s].
constexpr double kWaitPeriod = 0.02;
/// How long a recorder takes from subscribing to listening [s].
constexpr double kRecorderStart = 0.3;

}  // namespace

OrigamiNode::OrigamiNode(ros::NodeHandle& node, const NodeConfig& config)
    : config_(config),
      checkpoint_(config.checkpoint, config.checkpoint_period),
      run_(beginRun(config, checkpoint_)),
      clock_(makeStepClock(node, config)),
      publishers_(node, config, [this] { return wholePaper(); }),
      start_wait_(config),
      waiting_(start_wait_.wanted() && !run_.paused) {
  run_.session.setListener(this);
  run_.session.setUndoMemory(static_cast<std::size_t>(config.undo_memory * 1e6));
  run_.paused = run_.paused || waiting_;
  const Sheet& sheet = run_.session.simulation().sheet();
  ROS_INFO("a sheet of %d vertices and %zu triangles is ready%s", sheet.vertexCount(),
           sheet.triangles().size(),
           waiting_ ? (", and waits for " + start_wait_.what() + "; ~resume starts without").c_str()
           : run_.paused ? ", paused"
                         : "");
  publishView(run_.recipe ? &run_.recipe->recipe() : nullptr);
}

void OrigamiNode::spin() {
  // As roscpp shuts down, Debian 11's is ok() until every service call has returned.
  while (ros::ok() && !ros::isShuttingDown()) {
    const double wait = std::clamp(untilNextStep(), 0.0, kIdlePeriod);
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(publishDue() ? 0 : wait));
    if (waiting_ && start_wait_.over(publishers_)) startWatched();
    requests_.forgetEnded();
    if (requests_.loaded()) {
      finishLoading();
      continue;  // and what was asked meanwhile is answered before large paper is published
    }
    if (requests_.settling()) continueSettling();
    else if (requests_.stepping()) continueStepping();
    else if (!run_.paused && untilNextStep() <= 0) advance();
    if (publishDue()) publish();
    if (watcher_) watcher_();
    keepCheckpoint();
  }
  keepCheckpoint(true);
  requests_.end("the node ends");
}

double OrigamiNode::untilNextStep() {
  if (requests_.settling()) return kIdlePeriod;  // its end wakes the node
  if (requests_.stepping()) return 0;
  if (run_.paused) return waiting_ ? kWaitPeriod : kIdlePeriod;
  return clock_->wait(run_.session.time(), run_.session.simulation().config().solver.time_step);
}

/// A recording begins with the paper as it lies there. rosbag listens a moment after it has
/// subscribed.
void OrigamiNode::startWatched() {
  changed_ = true;
  if (publishDue()) publish();
  if (config_.wait_for_recorder) ros::WallDuration(kRecorderStart).sleep();
  resume();
}

void OrigamiNode::configure(const NodeConfig& config) {
  config_.publish_rate = config.publish_rate;
  config_.markers = config.markers;
  config_.colouring = config.colouring;
  config_.real_time_factor = config.real_time_factor;
  publishers_.choose(config.markers, config.colouring);
  clock_->setFactor(config.real_time_factor, run_.session.time());
  changed_ = true;
}

void OrigamiNode::pause() {
  requests_.end("ended by ~pause");
  halt();
}

void OrigamiNode::halt() {
  run_.paused = true;
  waiting_ = false;
  changed_ = true;
}

void OrigamiNode::resume() {
  if (requests_.endStep("~resume lets time run")) changed_ = true;
  clock_->hold(run_.session.time());
  run_.paused = false;
  waiting_ = false;
}

std::future<double> OrigamiNode::takeSteps(std::uint32_t count) { return requests_.step(count); }

std::future<EditRecord> OrigamiNode::settle() { return requests_.settle(run_.session); }

void OrigamiNode::continueStepping() {
  switch (advance()) {
    case Advance::kSettles: return;
    case Advance::kFailed: requests_.endStep(step_.failure); return;
    case Advance::kStepped: break;
  }
  if (requests_.stepTaken(run_.session.time())) changed_ = true;
}

void OrigamiNode::continueSettling() {
  LongSettle* settling = requests_.settling();
  if (!settling->done()) return;
  if (settling->outdated()) {
    settling->startAgain(run_.session);
    return;
  }
  const std::unique_ptr<LongSettle> ended = requests_.takeSettle();
  clock_->hold(run_.session.time());  // it may have taken long
  changed_ = true;
  try {
    ended->answer.set_value(ended->finish(run_.session));
  } catch (const std::exception& error) {
    ended->answer.set_exception(std::current_exception());
    if (ended->ofRecipe()) stop(std::string("it cannot settle: ") + error.what());
  }
}

/// One step, and the part of the recipe that is due before it. The node pauses where it fails.
OrigamiNode::Advance OrigamiNode::advance() {
  if (!continueRecipe()) return Advance::kFailed;
  if (requests_.settling()) return Advance::kSettles;
  const double time_step = run_.session.simulation().config().solver.time_step;
  if (carrier_) carrier_(time_step, clock_->stamp(run_.session.time() + time_step));
  step_ = run_.session.step();
  if (!step_.converged) {
    stop(step_.failure);
    return Advance::kFailed;
  }
  clock_->announce(run_.session.time());
  return Advance::kStepped;
}

void OrigamiNode::keepCheckpoint(bool now) {
  // A recipe that settles has begun a step whose edit is still to be made.
  if (waiting_ || requests_.settlesForRecipe()) return;
  if (now) checkpoint_.write(run_);
  else checkpoint_.keep(run_);
}

/// Makes the edits of a step of the recipe. Settling, which takes long, is begun.
bool OrigamiNode::applyOfRecipe(const std::vector<Edit>& edits) {
  if (!std::holds_alternative<SettleEdit>(edits.front())) {
    run_.session.applyOfRecipe(edits);
    return true;
  }
  const RecipeRunner& runner = run_.recipe->runner();
  requests_.settleForRecipe(run_.session,
                            std::get<SettleStep>(runner.recipe().steps[runner.place().step]));
  return false;
}

bool OrigamiNode::continueRecipe() {
  if (!run_.recipe) return true;
  bool goes_on = true;
  std::optional<std::string> failure;
  run_.recipe->look(run_.session.view());
  try {
    const auto make = [this](const std::vector<Edit>& edits) { return applyOfRecipe(edits); };
    goes_on = run_.recipe->update(run_.session.simulation(), make, &run_.session.journal());
  } catch (const StepFailed& failed) {
    failure = takeStepBack(failed);
  } catch (const std::exception& error) {
    failure = error.what();
  }
  run_.session.look(run_.recipe->view());
  if (failure) {
    stop(*failure);
    return false;
  }
  if (!goes_on) {
    endRecipe();
    // Nobody wants a finished paper to lie there as fast as the machine can.
    if (config_.clock == ClockMode::kLead && config_.real_time_factor == 0) halt();
  }
  return true;
}

/// Returns why the recipe ends; nothing where its step is tried again.
std::optional<std::string> OrigamiNode::takeStepBack(const StepFailed& failed) {
  const std::optional<std::uint64_t> first = run_.recipe->firstEdit();
  if (!first || !run_.session.undoFrom(*first)) {
    return failed.what() + std::string("; the paper before it is not remembered");
  }
  if (run_.recipe->tryAgain(failed)) return std::nullopt;
  return failed.what() + std::string("; the paper is as it was before");
}

/// None is under way any more by the time the listener hears of it.
void OrigamiNode::endRecipe(const std::string& why) {
  if (!run_.recipe) return;
  RecipeRun ended = std::move(*run_.recipe);
  run_.recipe.reset();
  requests_.endRecipeSettle();
  ended.end(why);
}

void OrigamiNode::cancelRecipe(const std::string& why) {
  if (!run_.recipe) return;
  if (run_.session.simulation().folding()) apply(StopEdit{});
  endRecipe(why);
}

void OrigamiNode::startRecipe(Recipe recipe, const std::string& path,
                              RecipeRun::Listener listener) {
  if (recipe.states("sheet")) replacePaper(paperOf(recipe), path);
  const bool turns = (recipe.states("sheet") || recipe.states("view")) && publishView(&recipe) &&
                     start_wait_.waitForTurn(publishers_);
  run_.session.journal().addNames(recipe.names);
  run_.recipe.emplace(std::move(recipe), "", std::move(listener));
  if (waiting_) return;
  if (turns) {
    halt();
    waiting_ = true;
  } else {
    resume();
  }
}

void OrigamiNode::stop(const std::string& reason) {
  step_.converged = false;
  step_.failure = asMessageText(reason);
  ROS_ERROR("paused at %.3f s: %s", run_.session.time(), step_.failure.c_str());
  halt();
  endRecipe(step_.failure);
}

std::future<msg::Load::Response> OrigamiNode::load(const std::string& path, double scale) {
  return requests_.load(path, [config = config_, path, scale](std::vector<std::string>& notes) {
    return paperFromFile(config, path, scale, notes);
  });
}

void OrigamiNode::finishLoading() {
  const std::unique_ptr<LongLoad> ended = requests_.takeLoad();
  try {
    replacePaper(ended->finish(), ended->path());
    publishView(nullptr);
    const Sheet& sheet = run_.session.simulation().sheet();
    msg::Load::Response answer;
    answer.vertices = static_cast<std::uint32_t>(sheet.vertexCount());
    answer.triangles = static_cast<std::uint32_t>(sheet.triangles().size());
    for (const Crease& crease : sheet.creases()) answer.creases.push_back(crease.name);
    answer.revision = run_.session.revision();
    answer.edit = run_.session.edits();
    for (const std::string& note : ended->notes()) answer.message += "; " + note;
    ended->answer.set_value(std::move(answer));
  } catch (const std::exception&) {
    ended->answer.set_exception(std::current_exception());
  }
}

void OrigamiNode::replacePaper(NewPaper paper, const std::string& path) {
  endRecipe("another paper takes the place of this one");
  requests_.end("another paper takes the place of this one");
  run_.session.replace(std::move(paper), path);
}

void OrigamiNode::reset() {
  endRecipe("the paper is reset");
  requests_.end("the paper is reset");
  run_.session.reset();
}

std::uint64_t OrigamiNode::undo(std::uint32_t count) {
  const std::uint64_t edit = run_.session.undo(count);
  requests_.end("edits are undone");
  return edit;
}

std::uint64_t OrigamiNode::undoFrom(std::uint64_t edit) {
  const Session& session = run_.session;
  const std::uint32_t count = edit > session.edits() ? 0 : session.editsFrom(edit);
  if (count == 0) reject("since is ", edit, ", but that edit cannot be undone");
  return undo(count);
}

void OrigamiNode::onEdit(const EditRecord& record) {
  if (run_.recipe && countsForUndo(record.edit)) run_.recipe->remember(record.number);
  if (LongSettle* settling = requests_.settling()) settling->outdate();
  publishers_.publishEdit(editMessage(record), stamp());
  changed_ = true;
}

void OrigamiNode::onLoad(const std::string& path) {
  clock_->hold(run_.session.time());  // it may have taken long
  step_ = {};
  publishers_.lookAnew();
  publishPaper(msg::Edit::LOAD, path);
}

void OrigamiNode::onReset() {
  step_ = {};
  publishers_.lookAnew();
  publishPaper(msg::Edit::RESET);
}

void OrigamiNode::onUndo(std::uint64_t edit) {
  if (run_.recipe && !run_.recipe->goBack(edit)) {
    endRecipe("the edits before it are undone");
  }
  requests_.endRecipeSettle();
  step_ = {};
  publishers_.lookAnew();
  publishPaper(msg::Edit::UNDO, "", edit);
}

void OrigamiNode::publishPaper(const std::string& kind, const std::string& path,
                               std::uint64_t undone) {
  // A whole paper is a large message. Who listens later is sent it then.
  if (publishers_.editsHeard()) {
    msg::Edit edit = paperMessage(run_.session, kind, path);
    edit.undone = undone;
    publishers_.publishEdit(edit, stamp());
  }
  changed_ = true;
}

msg::Edit OrigamiNode::wholePaper() {
  msg::Edit edit = paperMessage(run_.session, msg::Edit::PAPER);
  edit.header.stamp = stamp();
  edit.header.frame_id = config_.world_frame;
  return edit;
}

ros::Time OrigamiNode::stamp() {
  if (standing()) clock_->hold(run_.session.time());
  return clock_->stamp(run_.session.time());
}

/// A paused paper is due after a change, and now and then for whoever came late.
bool OrigamiNode::publishDue() {
  if (!standing() || requests_.stepping()) return movingDue();
  if (stamp().isZero()) return false;
  return changed_ || (ros::SteadyTime::now() - last_publish_).toSec() >= kIdlePeriod;
}

/// A moving paper is due by its stamps, at the publishing rate and after a change, and never twice
/// with one stamp.
bool OrigamiNode::movingDue() {
  const ros::Time stamp = this->stamp();
  if (stamp == last_stamp_ || stamp.isZero()) return false;
  const double time_step = run_.session.simulation().config().solver.time_step;
  return changed_ || publishing_.due(stamp, config_.publish_rate, 0.5 * time_step);
}

void OrigamiNode::publish() {
  const ros::SteadyTime wall = ros::SteadyTime::now();
  const ros::Time stamp = this->stamp();
  real_time_factor_.sample(wall.toSec(), run_.session.time());
  if (standing()) clock_->announce(run_.session.time());
  publishers_.publish(run_.session, run_.paused, step_, real_time_factor_.value(), stamp);

  publishing_.done(stamp, config_.publish_rate);
  last_publish_ = wall;
  last_stamp_ = stamp;
  changed_ = false;
}

bool OrigamiNode::publishView(const Recipe* recipe) {
  const double size = run_.session.simulation().sheet().size();
  return publishers_.publishView(viewOf(recipe, size), stamp());
}

}  // namespace shell_origami
