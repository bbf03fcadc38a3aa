/// Item 7: flat-foldable vertices of four creases, one driven, the others free.
#include "verify/rigid_origami.h"
#include "verify/topics.h"

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kDuration = 12;  // [s], of a fold to kTarget
constexpr double kTarget = 170 * kDegree;
const std::string kItem = "7 Flat-foldable vertex of four creases";
const std::string kWhy =
    "a free crease has a hundredth of a crease's stiffness and relaxes with a time constant of "
    "0.05 s, meanwhile the panels beside it bend by a part of a degree";

/// Folds crease 0 and calls watch(creases) after every step.
template <class Watch>
Simulation drive(const Degree4Vertex& vertex, Watch&& watch) {
  Simulation simulation(vertex.sheet(), quasiStatic());
  simulation.fold(foldCrease("rho0", kTarget, kDuration));
  while (simulation.time() < kDuration) {
    stepUntil(simulation, simulation.time() + simulation.config().solver.time_step / 2);
    watch(simulation.creases());
  }
  return simulation;
}

void verifyPaths(VerificationReport& report) {
  FigureData figure = report.figure("degree4", {"twisted", "rho0", "rho1", "exact1"});
  for (const bool twisted : {false, true}) {
    const Degree4Vertex vertex{110 * kDegree, 50 * kDegree, twisted};
    double worst = 0;
    drive(vertex, [&](const std::vector<CreaseStatus>& creases) {
      worst = std::max(worst, vertex.error(creases));
      figure.row({static_cast<double>(twisted), creases[0].angle / kDegree,
                  creases[1].angle / kDegree, vertex.angles(creases[0].angle)[1] / kDegree});
    });
    report.add({kItem,
                std::string("sectors 110, 50 degrees, ") +
                    (twisted ? "rho0 = -rho2" : "rho0 = rho2") +
                    ": largest error on the way to 170 degrees [degrees]",
                0, worst / kDegree, 1, kWhy});
  }
}

}  // namespace

void verifyDegree4(VerificationReport& report) {
  verifyPaths(report);
  const int count = report.fast() ? 3 : 50;
  double error = 0, strain = 0;
  for (const Degree4Vertex& vertex : randomDegree4Vertices(count)) {
    const Simulation folded = drive(vertex, [&](const std::vector<CreaseStatus>& creases) {
      error = std::max(error, vertex.error(creases));
    });
    strain = std::max(strain, folded.maxStrain());
  }
  const std::string who = std::to_string(count) + " random vertices: largest ";
  report.add(
      {kItem, who + "error on the way to 170 degrees [degrees]", 0, error / kDegree, 1, kWhy});
  report.add({kItem, who + "strain at 170 degrees", 0, strain, 1e-8,
              "rigid folding stretches nothing. The moment of a free crease, 5e-5 N, over 30 mm of "
              "panel and E t = 2e5 N/m is 1e-8"});
}

}  // namespace shell_origami
