#include <shell_origami/node/parameters.h>

#include <shell_origami/base/error.h>
#include <shell_origami/node/parameter_reader.h>

#include <ros/package.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace shell_origami {
namespace {

template <class Value>
void require(bool holds, const std::string& name, const Value& value, const std::string& wanted) {
  if (!holds) reject("parameter ~", name, " is ", value, ", but must be ", wanted);
}

void readMaterial(ParameterReader& reader, Material& material) {
  reader.read("material/youngs_modulus", material.youngs_modulus);
  reader.read("material/poisson_ratio", material.poisson_ratio);
  reader.read("material/thickness", material.thickness);
  reader.read("material/density", material.density);
  reader.read("material/crease_stiffness", material.crease_stiffness);
  reader.read("material/air_damping", material.air_damping);
  readChoice(reader, "material/membrane", membraneNames(), material.membrane);
  reader.read("material/crease_height_term", material.crease_height_term);
  reader.read("material/yield_curvature", material.yield_curvature);
  reader.read("material/hardening", material.hardening);
}

void readSolver(ParameterReader& reader, SolverConfig& solver) {
  readChoice(reader, "solver/integrator", integratorNames(), solver.integrator);
  reader.read("solver/time_step", solver.time_step);
  reader.read("solver/beta", solver.beta);
  reader.read("solver/gamma", solver.gamma);
  reader.read("solver/tolerance", solver.tolerance);
  reader.read("solver/max_iterations", solver.max_iterations);
}

void readSheet(ParameterReader& reader, SheetSource& sheet) {
  reader.read("sheet/width", sheet.width);
  reader.read("sheet/height", sheet.height);
  reader.read("sheet/max_edge", sheet.max_edge);
}

void readClock(ParameterReader& reader, NodeConfig& config) {
  readChoice<ClockMode>(reader, "clock",
                        {{"follow", ClockMode::kFollow}, {"lead", ClockMode::kLead}}, config.clock);
  reader.read("real_time_factor", config.real_time_factor);
}

void checkSimulation(const SimulationConfig& config) {
  try {
    checkConfig(config);
  } catch (const std::invalid_argument& error) {
    reject("parameter ~", error.what());
  }
}

}  // namespace

void checkParameters(const NodeConfig& config) {
  checkSimulation(config.simulation);
  require(config.sheet.width > 0, "sheet/width", config.sheet.width, "positive");
  require(config.sheet.height > 0, "sheet/height", config.sheet.height, "positive");
  require(config.sheet.max_edge > 0, "sheet/max_edge", config.sheet.max_edge, "positive");
  const auto& [slowest, fastest] = kPublishRateBounds;
  require(config.publish_rate >= slowest && config.publish_rate <= fastest, "publish_rate",
          config.publish_rate, "from 0.01 to 1000");
  const auto& [shortest, longest] = kCheckpointPeriodBounds;
  require(config.checkpoint_period >= shortest && config.checkpoint_period <= longest,
          "checkpoint/period", config.checkpoint_period, "from 0.1 to 1e6");
  require(!config.world_frame.empty() && config.world_frame[0] != '/', "world_frame",
          '"' + config.world_frame + '"', "a frame's name without a leading slash");
  require(config.real_time_factor >= 0 && std::isfinite(config.real_time_factor),
          "real_time_factor", config.real_time_factor, "zero or positive, and finite");
  if (config.clock == ClockMode::kLead && !ros::Time::isSimTime()) {
    reject(
        "parameter ~clock is \"lead\", but that publishes /clock and needs /use_sim_time to be "
        "true");
  }
}

NodeConfig loadParameters(const ros::NodeHandle& private_node) {
  NodeConfig config;
  ParameterReader reader(private_node);
  readSheet(reader, config.sheet);
  readMaterial(reader, config.simulation.material);
  reader.read("gravity", config.simulation.gravity);
  readSolver(reader, config.simulation.solver);
  reader.read("fold_duration", config.simulation.fold_duration);
  reader.read("recipe", config.recipe);
  reader.read("output", config.output);
  reader.read("paused", config.paused);
  reader.read("wait_for_recorder", config.wait_for_recorder);
  reader.read("checkpoint/file", config.checkpoint);
  reader.read("checkpoint/period", config.checkpoint_period);
  reader.read("publish_rate", config.publish_rate);
  reader.read("world_frame", config.world_frame);
  reader.read("vertex_ids", config.vertex_ids);
  readChoice(reader, "colouring", coloringNames(), config.colouring);
  readClock(reader, config);
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
