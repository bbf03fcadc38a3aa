#include <shell_origami/node/live_parameters.h>

#include <shell_origami/base/error.h>

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
  std::variant<double*, bool*, Choice> value;
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
    } else if (const auto* choice = std::get_if<Choice>(&place)) {
      fields.push_back({name, *choice, parameter.bounds});
    } else {
      fields.push_back({name, std::get<double*>(place), parameter.bounds});
    }
  }
  return fields;
}

using Value = std::variant<double, std::string>;  ///< true: 1
using Values = std::map<std::string, Value>;

bool isTrue(const Value& value) { return std::get<double>(value) != 0; }

Values valuesOf(const OrigamiConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  Values values;
  for (const auto& number : message.doubles) values[number.name] = number.value;
  for (const auto& truth : message.bools) values[truth.name] = static_cast<double>(truth.value);
  for (const auto& word : message.strs) values[word.name] = word.value;
  return values;
}

/// \pre there is a value of every name in cfg/Origami.cfg
OrigamiConfig configOf(const Values& values) {
  OrigamiConfig config = OrigamiConfig::__getDefault__();
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  for (auto& number : message.doubles) number.value = std::get<double>(values.at(number.name));
  for (auto& truth : message.bools) truth.value = isTrue(values.at(truth.name));
  for (auto& word : message.strs) word.value = std::get<std::string>(values.at(word.name));
  config.__fromMessage__(message);
  return config;
}

/// Without the values that a former run left on the master.
ros::NodeHandle cleared(const ros::NodeHandle& node) {
  node.deleteParam("live");
  return ros::NodeHandle(node, "live");
}

Value valueOf(const LiveField& field) {
  if (const auto* number = std::get_if<double*>(&field.value)) return **number;
  if (const auto* truth = std::get_if<bool*>(&field.value)) return **truth ? 1.0 : 0.0;
  return std::get<Choice>(field.value).get();
}

/// \throws std::invalid_argument for a word that is no choice
void set(LiveField& field, const Value& value) {
  if (auto* const* number = std::get_if<double*>(&field.value)) {
    **number = std::get<double>(value);
  } else if (auto* const* truth = std::get_if<bool*>(&field.value)) {
    **truth = isTrue(value);
  } else if (auto& choice = std::get<Choice>(field.value);
             !choice.set(std::get<std::string>(value))) {
    reject(field.name, " is \"", std::get<std::string>(value), "\", but must be ", choice.text());
  }
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
  for (const LiveField& field : liveFields(config)) values[field.name] = valueOf(field);
  return configOf(values);
}

/// Tells whoever draws sliders of bounds and of the values to go back to. The generated bounds are
/// infinite: a value beyond them would be moved there without a word.
void LiveParameters::describe() {
  NodeConfig config = parameters();
  Values low, high;
  for (const LiveField& field : liveFields(config)) {
    const bool number = std::holds_alternative<double*>(field.value);
    if (std::holds_alternative<Choice>(field.value)) {
      low[field.name] = high[field.name] = "";
    } else {
      low[field.name] = number ? field.bounds.low : 0;
      high[field.name] = number ? field.bounds.high : 1;
    }
  }
  server_.setConfigMin(configOf(low));
  server_.setConfigMax(configOf(high));
  server_.setConfigDefault(shown_);
}

/// Only what differs from what was shown is wanted: another paper may have brought other values
/// meanwhile.
void LiveParameters::change(OrigamiConfig& config) {
  const Values asked = valuesOf(config), shown = valuesOf(shown_);
  try {
    NodeConfig wanted = parameters();
    for (LiveField& field : liveFields(wanted)) {
      if (asked.at(field.name) != shown.at(field.name)) set(field, asked.at(field.name));
    }
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
