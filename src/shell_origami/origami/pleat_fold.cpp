#include <shell_origami/origami/pleat_fold.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/layer_cuts.h>

#include <optional>
#include <variant>
#include <vector>

namespace shell_origami {
namespace {

/// The place that a fold moves.
struct Mover {
  Landmark operator()(const BringPoint& bring) const { return bring.from; }
  Landmark operator()(const BringEdge& bring) const {
    return {PartOfWay{{bring.edge[0], bring.edge[1]}, 0.5}};
  }
  Landmark operator()(const FoldAcross& across) const { return across.move; }
  Landmark operator()(const FoldAlong& along) const { return along.move; }
};

class PleatPlanner {
 public:
  PleatPlanner(const PleatFold& pleat, const ManoeuvreManner& manner, const Viewpoint& view,
               const Simulation& simulation)
      : pleat_(pleat),
        manner_(manner),
        simulation_(simulation),
        sheet_(simulation.sheet()),
        paper_(viewedPaper(view, simulation)),
        first_(foldPlane(pleat.fold.axiom, sheet_, paper_.positions, paper_.viewer)),
        second_(foldPlane(FoldAlong{pleat.back, std::visit(Mover{}, pleat.fold.axiom)}, sheet_,
                          paper_.positions, paper_.viewer)) {}

  ManoeuvrePlan plan() {
    for (const Landmark& point : pleat_.back) requireBeyond(flatPoint(point, sheet_));
    const FoldThrough& fold = pleat_.fold;
    const LayersBesidePlane layers(sheet_, paper_, first_, kReach * sheet_.size());
    std::optional<Vector2> flap;
    if (fold.layers == FoldLayers::kFlap) flap = flatPoint(fold.flap, sheet_);
    std::vector<bool> moves = layers.chosen(fold.layers, fold.count, flap);
    layers.requireFree(moves, fold.behind);
    ManoeuvrePlan plan{{}, {}, layers.viewOfRest(moves)};
    cutAll(layers, first_, moves, fold.behind);

    const LayersBesidePlane beyond(sheet_, paper_, second_, kReach * sheet_.size());
    for (std::size_t i = 0; i < moves.size(); ++i) {
      moves[i] = moves[i] && beyond.inFlap(i);
    }
    for (const LayerCut& cut : cutAll(beyond, second_, moves, !fold.behind)) {
      for (const Vector2& end : cut.line) requireBeyond(end);
    }
    plan.phases = {{folds_, kRest * manner_.duration}};
    plan.result = folds_;
    return plan;
  }

 private:
  /// Within which the paper may settle, as a part of the duration.
  static constexpr double kRest = 0.3;

  /// Adds a fold for each layer that moves.
  std::vector<LayerCut> cutAll(const LayersBesidePlane& layers, const FoldPlane& plane,
                               const std::vector<bool>& moves, bool behind) {
    const std::vector<LayerCut> cuts = cutLayers(sheet_, paper_, plane, layers, moves);
    if (cuts.empty()) reject("no layer is cut by one of the pleat's folds");
    const std::vector<CreaseStatus> creases = simulation_.creases();
    for (const LayerCut& cut : cuts) {
      const double turn = layers.turn(cut.triangle, manner_.angle, behind);
      folds_.push_back(lineFold(cut.line, angleOf(cut, turn, creases), manner_.duration));
    }
    return cuts;
  }

  void requireBeyond(const Vector2& point) const {
    const Vector3 place = pointInSpace(point, sheet_, paper_.positions);
    if (first_.distance(place) > -kReach * sheet_.size()) return;
    reject("the pleat is folded back at (", point.x(), ", ", point.y(),
           ") of the flat sheet, which is not beyond its first fold");
  }

  const PleatFold& pleat_;
  const ManoeuvreManner& manner_;
  const Simulation& simulation_;
  const Sheet& sheet_;
  ViewedPaper paper_;
  FoldPlane first_, second_;
  std::vector<FoldEdit> folds_;
};

}  // namespace

ManoeuvrePlan planPleatFold(const PleatFold& pleat, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation) {
  return PleatPlanner(pleat, manner, view, simulation).plan();
}

}  // namespace shell_origami
