#include <shell_origami/node/held_frames.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/frames.h>
#include <shell_origami/node/tf_utilities.h>
#include <shell_origami/node/time_arithmetic.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

/// News of a frame that are older are none [s].
constexpr double kStale = 1.0;
/// Within this time what was late once is forgotten, to a half [s].
constexpr double kHalfLife = 0.5;
/// A follower that lags more than it has to catches up by this part of a step, and where it lags
/// farther than this [s], at once.
constexpr double kCatchUp = 0.2, kFarBehind = 0.5;
/// Held paper is carried at this speed at most [m/s].
constexpr double kFastest = 2.0;
constexpr double kFrameWarnPeriod = 5;  ///< [s]

Pose poseOf(const geometry_msgs::TransformStamped& transform) {
  const auto& p = transform.transform.translation;
  const auto& q = transform.transform.rotation;
  return {{p.x, p.y, p.z}, Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized()};
}

/// How far anything that the frame carries is from where a pose puts it [m].
double distanceTo(const Pose& pose, const CarriedFrame& carried) {
  double farthest = 0;
  for (const Vector3& place : carried.places) {
    farthest = std::max(farthest, (pose.toWorld(place) - carried.pose.toWorld(place)).norm());
  }
  return farthest;
}

}  // namespace

HeldFrames::HeldFrames(OrigamiNode& origami, const tf2_ros::Buffer& tf)
    : origami_(origami), tf_(tf) {
  origami.setCarrier([this](double time_step, const ros::Time& end) { carry(time_step, end); });
}

HeldFrames::~HeldFrames() { origami_.setCarrier(nullptr); }

geometry_msgs::TransformStamped HeldFrames::lookUp(const std::string& frame,
                                                   const ros::Time& time) const {
  return tf_.lookupTransform(origami_.config().world_frame, frame, time);
}

void HeldFrames::requireForeign(const std::string& frame) const {
  if (isPaperFrame(frame, origami_.config().frame_prefix)) {
    reject("frame_id is \"", frame, "\", which is the paper's own and cannot hold it");
  }
}

template <class MakeEdit>
EditRecord HeldFrames::begin(const std::string& frame, const MakeEdit& edit) {
  requireForeign(frame);
  std_msgs::Header latest;
  latest.frame_id = frame;
  const geometry_msgs::TransformStamped transform =
      transformToWorld("frame_id is", latest, origami_.config().world_frame, tf_);
  const bool follows = origami_.session().simulation().carriedFrames().count(frame) > 0;
  EditRecord record = origami_.apply(edit(poseOf(transform)));
  if (!follows) followers_[frame] = {transform.header.stamp, 0};
  return record;
}

EditRecord HeldFrames::pin(const PinWhere& where, const std::string& frame) {
  return begin(frame, [&](const Pose& pose) { return PinEdit{where, frame, pose}; });
}

EditRecord HeldFrames::grasp(const GraspEdit& grasp, const std::string& frame) {
  return begin(frame, [&](const Pose& pose) {
    GraspEdit carried = grasp;
    carried.frame = frame;
    carried.pose = pose;
    return carried;
  });
}

EditRecord HeldFrames::add(const AddObstacleEdit& obstacle, const std::string& frame) {
  return begin(frame, [&](const Pose& pose) {
    AddObstacleEdit carried = obstacle;
    carried.frame = frame;
    carried.frame_pose = pose;
    return carried;
  });
}

void HeldFrames::carry(double time_step, const ros::Time& end) {
  const std::map<std::string, CarriedFrame> frames =
      origami_.session().simulation().carriedFrames();
  for (auto follower = followers_.begin(); follower != followers_.end();) {
    follower = frames.count(follower->first) ? std::next(follower) : followers_.erase(follower);
  }
  for (const auto& [frame, carried] : frames) carry(frame, carried, time_step, end);
}

void HeldFrames::moveTo(const Pose& pose, const std::string& frame, const CarriedFrame& carried) {
  if (!(carried.next == pose)) origami_.apply(CarryEdit{frame, pose});
}

void HeldFrames::carry(const std::string& frame, const CarriedFrame& carried, double time_step,
                       const ros::Time& end) {
  try {
    const ros::Time latest = lookUp(frame, ros::Time(0)).header.stamp;
    Follower& follower = followers_[frame];
    const double late = secondsBetween(latest, end);
    // A frame that never moves has no stamp.
    if (!latest.isZero() && late > kStale) {
      ROS_WARN_THROTTLE(kFrameWarnPeriod, "frame %s was last heard of %.1f s ago: the paper waits",
                        frame.c_str(), late);
    }
    follower.behind = std::max(late, follower.behind * std::exp2(-time_step / kHalfLife));
    follower.played = later(follower.played, time_step);
    const double lag = secondsBetween(follower.played, end) - follower.behind;
    if (lag > kFarBehind) follower.played = later(follower.played, lag);
    else if (lag > 0) follower.played = later(follower.played, std::min(lag, kCatchUp * time_step));
    follower.played = std::min(follower.played, latest);

    Pose pose = poseOf(lookUp(frame, follower.played));
    const double distance = distanceTo(pose, carried);
    if (distance > kFastest * time_step) {
      ROS_WARN_THROTTLE(kFrameWarnPeriod, "frame %s jumped by %.3f m: the paper follows at %g m/s",
                        frame.c_str(), distance, kFastest);
      pose = poseBetween(carried.pose, pose, kFastest * time_step / distance);
    }
    moveTo(pose, frame, carried);
  } catch (const std::exception& error) {
    moveTo(carried.pose, frame, carried);
    ROS_WARN_THROTTLE(kFrameWarnPeriod, "frame %s is lost, and the paper waits: %s", frame.c_str(),
                      error.what());
  }
}

}  // namespace shell_origami
