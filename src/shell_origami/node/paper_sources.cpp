#include <shell_origami/node/paper_sources.h>

#include <shell_origami/base/error.h>

#include <optional>
#include <utility>

namespace shell_origami {
namespace {

NewPaper newPaper(const PaperOrigin& origin, std::vector<std::string>* notes = nullptr) {
  return {makeSimulation(origin.sheet, origin.config, notes), origin};
}

/// The sheet and the recipe of the parameters.
Run newRun(const NodeConfig& config) {
  if (config.recipe.empty()) {
    return {Session(newPaper({config.sheet, config.simulation, {}})), std::nullopt, config.paused};
  }
  Recipe recipe = loadRecipe(findRecipe(config.recipe), config.simulation, config.sheet);
  NewPaper paper = paperOf(recipe);
  return {Session(std::move(paper)), RecipeRun(std::move(recipe), config.output), config.paused};
}

}  // namespace

NewPaper paperOf(const Recipe& recipe) {
  std::vector<std::string> notes;
  NewPaper paper = newPaper({recipe.sheet, recipe.config, recipe.names}, &notes);
  for (const std::string& note : notes) {
    ROS_WARN("%s: %s", recipe.sheet.pattern.c_str(), note.c_str());
  }
  return paper;
}

Run beginRun(const NodeConfig& config, const Checkpoint& checkpoint) {
  std::optional<Run> kept = checkpoint.read();
  if (!kept) return newRun(config);
  ROS_INFO("going on from %s, at %.3f s", config.checkpoint.c_str(), kept->session.time());
  return std::move(*kept);
}

NewPaper paperFromFile(const NodeConfig& config, const std::string& path, double scale,
                       std::vector<std::string>& notes) {
  if (isRecipe(path)) {
    if (scale != 0) {
      reject("scale is ", scale, ", but ", path, " is a recipe, which states its own scale");
    }
    const Recipe recipe = loadRecipe(path, config.simulation, config.sheet);
    return newPaper({recipe.sheet, recipe.config, recipe.names}, &notes);
  }
  SheetSource source = config.sheet;
  source.pattern = path;
  source.scale = scale;
  return newPaper({source, config.simulation, {}}, &notes);
}

}  // namespace shell_origami
