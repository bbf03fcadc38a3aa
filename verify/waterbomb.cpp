/// Item 9: the waterbomb base, whose mountains follow its valleys.
#include "verify/rigid_origami.h"
#include "verify/topics.h"

#include <algorithm>
#include <cmath>

namespace shell_origami {

void verifyWaterbomb(VerificationReport& report) {
  FigureData figure = report.figure("waterbomb", {"valley", "mountain", "exact"});
  Simulation simulation = fromRecipe("waterbomb");
  const double by = report.fast() ? 55 : 15;
  double worst = 0;
  for (double degrees = by; degrees <= 165; degrees += by) {
    foldAndRest(simulation, {{"diagonal", 1}}, degrees * kDegree);
    const double exact = waterbombMountain(degrees * kDegree);
    for (const CreaseStatus& crease : simulation.creases()) {
      const bool valley = crease.name == "diagonal";
      const double expected = valley ? degrees * kDegree : exact;
      worst = std::max(worst, std::abs(crease.angle - expected) / kDegree);
      if (!valley) figure.row({degrees, crease.angle / kDegree, exact / kDegree});
    }
  }
  report.add(
      {"9 Waterbomb base", "largest error of a fold angle, 15 to 165 degrees [degrees]", 0, worst,
       0.05,
       "rigid folding; two seconds after a fold the paper still swings by some hundredths of a "
       "degree, most near 180 degrees"});
}

}  // namespace shell_origami
