#include <shell_origami/origami/petal_fold.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace shell_origami {
namespace {

/// One of the two shut creases beside the flap, from the outline to the flap's top.
struct Side {
  int outer;     ///< its vertex on the outline
  int next;      ///< the next one along it
  double angle;  ///< [rad]
};

Side sideAt(int outer, const FoldedCreases& creases, const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  const std::vector<int> ends = creases.at(outer);
  const Vector2& place = sheet.flatPositions()[outer];
  if (ends.size() != 1) {
    reject("beside the flap ", ends.size(), " creases end at (", place.x(), ", ", place.y(),
           ") of the edge, not one");
  }
  return {outer, ends[0], shutAngle(creaseBetween(sheet, outer, ends[0]), simulation)};
}

}  // namespace

ManoeuvrePlan planPetalFold(const PetalFold& petal, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  const auto& flat = sheet.flatPositions();
  const int tip = outlineVertexAt(petal.flap, "the flap's tip", sheet);
  const Vector2& w = flat[tip];
  const FoldedCreases creases = foldedCreases(simulation);
  const std::array<int, 2> outer = creases.nextOnOutline(tip);
  if (outer[0] == tip || outer[0] == outer[1]) {
    reject("no two creases end on the edge beside the flap's tip (", w.x(), ", ", w.y(), ")");
  }
  const Side sides[2] = {sideAt(outer[0], creases, simulation),
                         sideAt(outer[1], creases, simulation)};
  if (sides[0].angle * sides[1].angle < 0) {
    reject("the creases beside the flap at (", w.x(), ", ", w.y(),
           ") are a mountain and a valley: it cannot be lifted");
  }
  const Vector2 top = meetingOf({flat[sides[0].outer], flat[sides[0].next]},
                                {flat[sides[1].outer], flat[sides[1].next]});
  const double angle = std::copysign(manner.angle, sides[0].angle);
  FoldPhase phase;
  Vector2 hinge[2];
  for (int k = 0; k < 2; ++k) {
    const Vector2& b = flat[sides[k].outer];
    const Vector2 mirror = mirrored(w, {b, top});
    // Where the bisector of the flap's half at its tip meets its side.
    const double part = (w - b).norm() / ((w - b).norm() + (w - top).norm());
    hinge[k] = b + part * (top - b);
    for (const Vector2& p : {mirror, hinge[k]}) {
      if (sheet.triangulation().locate(p, 1e-6 * sheet.size())) continue;
      reject("the petal's crease to (", p.x(), ", ", p.y(), ") leaves the paper");
    }
    phase.folds.push_back(lineFold({w, hinge[k]}, angle, manner.duration));
    phase.folds.push_back(lineFold({mirror, hinge[k]}, angle, manner.duration));
    phase.folds.push_back(lineFold({hinge[k], b}, 0, manner.duration));
  }
  phase.folds.push_back(lineFold({hinge[0], hinge[1]}, -angle, manner.duration));
  // The flap turns over; what is between its top and its hinge stays.
  const Vector2 stays = (top + hinge[0] + hinge[1]) / 3;
  return {{phase}, phase.folds, viewAt(stays, sheet, viewedPaper(view, simulation))};
}

}  // namespace shell_origami
