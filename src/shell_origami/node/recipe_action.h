/// \file
/// The action ~fold_recipe: a goal is a recipe, its end the end of the recipe.
#pragma once

#include <shell_origami/node/origami_node.h>
#include <shell_origami/node/recipe_server.h>

#include <optional>
#include <string>

namespace shell_origami {

/// Each goal ends in exactly one way. While a recipe is under way, be it of a goal or of the
/// parameter ~recipe, further goals are rejected, and so are goals that make no sense.
class RecipeAction {
 public:
  RecipeAction(ros::NodeHandle& node, OrigamiNode& origami);
  RecipeAction(const RecipeAction&) = delete;
  RecipeAction& operator=(const RecipeAction&) = delete;
  /// A goal under way is aborted; its recipe goes on.
  ~RecipeAction();

 private:
  using Goal = RecipeServer::GoalHandle;

  void receive(Goal goal);
  void cancel(Goal goal);
  void ended(const RecipeRun& run, const std::string& why);
  void publishFeedback(const RecipeRun& run);
  msg::FoldRecipeResult result();

  OrigamiNode& origami_;
  RecipeServer server_;
  std::optional<Goal> goal_;  ///< under way
  ros::WallTimer feedback_;
};

}  // namespace shell_origami
