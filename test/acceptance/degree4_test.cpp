/// Flat-foldable vertices of four creases against their closed form: sectors a, b, pi - a, pi - b
/// between creases 0..3 leave one degree of freedom and two ways to use it.
#include "verify/rigid_origami.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace shell_origami {
namespace {

constexpr int kVertices = 50;

struct Worst {
  double error = 0, strain = 0;
};

Worst run(const Degree4Vertex& vertex, Simulation& simulation, double duration) {
  Worst worst;
  while (simulation.time() < duration) {
    const StepReport report = simulation.step();
    EXPECT_TRUE(report.converged) << report.failure;
    if (!report.converged) break;
    worst.error = std::max(worst.error, vertex.error(simulation.creases()));
    worst.strain = std::max(worst.strain, simulation.maxStrain());
  }
  return worst;
}

TEST(Degree4, FreeCreasesFollowTheOneThatIsDriven) {
  Worst worst;
  for (const Degree4Vertex& vertex : randomDegree4Vertices(kVertices)) {
    constexpr double kDuration = 12;
    Simulation simulation(vertex.sheet(), quasiStatic());
    simulation.fold(foldCrease("rho0", 170 * kDegree, kDuration));
    const Worst here = run(vertex, simulation, kDuration);
    EXPECT_NEAR(simulation.creases()[0].angle / kDegree, 170, 0.5);
    EXPECT_LT(here.error, 1 * kDegree)
        << "sectors " << vertex.a / kDegree << ", " << vertex.b / kDegree << " degrees";
    EXPECT_LT(here.strain, 0.002);
    worst = {std::max(worst.error, here.error), std::max(worst.strain, here.strain)};
  }
  std::printf("%d vertices: off by %.2f degrees at most, strain %.4f %%\n", kVertices,
              worst.error / kDegree, 100 * worst.strain);
}

TEST(Degree4, ThePatternChoosesTheWay) {
  for (const bool twisted : {false, true}) {
    const Degree4Vertex vertex{110 * kDegree, 40 * kDegree, twisted};
    Simulation simulation(vertex.sheet(), SimulationConfig());
    simulation.fold(foldCrease("rho0", 120 * kDegree, 2));
    run(vertex, simulation, 3);
    EXPECT_LT(vertex.error(simulation.creases()), 0.2 * kDegree) << twisted;
  }
}

TEST(Degree4, ThePatternChoosesTheWayOfAFastFoldToo) {
  for (const Degree4Vertex& vertex : randomDegree4Vertices(kVertices)) {
    Simulation simulation(vertex.sheet(), SimulationConfig());
    simulation.fold(foldCrease("rho0", 90 * kDegree, 1));
    run(vertex, simulation, 3);
    EXPECT_LT(vertex.error(simulation.creases()), 1 * kDegree)
        << "sectors " << vertex.a / kDegree << ", " << vertex.b / kDegree << " degrees";
  }
}

TEST(Degree4, APatternThatNobodyFoldsStaysFlat) {
  const Degree4Vertex vertex{110 * kDegree, 50 * kDegree, false};
  Simulation simulation(vertex.sheet(), SimulationConfig());
  for (int i = 0; i < 30; ++i) simulation.step();
  EXPECT_TRUE(simulation.positions().isApprox(flatInSpace(simulation.sheet()), 1e-12));
}

TEST(Degree4, FoldsOfOneStepKeepInStep) {
  // All four driven, to targets that fit. Ramped each on its own they would not on the way.
  for (const Degree4Vertex& vertex : {Degree4Vertex{110 * kDegree, 50 * kDegree, false},
                                      Degree4Vertex{110 * kDegree, 50 * kDegree, true}}) {
    Simulation simulation(vertex.sheet(), quasiStatic());
    const auto targets = vertex.angles(120 * kDegree);
    for (int k = 0; k < 4; ++k) {
      simulation.fold(foldCrease("rho" + std::to_string(k), targets[k], 3));
    }
    const Worst worst = run(vertex, simulation, 4);
    EXPECT_LT(worst.error, 0.5 * kDegree);
    EXPECT_LT(worst.strain, 0.002);
  }
}

TEST(Degree4, TargetsThatDoNotFitCostStrainEnergy) {
  const Degree4Vertex vertex{110 * kDegree, 50 * kDegree, false};
  const auto strainEnergy = [&vertex](double off) {
    Simulation simulation(vertex.sheet(), SimulationConfig());
    auto targets = vertex.angles(120 * kDegree);
    targets[1] += off;
    for (int k = 0; k < 4; ++k) {
      simulation.fold(foldCrease("rho" + std::to_string(k), targets[k], 1));
    }
    while (simulation.time() < 3) simulation.step();
    return simulation.energies().membrane + simulation.energies().bending;
  };
  const double fitting = strainEnergy(0), off = strainEnergy(20 * kDegree);
  EXPECT_LT(fitting, 1e-10);
  EXPECT_GT(off, 1e-7);
}

}  // namespace
}  // namespace shell_origami
