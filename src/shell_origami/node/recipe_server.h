/// \file
/// The topics of the action ~fold_recipe.
#pragma once

#include <shell_origami/node/messages.h>

#include <actionlib/server/action_server_base.h>

namespace shell_origami {

/// As actionlib::ActionServer, but statuses are sent by elapsed time, so that they do not stop
/// where ROS time does, and no stamp does harm: in there a cancel request of the year 2106 ends the
/// process, and one of next year cancels every goal until then.
class RecipeServer : public actionlib::ActionServerBase<msg::FoldRecipeAction> {
 public:
  using Callback = boost::function<void(GoalHandle)>;

  /// Hears nothing before start().
  RecipeServer(const ros::NodeHandle& node, const Callback& goal, const Callback& cancel);

 private:
  void initialize() override;
  void publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) override;
  void publishFeedback(const actionlib_msgs::GoalStatus& status, const Feedback& feedback) override;
  void publishStatus() override;
  void hearCancel(const actionlib_msgs::GoalIDConstPtr& wanted);

  ros::NodeHandle node_;
  ros::Publisher result_;
  ros::Publisher feedback_;
  ros::Publisher status_;
  ros::Subscriber goal_;
  ros::Subscriber cancel_;
  ros::WallTimer status_timer_;
};

}  // namespace shell_origami
