#include <shell_origami/node/recipe_action.h>

#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>
#include <shell_origami/node/conversions.h>
#include <shell_origami/node/message_text.h>
#include <shell_origami/origami/outcome.h>

#include <utility>

namespace shell_origami {
namespace {

/// The node answers no other request while it reads one.
constexpr std::size_t kLongestYaml = 1000000;

Recipe recipeOf(const msg::FoldRecipeGoal& goal, const std::string& path,
                const NodeConfig& config) {
  if (goal.yaml.size() > kLongestYaml) {
    reject("yaml is ", goal.yaml.size(), " bytes long, but may be ", kLongestYaml, " at most");
  }
  Recipe recipe = goal.yaml.empty()
                      ? loadRecipe(path, config.simulation, config.sheet)
                      : readRecipe({"yaml", "", goal.yaml}, config.simulation, config.sheet);
  if (recipe.states("sheet")) return recipe;
  for (const char* word : {"material", "solver", "gravity"}) {
    if (recipe.states(word)) {
      reject(recipe.name, " states ", word,
             " but no sheet: the paper that lies there keeps its own");
    }
  }
  return recipe;
}

}  // namespace

RecipeAction::RecipeAction(ros::NodeHandle& node, OrigamiNode& origami)
    : origami_(origami),
      server_(
          node, [this](Goal goal) { receive(goal); }, [this](Goal goal) { cancel(goal); }) {
  const ros::WallDuration period(1 / origami.config().publish_rate);
  feedback_ = node.createWallTimer(period, [this](const ros::WallTimerEvent&) {
    if (goal_) publishFeedback(*origami_.recipe());
  });
  server_.start();
}

RecipeAction::~RecipeAction() {
  if (!goal_) return;
  origami_.recipe()->forgetListener();
  goal_->setAborted(result(), "the action ends here, while its recipe goes on");
}

void RecipeAction::receive(Goal goal) {
  try {
    if (const RecipeRun* run = origami_.recipe()) {
      reject("recipe ", run->recipe().name, " is under way: wait for its end, or cancel it");
    }
    const msg::FoldRecipeGoal& wanted = *goal.getGoal();
    requireOne({{"recipe", !wanted.recipe.empty()}, {"yaml", !wanted.yaml.empty()}});
    const std::string path = wanted.recipe.empty() ? "" : findRecipe(expandedPath(wanted.recipe));
    origami_.startRecipe(recipeOf(wanted, path, origami_.config()), path,
                         [this](const RecipeRun& run, const std::string& why) { ended(run, why); });
    goal.setAccepted();
    goal_ = goal;
    publishFeedback(*origami_.recipe());
  } catch (const std::exception& error) {
    const std::string sentence = asMessageText(error.what());
    ROS_WARN("fold_recipe refused: %s", sentence.c_str());
    goal.setRejected({}, sentence);
  }
}

/// Only the goal under way can be canceled: all others have ended.
void RecipeAction::cancel(Goal goal) {
  goal_.reset();
  origami_.cancelRecipe("its goal is canceled");
  goal.setCanceled(result(), "the recipe is canceled: the paper stays as it is");
}

void RecipeAction::ended(const RecipeRun& run, const std::string& why) {
  if (!goal_) return;  // canceled
  publishFeedback(run);
  Goal goal = *std::exchange(goal_, std::nullopt);
  if (why.empty()) {
    const msg::FoldRecipeResult reached = result();
    goal.setSucceeded(
        reached, "the recipe is done" + (reached.missed.empty() ? "" : ", but " + reached.missed));
  } else {
    goal.setAborted(result(), asMessageText(why));
  }
}

void RecipeAction::publishFeedback(const RecipeRun& run) {
  msg::FoldRecipeFeedback feedback;
  feedback.step = static_cast<std::uint32_t>(run.stepNumber());
  feedback.steps = static_cast<std::uint32_t>(run.recipe().steps.size());
  feedback.doing = run.runner().doing();
  feedback.progress = static_cast<float>(run.runner().progress(origami_.session().simulation()));
  feedback.sim_time = ros::Time(origami_.session().time());
  goal_->publishFeedback(feedback);
}

msg::FoldRecipeResult RecipeAction::result() {
  const Simulation& simulation = origami_.session().simulation();
  msg::FoldRecipeResult result;
  result.max_strain = simulation.maxStrain();
  result.creases = creaseStates(simulation);
  result.missed = asMessageText(shortfallText(shortfalls(simulation)));
  return result;
}

}  // namespace shell_origami
