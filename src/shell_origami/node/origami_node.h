/// \file
/// The node: steps the paper, carries out the recipe, publishes.
#pragma once

#include <shell_origami/node/checkpoint.h>
#include <shell_origami/node/long_requests.h>
#include <shell_origami/node/pace.h>
#include <shell_origami/node/parameters.h>
#include <shell_origami/node/publishers.h>
#include <shell_origami/node/recipe_run.h>
#include <shell_origami/node/session.h>
#include <shell_origami/node/start_wait.h>
#include <shell_origami/node/step_clock.h>

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>

namespace shell_origami {

/// The paper and all requests are handled in one thread, between time steps. Requests that take
/// longer are done a step at a time, or in the background, so that others are answered within one
/// step (LongRequests).
class OrigamiNode : private SessionListener {
 public:
  /// \throws std::exception with one sentence when there is no such recipe or sheet.
  OrigamiNode(ros::NodeHandle& node, const NodeConfig& config);

  /// Returns when ROS shuts down.
  void spin();

  const NodeConfig& config() const { return config_; }
  const Session& session() const { return run_.session; }
  /// Session::apply(), published on ~edits.
  EditRecord apply(const Edit& edit) { return run_.session.apply(edit); }
  FoldThroughRecord foldThrough(const FoldThrough& fold, const Viewpoint& view) {
    return run_.session.foldThrough(fold, view);
  }
  /// Looks at the paper's other side from now on.
  void turnOver() { run_.session.turnOver(); }
  /// Takes over what may change while the node runs: publish_rate, markers, real_time_factor.
  void configure(const NodeConfig& config);
  /// Of the paper as it is now. Zero: there is no ROS time yet.
  ros::Time stamp();

  bool paused() const { return run_.paused; }
  /// Ends long requests as well.
  void pause();
  void resume();
  /// Takes so many steps. Their end, or why they were stopped, comes by the future.
  /// \throws std::invalid_argument when another long request is under way
  std::future<double> takeSteps(std::uint32_t count);
  /// Moves the paper to equilibrium. Time stands still until it is there; an edit meanwhile makes
  /// it start over. \throws std::invalid_argument when another long request is under way
  std::future<EditRecord> settle();
  const StepReport& lastStep() const { return step_; }
  /// Simulated over elapsed time, over the last second.
  double realTimeFactor() const { return real_time_factor_.value(); }
  double dropped() const { return clock_->dropped(); }  ///< StepClock::dropped() [s]

  /// Carries held vertices (Simulation::carry) before a step of so many seconds that ends at this
  /// ROS time.
  using Carrier = std::function<void(double time_step, const ros::Time& end)>;
  void setCarrier(Carrier carrier) { carrier_ = std::move(carrier); }

  /// Called by spin() between steps, again and again.
  void setWatcher(std::function<void()> watcher) { watcher_ = std::move(watcher); }

  /// Reads the paper of a crease pattern or a recipe, then puts it in the place of this one, and
  /// abandons the recipe that runs.
  /// \param scale  metres per unit of a crease pattern; 0: the unit that the file states
  /// \throws std::invalid_argument when another is being read
  std::future<msg::Load::Response> load(const std::string& path, double scale);
  /// The paper as it was loaded. Abandons the recipe that runs.
  void reset();
  /// Session::undo(). The recipe that runs goes back with the paper; where it had not begun then,
  /// it is abandoned.
  std::uint64_t undo(std::uint32_t count);
  /// The same of the edit with a number and all after it. \throws std::invalid_argument when the
  /// paper before it is not kept
  std::uint64_t undoFrom(std::uint64_t edit);

  /// The recipe under way; null where there is none.
  RecipeRun* recipe() { return run_.recipe ? &*run_.recipe : nullptr; }
  /// Lets time run and folds by a recipe, while none is under way: its own sheet, or the paper that
  /// lies there where it states none.
  /// \param path  of the recipe; empty: it was given as text
  /// \throws std::exception and then has changed nothing.
  void startRecipe(Recipe recipe, const std::string& path, RecipeRun::Listener listener);
  /// Ends the recipe under way, if any. The paper stays as it is: folds under way stop where they
  /// are.
  void cancelRecipe(const std::string& why);

 private:
  void replacePaper(NewPaper paper, const std::string& path);
  void onEdit(const EditRecord& record) override;
  void onLoad(const std::string& path) override;
  void onReset() override;
  void onUndo(std::uint64_t edit) override;
  void publishPaper(const std::string& kind, const std::string& path = "",
                    std::uint64_t undone = 0);
  msg::Edit wholePaper();
  void keepCheckpoint(bool now = false);
  bool applyOfRecipe(const std::vector<Edit>& edits);
  enum class Advance { kStepped, kSettles, kFailed };
  Advance advance();
  void halt();
  /// Whether time stands still.
  bool standing() const { return run_.paused || requests_.settling(); }
  void continueStepping();
  void continueSettling();
  void finishLoading();
  bool continueRecipe();
  std::optional<std::string> takeStepBack(const StepFailed& failed);
  void endRecipe(const std::string& why = "");
  void startWatched();
  void stop(const std::string& reason);
  double untilNextStep();
  bool publishDue();
  bool movingDue();
  void publish();
  bool publishView(const Recipe* recipe);

  NodeConfig config_;
  Checkpoint checkpoint_;
  Run run_;
  std::unique_ptr<StepClock> clock_;
  Publishers publishers_;
  Carrier carrier_;
  std::function<void()> watcher_;
  RealTimeFactor real_time_factor_;
  LongRequests requests_;
  StepReport step_;  ///< the last one
  StartWait start_wait_;
  bool waiting_;         ///< paused only until start_wait_ is over
  bool changed_ = true;  ///< by a request, since the last time the paper was published
  Pace publishing_;
  ros::SteadyTime last_publish_;
  ros::Time last_stamp_;
};

}  // namespace shell_origami
