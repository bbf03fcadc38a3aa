#include "test/fuzz/random_folds.h"

#include <algorithm>

namespace shell_origami {
namespace {

Landmark corner(RandomSheets& random, const Sheet& sheet) {
  return {CornerNear{random.point(sheet)}};
}

/// On an edge of the paper, or between any two corners; half of the times at a quarter of the way.
Landmark between(RandomSheets& random, const Sheet& sheet) {
  const double part = random.below(2) ? 0.25 * (1 + random.below(3)) : random.between(0, 1);
  return {PartOfWay{{corner(random, sheet), corner(random, sheet)}, part}};
}

Landmark anyLandmark(RandomSheets& random, const Sheet& sheet) {
  switch (random.below(6)) {
    case 0: return {random.point(sheet)};
    case 1: {
      const std::vector<int> features = featuresOf(sheet);
      const int which = random.below(static_cast<int>(features.size()));
      return {sheet.flatPositions()[features[which]]};
    }
    case 2: {
      LinesMeet lines;
      for (int i = 0; i < 4; ++i) lines.ends.push_back(between(random, sheet));
      return {lines};
    }
    case 3: return between(random, sheet);
    default: return corner(random, sheet);
  }
}

FoldAxiom randomAxiom(RandomSheets& random, const Sheet& sheet) {
  const auto any = [&] { return anyLandmark(random, sheet); };
  // Braces evaluate in order.
  switch (random.below(4)) {
    case 0: return BringPoint{any(), any()};
    case 1: return BringEdge{{any(), any()}, {any(), any()}};
    case 2: return FoldAcross{{any(), any()}, any(), any()};
    default: return FoldAlong{{any(), any()}, any()};
  }
}

}  // namespace

FoldThrough randomFoldThrough(RandomSheets& random, const Sheet& sheet) {
  FoldThrough fold;
  fold.axiom = randomAxiom(random, sheet);
  switch (random.below(4)) {
    case 0:
      fold.layers = FoldLayers::kTop;
      fold.count = 1 + random.below(3);
      break;
    case 1:
      fold.layers = FoldLayers::kFlap;
      fold.flap = anyLandmark(random, sheet);
      break;
    default: break;
  }
  fold.behind = random.below(2) == 0;
  if (random.below(4) == 0) fold.angle = random.between(30, 170) * M_PI / 180;
  fold.duration = random.between(0.5, 1);
  return fold;
}

}  // namespace shell_origami
