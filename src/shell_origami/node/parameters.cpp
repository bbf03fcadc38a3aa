#include <shell_origami/node/parameters.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/frames.h>
#include <shell_origami/node/parameter_reader.h>

#include <ros/package.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <system_error>

namespace shell_origami {
namespace {

const std::map<std::string, ClockMode>& clockNames() {
  static const std::map<std::string, ClockMode> names{{"follow", ClockMode::kFollow},
                                                      {"lead", ClockMode::kLead}};
  return names;
}

template <class Value>
std::function<Place(NodeConfig&)> at(Value NodeConfig::*member) {
  return [member](NodeConfig& config) { return Place(&(config.*member)); };
}

std::function<Place(NodeConfig&)> option(bool MarkerOptions::*member) {
  return [member](NodeConfig& config) { return Place(&(config.markers.*member)); };
}

template <class Value>
std::function<Place(NodeConfig&)> depth(Value DepthConfig::*member) {
  return [member](NodeConfig& config) { return Place(&(config.depth.*member)); };
}

template <class Value>
std::function<Place(NodeConfig&)> camera(Value PinholeCamera::*member) {
  return [member](NodeConfig& config) { return Place(&(config.depth.camera.*member)); };
}

Place coloring(NodeConfig& config) { return Choice(coloringNames(), config.colouring); }

Place clock(NodeConfig& config) { return Choice(clockNames(), config.clock); }

ParameterTable<NodeConfig> makeTable() {
  using Config = NodeConfig;
  constexpr bool kLive = true;
  constexpr Bounds kUnbounded{};  // of words, and of what is true or false
  ParameterTable<Config> table;
  append(table, sheetParameters(), &Config::sheet);
  append(table, simulationParameters(), &Config::simulation);
  table.insert(
      table.end(),
      {{"recipe", at(&Config::recipe), "carried out at the start; empty: none", "", kUnbounded},
       {"output", at(&Config::output), "for the results of the recipe; empty: none", "",
        kUnbounded},
       {"paused", at(&Config::paused), "whether to start paused", "", kUnbounded},
       {"wait_for_recorder", at(&Config::wait_for_recorder),
        "whether to start only once `~sheet`, `~state` and `~edits` are heard, within 20 s", "",
        kUnbounded},
       {"wait_for_viewer", at(&Config::wait_for_viewer),
        "how long the start waits until somebody hears `~markers`; 0: not", "s", between(0, 1e6)},
       {"checkpoint/file", at(&Config::checkpoint), "to go on from and to keep; empty: none", "",
        kUnbounded},
       {"checkpoint/period", at(&Config::checkpoint_period),
        "of elapsed time, from one checkpoint to the next", "s", between(0.1, 1e6)},
       {"undo_memory", at(&Config::undo_memory),
        "for the papers before edits, to undo these; 0: none can be undone", "MB", between(0, 1e6)},
       {"publish_rate", at(&Config::publish_rate), "in ROS time, at most once a step", "Hz",
        between(0.01, 1000), kLive},
       // diagnostic_updater reads the parameter of this name as well.
       {"diagnostic_period", at(&Config::diagnostic_period),
        "of elapsed time, from one message on `/diagnostics` to the next", "s", between(0.1, 1e6)},
       {"watch_master", at(&Config::watch_master),
        "whether to look for a restarted master, and to register there", "", kUnbounded},
       {"world_frame", at(&Config::world_frame), "frame of the positions", "", kUnbounded},
       {"frame_prefix", at(&Config::frame_prefix),
        "with which the names of `paper` and `panel_<n>` begin", "", kUnbounded},
       {"vertex_ids", option(&MarkerOptions::vertex_ids),
        "whether `~markers` shows the vertices' numbers", "", kUnbounded, kLive},
       {"crease_labels", option(&MarkerOptions::crease_labels),
        "whether `~markers` shows the creases' names and angles", "", kUnbounded, kLive},
       {"contact_points", option(&MarkerOptions::contact_points),
        "whether `~markers` shows where layers push each other apart", "", kUnbounded, kLive},
       {"colouring", coloring, "what the colors of `~markers` tell", "", kUnbounded, kLive},
       {"cloud/points", at(&Config::cloud_points),
        "about how many `~cloud` has, half of them on each side", "", between(2, 1e6)},
       {"depth/frame", depth(&DepthConfig::frame),
        "of the depth camera, an optical frame: z forward, x to the right, y down", "", kUnbounded},
       {"depth/rate", depth(&DepthConfig::rate), "of its images, in ROS time", "Hz",
        between(0.01, 100)},
       {"depth/width", camera(&PinholeCamera::width), "of its images", "pixel", between(1, 4096)},
       {"depth/height", camera(&PinholeCamera::height), "of its images", "pixel", between(1, 4096)},
       {"depth/focal_length", camera(&PinholeCamera::focal_length),
        "which with the width says how much it sees", "pixel", kPositive},
       {"depth/near", camera(&PinholeCamera::near),
        "the smallest depth that it measures; less than `depth/far`", "m", kNotNegative},
       {"depth/far", camera(&PinholeCamera::far), "the largest depth that it measures", "m",
        kPositive},
       {"clock", clock, "how simulated time runs", "", kUnbounded},
       {"real_time_factor", at(&Config::real_time_factor),
        "with `clock: lead`, simulated over elapsed time; 0: as fast as it can", "", kNotNegative,
        kLive}});
  return table;
}

void requireFrameName(const std::string& parameter, const std::string& name) {
  if (!name.empty() && name[0] != '/') return;
  reject("parameter ~", parameter, " is \"", name,
         "\", but must be a frame's name without a leading slash");
}

}  // namespace

const ParameterTable<NodeConfig>& nodeParameters() {
  static const ParameterTable<NodeConfig> table = makeTable();
  return table;
}

void checkParameters(const NodeConfig& config) {
  try {
    checkValues(nodeParameters(), config);
  } catch (const std::invalid_argument& error) {
    reject("parameter ~", error.what());
  }
  requireFrameName("world_frame", config.world_frame);
  requireFrameName("depth/frame", config.depth.frame);
  if (!config.frame_prefix.empty() && config.frame_prefix[0] == '/') {
    reject("parameter ~frame_prefix is \"", config.frame_prefix,
           "\", but must be without a leading slash");
  }
  if (isPaperFrame(config.world_frame, config.frame_prefix)) {
    reject("parameter ~world_frame is \"", config.world_frame,
           "\", but that is one of the paper's own frames");
  }
  const PinholeCamera& camera = config.depth.camera;
  if (camera.near >= camera.far) {
    reject("parameter ~depth/near is ", camera.near, ", but must be less than depth/far, ",
           camera.far);
  }
  if (config.clock == ClockMode::kLead && !ros::Time::isSimTime()) {
    reject(
        "parameter ~clock is \"lead\", but that publishes /clock and needs /use_sim_time to be "
        "true");
  }
}

NodeConfig loadParameters(const ros::NodeHandle& private_node) {
  NodeConfig config;
  ParameterReader reader(private_node);
  for (const auto& parameter : nodeParameters()) {
    reader.read(parameter.name, parameter.place(config));
  }
  reader.ignore("live");  // what dynamic_reconfigure keeps there
  reader.rejectUnread();
  checkParameters(config);
  return config;
}

std::string findRecipe(const std::string& recipe) {
  namespace fs = std::filesystem;
  std::error_code error;  // whatever it is, there is no such file
  if (fs::is_regular_file(recipe, error)) return recipe;
  if (recipe.find('/') != std::string::npos) {
    reject("recipe is \"", recipe, "\", but there is no such file");
  }
  const std::string own = ros::package::getPath("shell_origami") + "/recipes/" + recipe + ".yaml";
  if (fs::is_regular_file(own, error)) return own;
  reject("recipe is \"", recipe, "\", but there is no such file, and no ", own);
}

}  // namespace shell_origami
