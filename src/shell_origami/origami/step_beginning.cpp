#include <shell_origami/origami/step_beginning.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/crease_paths.h>
#include <shell_origami/origami/fold_phase.h>
#include <shell_origami/origami/layer_stack.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// By which a manoeuvre that failed takes longer when it is tried again.
constexpr double kSlower = 2;

Segment lineBetween(const std::array<Landmark, 2>& ends, const Sheet& sheet) {
  return {flatPoint(ends[0], sheet), flatPoint(ends[1], sheet)};
}

/// The creases that a fold changes, of those that there are.
std::vector<int> creasesOf(const FoldEdit& fold, const Sheet& sheet) {
  if (const auto* line = std::get_if<Segment>(&fold.where)) return creasesAlong(sheet, *line);
  std::vector<int> found;
  if (const auto* named = std::get_if<CreaseName>(&fold.where)) {
    for (std::size_t i = 0; i < sheet.creases().size(); ++i) {
      const Crease& crease = sheet.creases()[i];
      if (crease.name == named->name || inGroup(crease, named->name)) {
        found.push_back(static_cast<int>(i));
      }
    }
  }
  return found;
}

struct Begin {
  const Simulation& simulation;
  const RecipePlace& place;
  Viewpoint view;

  StepBeginning with(std::vector<Edit> edits) const { return {std::move(edits), view, {}}; }

  StepBeginning operator()(const PinStep& step) const { return with({PinEdit{step.where}}); }
  StepBeginning operator()(const UnpinStep& step) const { return with({UnpinEdit{step.where}}); }
  StepBeginning operator()(const FoldStep& step) const {
    std::vector<Edit> edits;
    for (std::size_t i = 0; i < step.folds.size(); ++i) {
      FoldEdit fold = step.folds[i];
      const auto line = step.lines.find(i);
      if (line != step.lines.end()) fold.where = lineBetween(line->second, simulation.sheet());
      if (!fold.duration) fold.duration = step.duration;
      edits.emplace_back(std::move(fold));
    }
    return with(std::move(edits));
  }
  StepBeginning operator()(const SettleStep& step) const {
    if (!step.quasi_static) return with({});
    return with({SettleEdit{}});
  }
  StepBeginning operator()(const FoldThroughStep& step) const {
    FoldThrough fold = *step.fold;
    fold.duration = step.duration;
    const FoldPlan plan = planFold(fold, view, simulation);
    const std::vector<FoldEdit> folds = foldEdits(plan, fold);
    return {{folds.begin(), folds.end()}, plan.after, {}};
  }
  StepBeginning operator()(const TurnOverStep&) const {
    return {{}, {view.point, !view.front}, {}};
  }
  StepBeginning operator()(const LookStep& step) const {
    return {{}, viewFrom(step.from, simulation), {}};
  }
  StepBeginning operator()(const WaitStep&) const { return with({}); }
  StepBeginning operator()(const AddVertexStep& step) const { return with({step.edit}); }
  StepBeginning operator()(const StopStep&) const { return with({StopEdit{}}); }
  StepBeginning operator()(const ConfigureStep& step) const {
    LiveConfig live = liveConfigOf(simulation.config());
    live.gravity = step.gravity.value_or(live.gravity);
    live.air_damping = step.air_damping.value_or(live.air_damping);
    live.fold_duration = step.fold_duration.value_or(live.fold_duration);
    return with({ConfigureEdit{live}});
  }
  StepBeginning operator()(const ManoeuvreStep& step) const {
    ManoeuvreManner manner = step.manner;
    if (place.failures > 0) {
      manner.duration *= kSlower;
      manner.looser = true;
    }
    ManoeuvrePlan plan = planManoeuvre(*step.manoeuvre, manner, view, simulation);
    FoldPhase first = std::move(plan.phases.front());
    plan.phases.erase(plan.phases.begin());
    return {{first.folds.begin(), first.folds.end()},
            plan.after,
            {simulation.time() + lengthOf(first), std::move(plan.phases), std::move(plan.result)}};
  }
  StepBeginning operator()(const UnfoldStep& step) const {
    if (place.unfolding.empty()) reject("unfold: no step before it has folded the paper");
    std::vector<Edit> edits;
    for (FoldEdit fold : place.unfolding) {
      fold.duration = step.duration;
      edits.emplace_back(std::move(fold));
    }
    return with(std::move(edits));
  }
  StepBeginning operator()(const LoosenStep& step) const {
    std::vector<Edit> edits;
    const auto add = [&](int crease) {
      FoldEdit fold = lineFold(lineOf(crease, simulation.sheet()),
                               simulation.creases()[crease].target_angle, 0);
      fold.stiffness = step.stiffness;
      edits.emplace_back(std::move(fold));
    };
    for (const std::string& name : step.names) {
      const std::size_t before = edits.size();
      for (std::size_t i = 0; i < simulation.sheet().creases().size(); ++i) {
        if (simulation.sheet().creases()[i].name == name) add(static_cast<int>(i));
      }
      if (edits.size() == before) reject("no crease is called '", name, "'");
    }
    for (const std::array<Landmark, 2>& ends : step.lines) {
      const Segment line = lineBetween(ends, simulation.sheet());
      const std::vector<int> along = creasesAlong(simulation.sheet(), line);
      if (along.empty()) {
        reject("no crease lies on the line from (", line[0].x(), ", ", line[0].y(), ") to (",
               line[1].x(), ", ", line[1].y(), ")");
      }
      for (int crease : along) add(crease);
    }
    return with(std::move(edits));
  }
  StepBeginning operator()(const AddObstacleStep& step) const {
    return with({step.obstacles.begin(), step.obstacles.end()});
  }
  StepBeginning operator()(const RemoveObstacleStep& step) const {
    return with({RemoveObstacleEdit{step.ids}});
  }
  StepBeginning operator()(const MoveObstacleStep& step) const {
    return with({MoveObstacleEdit{step.id, step.pose, step.duration}});
  }
  StepBeginning operator()(const GraspStep& step) const { return with({step.edit}); }
  StepBeginning operator()(const ReleaseStep& step) const { return with({ReleaseEdit{step.ids}}); }
};

}  // namespace

StepBeginning beginningOf(const RecipeStep& step, const RecipePlace& place,
                          const Simulation& simulation) {
  return std::visit(Begin{simulation, place, place.view.value_or(frontOf(simulation.sheet()))},
                    step);
}

std::vector<FoldEdit> foldsOf(const StepBeginning& beginning) {
  if (!beginning.under_way.result.empty()) return beginning.under_way.result;
  std::vector<FoldEdit> folds;
  for (const Edit& edit : beginning.edits) {
    if (const auto* fold = std::get_if<FoldEdit>(&edit)) folds.push_back(*fold);
  }
  return folds;
}

std::vector<FoldEdit> unfoldingOf(const std::vector<FoldEdit>& folds,
                                  const Simulation& simulation) {
  if (folds.empty()) return {};
  const Sheet& sheet = simulation.sheet();
  const std::vector<CreaseStatus> creases = simulation.creases();
  std::vector<FoldEdit> unfolding, pieces;
  for (const FoldEdit& fold : folds) {
    if (const auto* line = std::get_if<Segment>(&fold.where)) {
      unfolding.push_back(lineFold(*line, 0, fold.duration.value_or(0)));
    }
    for (int crease : creasesOf(fold, sheet)) {
      pieces.push_back(
          lineFold(lineOf(crease, sheet), creases[crease].target_angle, fold.duration.value_or(0)));
    }
  }
  unfolding.insert(unfolding.end(), pieces.begin(), pieces.end());
  return unfolding;
}

}  // namespace shell_origami
