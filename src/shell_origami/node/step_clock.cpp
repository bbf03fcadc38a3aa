#include <shell_origami/node/step_clock.h>

#include <shell_origami/node/time_arithmetic.h>

#include <rosgraph_msgs/Clock.h>

#include <algorithm>

namespace shell_origami {
namespace {

/// How far the paper may fall behind before the lag is dropped [s].
constexpr double kMaxLag = 0.15;
/// How often a dropped lag is told [s].
constexpr double kLossWarnPeriod = 5;
/// How long to wait for news of /clock, which may jump at any moment [s].
constexpr double kClockPoll = 0.005;

/// Counts the time lost, and warns of it at most once in kLossWarnPeriod.
class Lag {
 public:
  void add(double lag) {
    dropped_ += lag;
    const ros::SteadyTime now = ros::SteadyTime::now();
    if (!last_.isZero() && (now - last_).toSec() < kLossWarnPeriod) return;
    ROS_WARN("the simulation cannot keep pace: dropped %.2f s", dropped_ - told_);
    last_ = now;
    told_ = dropped_;
  }
  double dropped() const { return dropped_; }

 private:
  double dropped_ = 0;  ///< [s]
  double told_ = 0;     ///< of it [s]
  ros::SteadyTime last_;
};

/// Keeps pace with ROS time. Stamps are a stretch of ROS time that moves along with simulation
/// time, shifted onto the present whenever that stood still or could not keep up.
class FollowClock : public StepClock {
 public:
  double wait(double t, double time_step) override {
    const ros::Time now = ros::Time::now();
    if (now < last_now_ || last_now_.isZero()) anchor(now, t);
    last_now_ = now;
    if (now.isZero()) return kClockPoll;
    const double lag = secondsBetween(stamp(t), now) - time_step;
    if (lag > kMaxLag) {
      lag_.add(lag);
      anchor(later(now, -time_step), t);
      return 0;
    }
    return ros::Time::isSimTime() ? std::min(kClockPoll, -lag) : -lag;
  }

  void hold(double t) override {
    last_now_ = ros::Time::now();
    anchor(last_now_, t);
  }

  ros::Time stamp(double t) const override {
    return anchor_stamp_.isZero() ? ros::Time() : later(anchor_stamp_, t - anchor_t_);
  }

  double dropped() const override { return lag_.dropped(); }

 private:
  void anchor(const ros::Time& stamp, double t) {
    anchor_stamp_ = stamp;
    anchor_t_ = t;
  }

  ros::Time anchor_stamp_;
  double anchor_t_ = 0;
  ros::Time last_now_;
  Lag lag_;
};

/// Makes ROS time: stamps are simulation time, at `factor` times the pace of the wall clock. Zero
/// would mean that there is no time yet, so the first stamp is a nanosecond.
class LeadClock : public StepClock {
 public:
  LeadClock(ros::NodeHandle& node, double factor)
      : factor_(factor), publisher_(node.advertise<rosgraph_msgs::Clock>("/clock", 10)) {}

  double wait(double t, double time_step) override {
    if (factor_ == 0) return 0;
    const double due = anchor_t_ + factor_ * (ros::SteadyTime::now() - anchor_wall_).toSec();
    const double lag = (due - t - time_step) / factor_;
    if (lag > kMaxLag) {
      lag_.add(lag);
      hold(t);
      return 0;
    }
    return -lag;
  }

  void hold(double t) override {
    anchor_wall_ = ros::SteadyTime::now();
    anchor_t_ = t;
  }

  ros::Time stamp(double t) const override { return std::max(ros::Time(t), ros::TIME_MIN); }

  void announce(double t) override {
    rosgraph_msgs::Clock message;
    message.clock = stamp(t);
    publisher_.publish(message);
  }

  void setFactor(double factor, double t) override {
    if (factor == factor_) return;
    factor_ = factor;
    hold(t);
  }

  double dropped() const override { return lag_.dropped(); }

 private:
  double factor_;
  ros::Publisher publisher_;
  ros::SteadyTime anchor_wall_ = ros::SteadyTime::now();
  double anchor_t_ = 0;
  Lag lag_;
};

}  // namespace

std::unique_ptr<StepClock> makeStepClock(ros::NodeHandle& node, const NodeConfig& config) {
  if (config.clock == ClockMode::kFollow) return std::make_unique<FollowClock>();
  return std::make_unique<LeadClock>(node, config.real_time_factor);
}

void RealTimeFactor::sample(double wall, double t) {
  samples_.push_back({wall, t});
  while (samples_.size() > 2 && samples_[1].wall <= wall - 1) samples_.pop_front();
}

double RealTimeFactor::value() const {
  if (samples_.size() < 2) return 0;
  const double elapsed = samples_.back().wall - samples_.front().wall;
  return elapsed > 0 ? (samples_.back().t - samples_.front().t) / elapsed : 0;
}

}  // namespace shell_origami
