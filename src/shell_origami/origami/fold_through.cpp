#include <shell_origami/origami/fold_through.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/layer_cuts.h>

#include <utility>

namespace shell_origami {
FoldPlan planFold(const FoldThrough& fold, const Viewpoint& view, const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  const ViewedPaper paper = viewedPaper(view, simulation);
  const FoldPlane plane = foldPlane(fold.axiom, sheet, paper.positions, paper.viewer);
  const LayersBesidePlane layers(sheet, paper, plane, kReach * sheet.size());
  std::optional<Vector2> flap;
  if (fold.layers == FoldLayers::kFlap) flap = flatPoint(fold.flap, sheet);
  const std::vector<bool> moves = layers.chosen(fold.layers, fold.count, flap);
  layers.requireFree(moves, fold.behind);
  FoldPlan plan{{}, layers.viewOfRest(moves)};
  const std::vector<CreaseStatus> creases = simulation.creases();
  for (const LayerCut& cut : cutLayers(sheet, paper, plane, layers, moves)) {
    const double angle = angleOf(cut, layers.turn(cut.triangle, fold.angle, fold.behind), creases);
    plan.layers.push_back({cut.panel, cut.line, angle});
  }
  if (plan.layers.empty()) reject("no layer is cut by the fold");
  return plan;
}

std::vector<FoldEdit> foldEdits(const FoldPlan& plan, const FoldThrough& fold) {
  std::vector<FoldEdit> edits;
  for (const LayerFold& layer : plan.layers) {
    FoldEdit edit;
    edit.where = layer.line;
    edit.angle = layer.angle;
    edit.duration = fold.duration;
    edit.name = fold.name;
    edits.push_back(std::move(edit));
  }
  return edits;
}

}  // namespace shell_origami
