#include <shell_origami/node/live_parameters.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace shell_origami {
namespace {

/// How often to look whether another paper has brought other values [s].
constexpr double kFollowPeriod = 0.2;

using Number = double OrigamiConfig::*;
constexpr std::array<Number, 7> kNumbers = {
    &OrigamiConfig::gravity_x,       &OrigamiConfig::gravity_y,     &OrigamiConfig::gravity_z,
    &OrigamiConfig::air_damping,     &OrigamiConfig::fold_duration, &OrigamiConfig::publish_rate,
    &OrigamiConfig::real_time_factor};

bool same(const OrigamiConfig& a, const OrigamiConfig& b) {
  return a.vertex_ids == b.vertex_ids &&
         std::all_of(kNumbers.begin(), kNumbers.end(), [&](Number n) { return a.*n == b.*n; });
}

LiveConfig physics(const OrigamiConfig& config) {
  return {{config.gravity_x, config.gravity_y, config.gravity_z},
          config.air_damping,
          config.fold_duration};
}

bool same(const LiveConfig& a, const SimulationConfig& b) {
  return a.gravity == b.gravity && a.air_damping == b.material.air_damping &&
         a.fold_duration == b.fold_duration;
}

/// What a former run left on the master is none of this one's.
ros::NodeHandle cleared(const ros::NodeHandle& node) {
  node.deleteParam("live");
  return ros::NodeHandle(node, "live");
}

}  // namespace

LiveParameters::LiveParameters(ros::NodeHandle& node, OrigamiNode& origami)
    : origami_(origami), server_(mutex_, cleared(node)), shown_(current()) {
  describe();
  server_.updateConfig(shown_);
  server_.setCallback([this](OrigamiConfig& config, std::uint32_t) { change(config); });
  timer_ = node.createSteadyTimer(ros::WallDuration(kFollowPeriod),
                                  [this](const ros::SteadyTimerEvent&) { follow(); });
}

OrigamiConfig LiveParameters::current() const {
  const SimulationConfig& paper = origami_.session().simulation().config();
  OrigamiConfig config = OrigamiConfig::__getDefault__();
  config.gravity_x = paper.gravity.x();
  config.gravity_y = paper.gravity.y();
  config.gravity_z = paper.gravity.z();
  config.air_damping = paper.material.air_damping;
  config.fold_duration = paper.fold_duration;
  config.publish_rate = origami_.config().publish_rate;
  config.real_time_factor = origami_.config().real_time_factor;
  config.vertex_ids = origami_.config().vertex_ids;
  return config;
}

/// Tells whoever draws sliders of bounds and of the values to go back to. The generated bounds are
/// infinite: a value beyond them would be moved there without a word.
void LiveParameters::describe() {
  OrigamiConfig low = OrigamiConfig::__getMin__(), high = OrigamiConfig::__getMax__();
  const auto bound = [&](Number number, const Bounds& bounds) {
    low.*number = bounds.low;
    high.*number = bounds.high;
  };
  bound(&OrigamiConfig::gravity_x, kGravityBounds);
  bound(&OrigamiConfig::gravity_y, kGravityBounds);
  bound(&OrigamiConfig::gravity_z, kGravityBounds);
  bound(&OrigamiConfig::air_damping, kAirDampingBounds);
  bound(&OrigamiConfig::publish_rate, kPublishRateBounds);
  low.fold_duration = 0;
  low.real_time_factor = 0;
  server_.setConfigMin(low);
  server_.setConfigMax(high);
  server_.setConfigDefault(shown_);
}

/// Only what differs from what was shown is wanted: another paper may have brought other values
/// meanwhile.
void LiveParameters::change(OrigamiConfig& config) {
  OrigamiConfig wanted = current();
  for (const Number number : kNumbers) {
    if (config.*number != shown_.*number) wanted.*number = config.*number;
  }
  if (config.vertex_ids != shown_.vertex_ids) wanted.vertex_ids = config.vertex_ids;
  try {
    apply(wanted);
  } catch (const std::invalid_argument& error) {
    ROS_WARN("live parameters refused: %s", error.what());
  }
  config = shown_ = current();
}

/// \throws std::invalid_argument and then has changed nothing.
void LiveParameters::apply(const OrigamiConfig& wanted) {
  NodeConfig node = origami_.config();
  node.publish_rate = wanted.publish_rate;
  node.real_time_factor = wanted.real_time_factor;
  node.vertex_ids = wanted.vertex_ids;
  checkParameters(node);
  const LiveConfig live = physics(wanted);
  if (!same(live, origami_.session().simulation().config())) origami_.apply(ConfigureEdit{live});
  origami_.configure(node);
}

void LiveParameters::follow() {
  const OrigamiConfig now = current();
  if (same(now, shown_)) return;
  shown_ = now;
  server_.updateConfig(shown_);
}

}  // namespace shell_origami
