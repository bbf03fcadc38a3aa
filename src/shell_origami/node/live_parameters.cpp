#include <shell_origami/node/live_parameters.h>

#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace shell_origami {
namespace {

/// How often to look whether another paper has brought other values [s].
constexpr double kFollowPeriod = 0.2;

/// Where a parameter's value, or one of its components, lies; by its name under ~live.
struct LiveField {
  std::string name;
  std::variant<double*, bool*> value;
  Bounds bounds;
};

/// Those that the table of parameters calls live.
std::vector<LiveField> liveFields(NodeConfig& config) {
  std::vector<LiveField> fields;
  for (const auto& parameter : nodeParameters()) {
    if (!parameter.live) continue;
    const std::string name = parameter.name.substr(parameter.name.rfind('/') + 1);
    const Place place = parameter.place(config);
    if (const auto* list = std::get_if<Vector3*>(&place)) {
      for (int i = 0; i < 3; ++i) {
        fields.push_back({name + "_" + "xyz"[i], &(**list)[i], parameter.bounds});
      }
    } else if (const auto* truth = std::get_if<bool*>(&place)) {
      fields.push_back({name, *truth, parameter.bounds});
    } else {
      fields.push_back({name, std::get<double*>(place), parameter.bounds});
    }
  }
  return fields;
}

using Values = std::map<std::string, double>;  ///< true: 1

Values valuesOf(const OrigamiConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  Values values;
  for (const auto& number : message.doubles) values[number.name] = number.value;
  for (const auto& truth : message.bools) values[truth.name] = truth.value;
  return values;
}

/// \pre there is a value of every name in cfg/Origami.cfg
OrigamiConfig configOf(const Values& values) {
  OrigamiConfig config = OrigamiConfig::__getDefault__();
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  for (auto& number : message.doubles) number.value = values.at(number.name);
  for (auto& truth : message.bools) truth.value = values.at(truth.name) != 0;
  config.__fromMessage__(message);
  return config;
}

/// Without the values that a former run left on the master.
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

/// The parameters of the node and of the paper that lies there.
NodeConfig LiveParameters::parameters() const {
  NodeConfig config = origami_.config();
  config.simulation = origami_.session().simulation().config();
  return config;
}

OrigamiConfig LiveParameters::current() const {
  NodeConfig config = parameters();
  Values values;
  for (const auto& [name, value, bounds] : liveFields(config)) {
    std::visit([&, name = name](auto* place) { values[name] = *place; }, value);
  }
  return configOf(values);
}

/// Tells whoever draws sliders of bounds and of the values to go back to. The generated bounds are
/// infinite: a value beyond them would be moved there without a word.
void LiveParameters::describe() {
  NodeConfig config = parameters();
  Values low, high;
  for (const auto& [name, value, bounds] : liveFields(config)) {
    const bool number = std::holds_alternative<double*>(value);
    low[name] = number ? bounds.low : 0;
    high[name] = number ? bounds.high : 1;
  }
  server_.setConfigMin(configOf(low));
  server_.setConfigMax(configOf(high));
  server_.setConfigDefault(shown_);
}

/// Only what differs from what was shown is wanted: another paper may have brought other values
/// meanwhile.
void LiveParameters::change(OrigamiConfig& config) {
  const Values asked = valuesOf(config), shown = valuesOf(shown_);
  NodeConfig wanted = parameters();
  for (const auto& [name, value, bounds] : liveFields(wanted)) {
    if (asked.at(name) == shown.at(name)) continue;
    if (auto* const* number = std::get_if<double*>(&value)) **number = asked.at(name);
    else *std::get<bool*>(value) = asked.at(name) != 0;
  }
  try {
    apply(wanted);
  } catch (const std::invalid_argument& error) {
    ROS_WARN("live parameters refused: %s", error.what());
  }
  config = shown_ = current();
}

/// \throws std::invalid_argument and then has changed nothing.
void LiveParameters::apply(const NodeConfig& wanted) {
  checkParameters(wanted);
  const LiveConfig live = liveConfigOf(wanted.simulation);
  const LiveConfig now = liveConfigOf(origami_.session().simulation().config());
  if (!(live == now)) origami_.apply(ConfigureEdit{live});
  origami_.configure(wanted);
}

void LiveParameters::follow() {
  const OrigamiConfig now = current();
  if (valuesOf(now) == valuesOf(shown_)) return;
  shown_ = now;
  server_.updateConfig(shown_);
}

}  // namespace shell_origami
