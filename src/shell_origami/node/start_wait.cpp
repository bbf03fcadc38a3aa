#include <shell_origami/node/start_wait.h>

#include <shell_origami/base/error.h>

#include <ros/console.h>

namespace shell_origami {
namespace {

/// How long rviz takes from listening to showing what it hears [s].
constexpr double kFirstPicture = 1;
/// How long a recorder may take to start [s].
constexpr double kLongestWait = 20;
/// How long it may take to turn to another view [s].
constexpr double kTurn = 5;

}  // namespace

StartWait::StartWait(const NodeConfig& config)
    : patience_(config.wait_for_viewer),
      recorder_(config.wait_for_recorder),
      viewer_(patience_ > 0),
      begin_(ros::SteadyTime::now()) {}

std::string StartWait::what() const {
  if (!viewer_) return "a recorder";
  return recorder_ ? "a recorder and a viewer" : "a viewer";
}

bool StartWait::waitForTurn(const Publishers& publishers) {
  if (patience_ == 0 || publishers.viewedSince().isZero() || !publishers.aimed()) return false;
  patience_ = kTurn;
  recorder_ = false;
  viewer_ = true;
  begin_ = turned_ = ros::SteadyTime::now();
  return true;
}

bool StartWait::over(const Publishers& publishers) {
  if (viewer_ && viewerDraws(publishers.viewedSince())) viewer_ = false;
  if (recorder_ && publishers.recorded()) recorder_ = false;
  // One that did not start is not waited for in silence for ever.
  if (recorder_ && (ros::SteadyTime::now() - begin_).toSec() > kLongestWait) {
    reject(
        "parameter ~wait_for_recorder is true, but nobody has listened to all of ~sheet, ~state ",
        "and ~edits for ", kLongestWait, " s");
  }
  return !wanted();
}

bool StartWait::viewerDraws(const ros::SteadyTime& viewed_since) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (!viewed_since.isZero() && viewed_since >= turned_) {
    return (now - viewed_since).toSec() >= kFirstPicture;
  }
  if ((now - begin_).toSec() < patience_) return false;
  ROS_WARN("no viewer begins to show ~markers within %g s: starting without", patience_);
  return true;
}

}  // namespace shell_origami
