/// \file
/// The folding sequence of a recipe, diagrams.fold: the paper at the start and after each step that
/// folds it.
#pragma once

#include <shell_origami/base/files.h>
#include <shell_origami/origami/recipe.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

namespace shell_origami {

/// Gathers the frames of the sequence while a recipe runs. The paper after a step is that before
/// the next fold, so that it has settled.
class Sequence {
 public:
  /// To be called with the edits of each step before they are made.
  void before(const std::vector<Edit>& edits, const RecipeRunner& runner,
              const Simulation& simulation);
  /// To be called with what they did.
  void after(const std::vector<EditRecord>& records, const RecipeRunner& runner);

  /// Returns diagrams.fold: a FOLD file of class "diagrams" with the flat pattern as its key frame,
  /// as the paper is at the end.
  TextFile file(const RecipeRunner& runner, const Simulation& simulation);

 private:
  /// The step whose frame comes next.
  struct Step {
    int number = 0;  ///< in the recipe, from 1 on; 0: the start
    std::string word = "start";
    double angle = 0, part = 0;  ///< largest that it asks for: [rad], of the pattern's angle
    std::set<std::uint32_t> crease_ids = {};  ///< that it folds

    void add(const FoldEdit& fold, const std::vector<std::uint32_t>& ids);
    std::string title() const;
  };
  void close(const RecipeRunner& runner, const Simulation& simulation);

  bool open_ = true;  ///< whether step_ has no frame yet
  Step step_;
  std::vector<nlohmann::json> frames_;
};

}  // namespace shell_origami
