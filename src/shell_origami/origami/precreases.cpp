#include <shell_origami/origami/precreases.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/step_beginning.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

namespace shell_origami {
namespace {

/// Stiffness of a line that is only drawn, as a part of the material's.
constexpr double kDrawn = 0.5;

/// Paper that is folded in thought: rigid panels, layers that take no room.
class ThoughtPaper {
 public:
  explicit ThoughtPaper(const Recipe& recipe)
      : config_(withoutContact(recipe.config)), paper_(makeSimulation(recipe.sheet, config_)) {}

  const Simulation& paper() const { return paper_; }

  void fold(const std::vector<FoldEdit>& folds) {
    for (FoldEdit fold : folds) {
      fold.duration = 0;
      paper_.apply(fold);
    }
    std::vector<double> angles;
    for (const CreaseStatus& crease : paper_.creases()) {
      const bool shut = std::abs(crease.target_angle) > kShutFrom;
      angles.push_back(shut ? std::copysign(M_PI, crease.target_angle) : crease.target_angle);
    }
    const Positions folded = foldRigidly(paper_.sheet(), angles);
    for (double& angle : angles) angle = std::min(std::max(angle, -kShutAngle), kShutAngle);
    paper_ = Simulation(paper_.sheet(), config_, folded, angles);
  }

 private:
  /// Creases that are to be shut are shut altogether [rad].
  static constexpr double kShutFrom = 2.9;

  static SimulationConfig withoutContact(SimulationConfig config) {
    config.contact.enabled = false;
    return config;
  }

  SimulationConfig config_;
  Simulation paper_;
};

void requireNoOrder(const RecipeStep& step) {
  const auto* fold = std::get_if<FoldThroughStep>(&step);
  if (fold && fold->fold->layers == FoldLayers::kTop) {
    reject("which layers are at the top is not known before the paper is folded: use flap");
  }
}

}  // namespace

std::vector<FoldEdit> precreasesOf(const Recipe& recipe) {
  ThoughtPaper thought(recipe);
  std::vector<FoldEdit> drawn;
  RecipePlace place;
  for (; place.step < static_cast<int>(recipe.steps.size()); ++place.step) {
    const RecipeStep& step = recipe.steps[place.step];
    try {
      requireNoOrder(step);
      const StepBeginning beginning = beginningOf(step, place, thought.paper());
      const std::vector<FoldEdit> folds = foldsOf(beginning);
      std::vector<FoldEdit> unfolding = unfoldingOf(folds, thought.paper());
      if (!unfolding.empty()) place.unfolding = std::move(unfolding);
      place.view = beginning.view;
      for (const FoldEdit& fold : folds) {
        const auto* line = std::get_if<Segment>(&fold.where);
        if (!line) continue;
        drawn.push_back(lineFold(*line, 0, 0));
        drawn.back().name = fold.name;
        drawn.back().stiffness = kDrawn * recipe.config.material.crease_stiffness;
      }
      if (!folds.empty()) thought.fold(folds);
    } catch (const std::invalid_argument& error) {
      reject("precrease, step ", place.step + 1, ": ", error.what());
    }
  }
  return drawn;
}

}  // namespace shell_origami
