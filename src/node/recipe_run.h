/// \file
/// A recipe under way: what it does is told in the log, and its results are written at the end.
#pragma once

#include "origami/recipe.h"

#include <ros/time.h>

#include <string>

namespace shell_origami {

class RecipeRun {
 public:
  /// \param output  folder for the results; empty: none are written
  RecipeRun(Recipe recipe, std::string output);

  /// Does what is due before the next step. Returns false once the recipe is over.
  /// \throws std::exception when the paper refuses an edit or the results cannot be written.
  bool update(Simulation& simulation);

  const Recipe& recipe() const { return runner_.recipe(); }

 private:
  void finish(const Simulation& simulation) const;

  RecipeRunner runner_;
  std::string output_;
  int told_ = -1;  ///< step that the log told of
  ros::SteadyTime start_;
};

}  // namespace shell_origami
