/// \file
/// The node: steps the paper, carries out the recipe, publishes.
#pragma once

#include <shell_origami/node/checkpoint.h>
#include <shell_origami/node/parameters.h>
#include <shell_origami/node/publishers.h>
#include <shell_origami/node/recipe_run.h>
#include <shell_origami/node/session.h>
#include <shell_origami/node/step_clock.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace shell_origami {

/// Everything happens in one thread, requests between steps: each is answered within one step.
class OrigamiNode {
 public:
  /// \throws std::exception with one sentence when there is no such recipe or sheet.
  OrigamiNode(ros::NodeHandle& node, const NodeConfig& config);

  /// Returns when ROS shuts down.
  void spin();

  const NodeConfig& config() const { return config_; }
  Session& session() { return run_.session; }
  /// Takes over what may change while the node runs: publish_rate, vertex_ids, real_time_factor.
  void configure(const NodeConfig& config);
  /// Of the paper as it is now. Zero: there is no ROS time yet.
  ros::Time stamp();

  bool paused() const { return run_.paused; }
  void pause();
  void resume();
  /// Takes so many steps, whether paused or not. Returns how many held.
  std::uint32_t takeSteps(std::uint32_t count);
  const StepReport& lastStep() const { return step_; }
  /// Simulated over elapsed time, over the last second.
  double realTimeFactor() const { return real_time_factor_.value(); }
  double dropped() const { return clock_->dropped(); }  ///< StepClock::dropped() [s]

  /// Carries held vertices (Simulation::carry) before a step of so many seconds that ends at this
  /// ROS time.
  using Carrier = std::function<void(double time_step, const ros::Time& end)>;
  void setCarrier(Carrier carrier) { carrier_ = std::move(carrier); }

  /// Puts the paper of a FOLD file or a recipe in the place of this one, and abandons the recipe
  /// that runs. \throws std::exception and then has changed nothing.
  void load(const std::string& path);
  /// The paper as it was loaded. Abandons the recipe that runs.
  void reset();

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
  void replacePaper(Simulation simulation, const std::string& path);
  void replaced(const std::string& kind, const std::string& path = "");
  msg::Edit wholePaper();
  void publishEdits();
  void keepCheckpoint();
  bool advance();
  bool continueRecipe();
  void endRecipe(const std::string& why = "");
  void startRecorded();
  void stop(const std::string& reason);
  double untilNextStep();
  bool publishDue();
  bool movingDue();
  void publish();

  NodeConfig config_;
  Checkpoint checkpoint_;
  Run run_;
  std::unique_ptr<StepClock> clock_;
  Publishers publishers_;
  Carrier carrier_;
  RealTimeFactor real_time_factor_;
  StepReport step_;      ///< the last one
  bool waiting_;         ///< paused only until someone records
  bool changed_ = true;  ///< by a request, since the last time the paper was published
  ros::Time next_publish_;
  ros::SteadyTime last_publish_;
  ros::Time last_stamp_;
};

}  // namespace shell_origami
