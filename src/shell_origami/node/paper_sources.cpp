#include <shell_origami/node/paper_sources.h>

#include <shell_origami/base/error.h>

#include <optional>
#include <utility>

namespace shell_origami {
namespace {

/// The sheet and the recipe of the parameters.
Run newRun(const NodeConfig& config) {
  if (config.recipe.empty()) {
    return {Session(makeSimulation(config.sheet, config.simulation)), std::nullopt, config.paused};
  }
  Recipe recipe = loadRecipe(findRecipe(config.recipe), config.simulation, config.sheet);
  Simulation simulation = paperOf(recipe);
  return {Session(std::move(simulation)), RecipeRun(std::move(recipe), config.output),
          config.paused};
}

}  // namespace

Simulation paperOf(const Recipe& recipe) {
  std::vector<std::string> notes;
  Simulation simulation = makeSimulation(recipe.sheet, recipe.config, &notes);
  for (const std::string& note : notes) {
    ROS_WARN("%s: %s", recipe.sheet.pattern.c_str(), note.c_str());
  }
  return simulation;
}

Run beginRun(const NodeConfig& config, const Checkpoint& checkpoint) {
  std::optional<Run> kept = checkpoint.read();
  if (!kept) return newRun(config);
  ROS_INFO("going on from %s, at %.3f s", config.checkpoint.c_str(), kept->session.time());
  return std::move(*kept);
}

Simulation paperFromFile(const NodeConfig& config, const std::string& path, double scale,
                         std::vector<std::string>& notes) {
  if (isRecipe(path)) {
    if (scale != 0) {
      reject("scale is ", scale, ", but ", path, " is a recipe, which states its own scale");
    }
    const Recipe recipe = loadRecipe(path, config.simulation, config.sheet);
    return makeSimulation(recipe.sheet, recipe.config, &notes);
  }
  SheetSource source = config.sheet;
  source.pattern = path;
  source.scale = scale;
  return makeSimulation(source, config.simulation, &notes);
}

}  // namespace shell_origami
