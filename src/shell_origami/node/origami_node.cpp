#include <shell_origami/node/origami_node.h>

#include <shell_origami/node/message_text.h>
#include <shell_origami/node/record/edit_messages.h>

#include <ros/callback_queue.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace shell_origami {
namespace {

/// How often a paused paper is published, for whoever came late and to keep its frames alive [s].
constexpr double kIdlePeriod = 0.5;
/// How often to look whether someone records by now [s].
constexpr double kWaitPeriod = 0.02;
/// How long a recorder takes from subscribing to listening [s].
constexpr double kRecorderStart = 0.3;

/// The sheet and the recipe of the parameters.
Run newRun(const NodeConfig& config) {
  if (config.recipe.empty()) {
    return {Session(makeSimulation(config.sheet, config.simulation)), std::nullopt, config.paused};
  }
  Recipe recipe = loadRecipe(findRecipe(config.recipe), config.simulation, config.sheet);
  Simulation simulation = makeSimulation(recipe.sheet, recipe.config);
  return {Session(std::move(simulation)), RecipeRun(std::move(recipe), config.output),
          config.paused};
}

Run beginRun(const NodeConfig& config, const Checkpoint& checkpoint) {
  std::optional<Run> kept = checkpoint.read();
  if (!kept) return newRun(config);
  ROS_INFO("going on from %s, at %.3f s", config.checkpoint.c_str(), kept->session.time());
  return std::move(*kept);
}

Simulation paperFromFile(const NodeConfig& config, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".yaml" || extension == ".yml") {
    const Recipe recipe = loadRecipe(path, config.simulation, config.sheet);
    return makeSimulation(recipe.sheet, recipe.config);
  }
  SheetSource source = config.sheet;
  source.pattern = path;
  return makeSimulation(source, config.simulation);
}

}  // namespace

OrigamiNode::OrigamiNode(ros::NodeHandle& node, const NodeConfig& config)
    : config_(config),
      checkpoint_(config.checkpoint, config.checkpoint_period),
      run_(beginRun(config, checkpoint_)),
      clock_(makeStepClock(node, config)),
      publishers_(node, config, [this] { return wholePaper(); }),
      waiting_(config.wait_for_recorder && !run_.paused) {
  run_.paused = run_.paused || waiting_;
  const Sheet& sheet = run_.session.simulation().sheet();
  ROS_INFO("a sheet of %d vertices and %zu triangles is ready%s", sheet.vertexCount(),
           sheet.triangles().size(),
           waiting_      ? ", and waits for a recorder; ~resume starts without"
           : run_.paused ? ", paused"
                         : "");
}

void OrigamiNode::spin() {
  while (ros::ok()) {
    const double wait = std::clamp(untilNextStep(), 0.0, kIdlePeriod);
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(publishDue() ? 0 : wait));
    publishEdits();
    if (waiting_ && publishers_.recorded()) startRecorded();
    if (!run_.paused && untilNextStep() <= 0) advance();
    if (publishDue()) publish();
    keepCheckpoint();
  }
  run_.session.takeEdits();  // counts them
  if (!waiting_) checkpoint_.write(run_);
}

double OrigamiNode::untilNextStep() {
  if (run_.paused) return waiting_ ? kWaitPeriod : kIdlePeriod;
  return clock_->wait(run_.session.time(), run_.session.simulation().config().solver.time_step);
}

/// The recording begins with the paper as it lies there. rosbag listens a moment after it has
/// subscribed.
void OrigamiNode::startRecorded() {
  changed_ = true;
  if (publishDue()) publish();
  ros::WallDuration(kRecorderStart).sleep();
  resume();
}

void OrigamiNode::configure(const NodeConfig& config) {
  config_.publish_rate = config.publish_rate;
  config_.vertex_ids = config.vertex_ids;
  config_.real_time_factor = config.real_time_factor;
  publishers_.showVertexIds(config.vertex_ids);
  clock_->setFactor(config.real_time_factor, run_.session.time());
  changed_ = true;
}

void OrigamiNode::pause() {
  run_.paused = true;
  waiting_ = false;
  changed_ = true;
}

void OrigamiNode::resume() {
  clock_->hold(run_.session.time());
  run_.paused = false;
  waiting_ = false;
}

std::uint32_t OrigamiNode::takeSteps(std::uint32_t count) {
  std::uint32_t taken = 0;
  // As roscpp shuts down it waits for the request that asks for these steps; Debian 11's is ok()
  // until then.
  while (taken < count && !ros::isShuttingDown() && advance()) {
    ++taken;
    if (movingDue()) publish();
    keepCheckpoint();
  }
  changed_ = true;
  return taken;
}

/// One step, and the part of the recipe that is due before it. Returns whether it held; the node
/// pauses where it did not.
bool OrigamiNode::advance() {
  if (!continueRecipe()) return false;
  const double time_step = run_.session.simulation().config().solver.time_step;
  if (carrier_) carrier_(time_step, clock_->stamp(run_.session.time() + time_step));
  step_ = run_.session.simulation().step();
  if (!step_.converged) {
    stop(step_.failure);
    return false;
  }
  clock_->announce(run_.session.time());
  return true;
}

void OrigamiNode::keepCheckpoint() {
  publishEdits();
  if (!waiting_) checkpoint_.keep(run_);
}

bool OrigamiNode::continueRecipe() {
  if (!run_.recipe) return true;
  bool held = true;
  try {
    if (!run_.recipe->update(run_.session.simulation())) {
      endRecipe();
      // Nobody wants a finished paper to lie there as fast as the machine can.
      if (config_.clock == ClockMode::kLead && config_.real_time_factor == 0) pause();
    }
  } catch (const std::exception& error) {
    stop(error.what());
    held = false;
  }
  publishEdits();
  return held;
}

/// None is under way any more by the time the listener hears of it.
void OrigamiNode::endRecipe(const std::string& why) {
  if (!run_.recipe) return;
  RecipeRun ended = std::move(*run_.recipe);
  run_.recipe.reset();
  ended.end(why);
}

void OrigamiNode::cancelRecipe(const std::string& why) {
  if (!run_.recipe) return;
  run_.session.simulation().stopFolds();
  endRecipe(why);
}

void OrigamiNode::startRecipe(Recipe recipe, const std::string& path,
                              RecipeRun::Listener listener) {
  if (recipe.states("sheet")) replacePaper(makeSimulation(recipe.sheet, recipe.config), path);
  run_.recipe.emplace(std::move(recipe), "", std::move(listener));
  if (!waiting_) resume();
}

void OrigamiNode::stop(const std::string& reason) {
  step_.converged = false;
  step_.failure = asMessageText(reason);
  ROS_ERROR("paused at %.3f s: %s", run_.session.time(), step_.failure.c_str());
  pause();
  endRecipe(step_.failure);
}

void OrigamiNode::load(const std::string& path) {
  replacePaper(paperFromFile(config_, path), path);
}

void OrigamiNode::replacePaper(Simulation simulation, const std::string& path) {
  publishEdits();
  endRecipe("another paper takes the place of this one");
  run_.session.replace(std::move(simulation));
  clock_->hold(run_.session.time());  // it may have taken long
  step_ = {};
  replaced(msg::Edit::LOAD, path);
}

void OrigamiNode::reset() {
  publishEdits();
  endRecipe("the paper is reset");
  run_.session.reset();
  step_ = {};
  replaced(msg::Edit::RESET);
}

/// Tells everyone of another paper.
void OrigamiNode::replaced(const std::string& kind, const std::string& path) {
  publishers_.publishEdit(paperMessage(run_.session, kind, path), stamp());
  changed_ = true;
}

msg::Edit OrigamiNode::wholePaper() {
  publishEdits();
  msg::Edit edit = paperMessage(run_.session, msg::Edit::PAPER);
  edit.header.stamp = stamp();
  edit.header.frame_id = config_.world_frame;
  return edit;
}

/// Tells everyone of the edits that the paper took, be they of a request or of the recipe.
void OrigamiNode::publishEdits() {
  for (const EditRecord& edit : run_.session.takeEdits()) {
    publishers_.publishEdit(editMessage(edit), stamp());
    changed_ = true;
  }
}

ros::Time OrigamiNode::stamp() {
  if (run_.paused) clock_->hold(run_.session.time());
  return clock_->stamp(run_.session.time());
}

/// A paused paper is due after a change, and now and then for whoever came late.
bool OrigamiNode::publishDue() {
  if (!run_.paused) return movingDue();
  if (stamp().isZero()) return false;
  return changed_ || (ros::SteadyTime::now() - last_publish_).toSec() >= kIdlePeriod;
}

/// A moving paper is due by its stamps, at the publishing rate and after a change, and never twice
/// with one stamp.
bool OrigamiNode::movingDue() {
  const ros::Time stamp = this->stamp();
  if (stamp == last_stamp_ || stamp.isZero()) return false;
  const double time_step = run_.session.simulation().config().solver.time_step;
  const double early = (next_publish_ - stamp).toSec();
  return changed_ || early < 0.5 * time_step || early > 2 / config_.publish_rate;
}

void OrigamiNode::publish() {
  publishEdits();
  const ros::SteadyTime wall = ros::SteadyTime::now();
  const ros::Time stamp = this->stamp();
  real_time_factor_.sample(wall.toSec(), run_.session.time());
  if (run_.paused) clock_->announce(run_.session.time());
  publishers_.publish(run_.session, step_, real_time_factor_.value(), stamp);

  const ros::Duration period(1 / config_.publish_rate);
  next_publish_ += period;
  if (std::abs((next_publish_ - stamp - period).toSec()) > period.toSec()) {
    next_publish_ = stamp + period;
  }
  last_publish_ = wall;
  last_stamp_ = stamp;
  changed_ = false;
}

}  // namespace shell_origami
