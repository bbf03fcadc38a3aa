/// \file
/// The node: steps the paper, carries out the recipe, publishes.
#pragma once

#include "node/paper.h"
#include "node/parameters.h"
#include "node/publishers.h"
#include "node/recipe_run.h"
#include "node/step_clock.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace shell_origami {

/// Everything happens in one thread, requests between steps: each is answered within one step.
class OrigamiNode {
 public:
  /// \throws std::exception with one sentence when there is no such recipe or sheet.
  OrigamiNode(ros::NodeHandle& node, const NodeConfig& config);

  /// Returns when ROS shuts down.
  void spin();

  const NodeConfig& config() const { return config_; }
  Paper& paper() { return paper_; }
  /// Takes over what may change while the node runs: publish_rate, vertex_ids, real_time_factor.
  void configure(const NodeConfig& config);
  /// Of the paper as it is now. Zero: there is no ROS time yet.
  ros::Time stamp();

  bool paused() const { return paused_; }
  void pause();
  void resume();
  /// Takes so many steps, whether paused or not. Returns how many held.
  std::uint32_t takeSteps(std::uint32_t count);
  const StepReport& lastStep() const { return step_; }
  /// Simulated over elapsed time, over the last second.
  double realTimeFactor() const { return real_time_factor_.value(); }
  double dropped() const { return clock_->dropped(); }  ///< StepClock::dropped() [s]

  /// Puts the paper of a FOLD file or a recipe in the place of this one, and abandons the recipe
  /// that runs. \throws std::exception and then has changed nothing.
  void load(const std::string& path);
  /// The paper as it was loaded. Abandons the recipe that runs.
  void reset();

 private:
  void edited(const std::string& kind, const std::string& path = "");
  void publishEdits();
  bool advance();
  bool continueRecipe();
  void finishRecipe();
  void startRecorded();
  void stop(const std::string& reason);
  double untilNextStep();
  bool publishDue();
  bool movingDue();
  void publish();

  NodeConfig config_;
  std::optional<RecipeRun> recipe_;
  Paper paper_;
  std::unique_ptr<StepClock> clock_;
  Publishers publishers_;
  RealTimeFactor real_time_factor_;
  StepReport step_;  ///< the last one
  bool paused_;
  bool waiting_;         ///< paused only until someone records
  bool changed_ = true;  ///< by a request, since the last time the paper was published
  ros::Time next_publish_;
  ros::SteadyTime last_publish_;
  ros::Time last_stamp_;
};

}  // namespace shell_origami
