#include <shell_origami/node/recipe_server.h>

#include <actionlib_msgs/GoalStatusArray.h>
#include <boost/make_shared.hpp>

#include <algorithm>
#include <iterator>

namespace shell_origami {
namespace {

constexpr std::uint32_t kActionQueue = 50;
constexpr double kStatusPeriod = 0.2;  ///< [s] elapsed
/// How long the status of a goal that has ended is told [s] of ROS time.
constexpr double kStatusTimeout = 5;

}  // namespace

RecipeServer::RecipeServer(const ros::NodeHandle& node, const Callback& goal,
                           const Callback& cancel)
    : ActionServerBase(goal, cancel, false), node_(node, "fold_recipe") {}

void RecipeServer::initialize() {
  result_ = node_.advertise<ActionResult>("result", kActionQueue);
  feedback_ = node_.advertise<ActionFeedback>("feedback", kActionQueue);
  status_ = node_.advertise<actionlib_msgs::GoalStatusArray>("status", kActionQueue, true);
  goal_ = node_.subscribe<ActionGoal>(
      "goal", kActionQueue, [this](const ActionGoalConstPtr& goal) { goalCallback(goal); });
  cancel_ = node_.subscribe("cancel", kActionQueue, &RecipeServer::hearCancel, this);
  status_timer_ = node_.createWallTimer(ros::WallDuration(kStatusPeriod),
                                        [this](const ros::WallTimerEvent&) { publishStatus(); });
}

/// A stamp asks for every goal up to it, which cannot be those to come.
void RecipeServer::hearCancel(const actionlib_msgs::GoalIDConstPtr& wanted) {
  const auto id = boost::make_shared<actionlib_msgs::GoalID>(*wanted);
  id->stamp = std::min(id->stamp, ros::Time::now());
  cancelCallback(id);
}

void RecipeServer::publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) {
  ActionResult message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.result = result;
  result_.publish(message);
  publishStatus();
}

void RecipeServer::publishFeedback(const actionlib_msgs::GoalStatus& status,
                                   const Feedback& feedback) {
  ActionFeedback message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.feedback = feedback;
  feedback_.publish(message);
}

void RecipeServer::publishStatus() {
  actionlib_msgs::GoalStatusArray message;
  const ros::Time now = ros::Time::now();
  message.header.stamp = now;
  for (auto it = status_list_.begin(); it != status_list_.end();) {
    message.status_list.push_back(it->status_);
    const bool ended = it->handle_tracker_.expired();
    ros::Time& end = it->handle_destruction_time_;
    if (ended && (end.isZero() || end > now)) end = now;  // a client's stamp
    const bool told = ended && now.toSec() - end.toSec() > kStatusTimeout;
    it = told ? status_list_.erase(it) : std::next(it);
  }
  status_.publish(message);
}

}  // namespace shell_origami
