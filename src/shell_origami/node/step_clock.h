/// \file
/// When the next time step is due, and which stamp the paper carries.
#pragma once

#include <shell_origami/node/parameters.h>

#include <ros/ros.h>

#include <deque>
#include <memory>

namespace shell_origami {

/// Ties simulation time t [s] to ROS time. Simulation time grows by one time step at a time and
/// only while the paper is not paused.
class StepClock {
 public:
  virtual ~StepClock() = default;

  /// Wall time [s] until the step from t to t + time_step is due; zero or less: it is.
  virtual double wait(double t, double time_step) = 0;
  /// The paper rests at t, so that no step is due before the next call of wait().
  virtual void hold(double t) = 0;
  /// Stamp of the paper at t. Zero: there is no ROS time yet.
  virtual ros::Time stamp(double t) const = 0;
  /// Tells everyone that it is t now.
  virtual void announce(double) {}
  /// From t on runs at NodeConfig::real_time_factor, if it leads.
  virtual void setFactor(double /*factor*/, double /*t*/) {}
  /// Time [s] that was dropped so far because the steps could not keep pace.
  virtual double dropped() const = 0;
};

/// As NodeConfig::clock says.
std::unique_ptr<StepClock> makeStepClock(ros::NodeHandle& node, const NodeConfig& config);

/// Simulated over elapsed wall time, over the last second.
class RealTimeFactor {
 public:
  /// \param wall, t  elapsed and simulation time [s]
  void sample(double wall, double t);
  double value() const;

 private:
  struct Sample {
    double wall, t;
  };
  std::deque<Sample> samples_;
};

}  // namespace shell_origami
