#include <shell_origami/node/sense/depth_camera.h>

#include <shell_origami/node/sense/depth_messages.h>

#include <tf2_eigen/tf2_eigen.h>

#include <chrono>
#include <stdexcept>
#include <utility>

namespace shell_origami {
namespace {

/// For so long a shot waits for a transform of its time [s].
constexpr double kPatience = 1;
/// How often to look for one.
constexpr std::chrono::milliseconds kLookPeriod(5);
/// How many shots may wait: as many as are taken within kPatience at the highest rate.
constexpr std::size_t kMostShots = 100;
constexpr double kShotWarnPeriod = 5;  ///< [s]

}  // namespace

DepthCamera::DepthCamera(ros::NodeHandle& node, OrigamiNode& origami, const tf2_ros::Buffer& tf)
    : origami_(origami),
      config_(origami.config().depth),
      world_frame_(origami.config().world_frame),
      tf_(tf),
      image_(node.advertise<sensor_msgs::Image>("depth/image", 2)),
      label_(node.advertise<sensor_msgs::Image>("depth/label", 2)),
      info_(node.advertise<sensor_msgs::CameraInfo>("depth/camera_info", 2)),
      renderer_(config_.camera),
      thread_([this] { work(); }),
      timer_(node.createSteadyTimer(ros::WallDuration(1 / config_.rate),
                                    [](const ros::SteadyTimerEvent&) {})) {
  origami.setWatcher([this] { watch(); });
}

DepthCamera::~DepthCamera() {
  origami_.setWatcher(nullptr);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  news_.notify_all();
  thread_.join();
}

bool DepthCamera::heard() const {
  return image_.getNumSubscribers() + label_.getNumSubscribers() + info_.getNumSubscribers() > 0;
}

void DepthCamera::watch() {
  if (!heard()) return;
  const ros::Time stamp = origami_.stamp();
  const Session& session = origami_.session();
  const Simulation& simulation = session.simulation();
  const double slack = 0.5 * simulation.config().solver.time_step;
  if (stamp.isZero() || stamp == last_stamp_ || !pace_.due(stamp, config_.rate, slack)) return;
  last_stamp_ = stamp;
  pace_.done(stamp, config_.rate);
  if (!sheet_ || revision_ != session.revision()) {
    sheet_ = std::make_shared<const Sheet>(simulation.sheet());
    revision_ = session.revision();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (shots_.size() == kMostShots) {
    ROS_WARN_THROTTLE(kShotWarnPeriod, "depth images are left out: depth/rate is too high");
    shots_.pop_front();
  }
  shots_.push_back({stamp, ros::SteadyTime::now(), sheet_, simulation.bodies(),
                    simulation.positionsWithObstacles()});
  news_.notify_all();
}

void DepthCamera::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    news_.wait(lock, [this] { return ending_ || !shots_.empty(); });
    if (ending_) return;
    const Shot shot = std::move(shots_.front());
    shots_.pop_front();
    const std::optional<Eigen::Isometry3d> world_in_camera = waitForPose(shot, lock);
    if (!world_in_camera) continue;
    lock.unlock();
    send(shot, *world_in_camera);
    lock.lock();
  }
}

/// None where TF has not heard of it in time, and says so.
std::optional<Eigen::Isometry3d> DepthCamera::waitForPose(const Shot& shot,
                                                          std::unique_lock<std::mutex>& lock) {
  while (!ending_) {
    try {
      return Eigen::Isometry3d(
          tf2::transformToEigen(tf_.lookupTransform(config_.frame, world_frame_, shot.stamp))
              .matrix());
    } catch (const std::runtime_error& error) {  // tf2's, or of stamps that are 68 years apart
      if ((ros::SteadyTime::now() - shot.taken).toSec() >= kPatience) {
        ROS_WARN_THROTTLE(kShotWarnPeriod,
                          "no depth image: TF does not know where frame %s was: %s",
                          config_.frame.c_str(), error.what());
        return std::nullopt;
      }
    }
    news_.wait_for(lock, kLookPeriod);
  }
  return std::nullopt;
}

void DepthCamera::send(const Shot& shot, const Eigen::Isometry3d& world_in_camera) {
  const PinholeCamera& camera = config_.camera;
  std_msgs::Header header;
  header.stamp = shot.stamp;
  header.frame_id = config_.frame;
  info_.publish(cameraInfoMessage(camera, header));
  const bool labeled = label_.getNumSubscribers() > 0;
  if (!labeled && image_.getNumSubscribers() == 0) return;
  const Positions points =
      (world_in_camera.linear() * shot.positions).colwise() + world_in_camera.translation();
  renderer_.render(*shot.sheet, shot.bodies, points);
  writeImage(camera, renderer_.depths(), header, depths_);
  image_.publish(depths_);
  if (!labeled) return;
  writeImage(camera, renderer_.labels(*shot.sheet, points), header, labels_);
  label_.publish(labels_);
}

}  // namespace shell_origami
