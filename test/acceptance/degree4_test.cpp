/// Flat-foldable vertices of four creases against their closed form: sectors a, b, pi - a, pi - b
/// between creases 0..3 leave one degree of freedom and two ways to use it.
#include "verify/folding.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>

namespace shell_origami {
namespace {

constexpr int kVertices = 50;
constexpr double kRadius = 0.03, kMaxEdge = 0.012;  // [m]

struct Vertex {
  double a, b;
  bool twisted;  ///< opposite creases 0 and 2 fold to opposite sides, else 1 and 3

  /// tan(rho1/2) / tan(rho0/2)
  double ratio() const {
    return twisted ? std::sin((a + b) / 2) / std::sin((a - b) / 2)
                   : -std::cos((a + b) / 2) / std::cos((a - b) / 2);
  }
  std::array<double, 4> angles(double rho0) const {
    const double rho1 = 2 * std::atan(ratio() * std::tan(rho0 / 2));
    return {rho0, rho1, twisted ? -rho0 : rho0, twisted ? rho1 : -rho1};
  }
  /// A disc whose pattern asks for this way.
  Sheet sheet() const {
    const auto signs = angles(1);
    return vertexSheet({0, a, a + b, M_PI + b}, {signs.begin(), signs.end()}, kRadius, kMaxEdge);
  }
};

/// Sectors of 35 to 145 degrees, so that triangles fit in. At a = b a twisted vertex's crease 1
/// shuts while crease 0 stays flat, at a + b = 180 degrees an untwisted one's crease 1 stays flat:
/// within 20 degrees of either, the angles hang on a ratio near 0 or infinity.
std::vector<Vertex> randomVertices() {
  std::mt19937 random(4);  // its numbers are the same everywhere, a distribution's are not
  const auto sector = [&random] { return (35 + 110 * (random() / 4294967296.0)) * kDegree; };
  std::vector<Vertex> vertices;
  while (vertices.size() < kVertices) {
    const double a = sector(), b = sector();
    if (std::abs(a - b) < 20 * kDegree || std::abs(a + b - M_PI) < 20 * kDegree) continue;
    vertices.push_back({a, b, vertices.size() % 2 == 1});
  }
  return vertices;
}

/// Largest error of the creases against the closed form of the angle that crease 0 has [rad].
double kinematicError(const Vertex& vertex, const Simulation& simulation) {
  const std::vector<CreaseStatus> creases = simulation.creases();
  const auto angles = vertex.angles(creases[0].angle);
  double error = 0;
  for (int k = 1; k < 4; ++k) error = std::max(error, std::abs(creases[k].angle - angles[k]));
  return error;
}

struct Worst {
  double error = 0, strain = 0;
};

Worst run(const Vertex& vertex, Simulation& simulation, double duration) {
  Worst worst;
  while (simulation.time() < duration) {
    const StepReport report = simulation.step();
    EXPECT_TRUE(report.converged) << report.failure;
    if (!report.converged) break;
    worst.error = std::max(worst.error, kinematicError(vertex, simulation));
    worst.strain = std::max(worst.strain, simulation.maxStrain());
  }
  return worst;
}

TEST(Degree4, FreeCreasesFollowTheOneThatIsDriven) {
  Worst worst;
  for (const Vertex& vertex : randomVertices()) {
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
    const Vertex vertex{110 * kDegree, 40 * kDegree, twisted};
    Simulation simulation(vertex.sheet(), SimulationConfig());
    simulation.fold(foldCrease("rho0", 120 * kDegree, 2));
    run(vertex, simulation, 3);
    EXPECT_LT(kinematicError(vertex, simulation), 0.2 * kDegree) << twisted;
  }
}

TEST(Degree4, ThePatternChoosesTheWayOfAFastFoldToo) {
  for (const Vertex& vertex : randomVertices()) {
    Simulation simulation(vertex.sheet(), SimulationConfig());
    simulation.fold(foldCrease("rho0", 90 * kDegree, 1));
    run(vertex, simulation, 3);
    EXPECT_LT(kinematicError(vertex, simulation), 1 * kDegree)
        << "sectors " << vertex.a / kDegree << ", " << vertex.b / kDegree << " degrees";
  }
}

TEST(Degree4, APatternThatNobodyFoldsStaysFlat) {
  const Vertex vertex{110 * kDegree, 50 * kDegree, false};
  Simulation simulation(vertex.sheet(), SimulationConfig());
  for (int i = 0; i < 30; ++i) simulation.step();
  EXPECT_TRUE(simulation.positions().isApprox(flatInSpace(simulation.sheet()), 1e-12));
}

TEST(Degree4, FoldsOfOneStepKeepInStep) {
  // All four driven, to targets that fit. Ramped each on its own they would not on the way.
  for (const Vertex& vertex : {Vertex{110 * kDegree, 50 * kDegree, false},
                               Vertex{110 * kDegree, 50 * kDegree, true}}) {
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
  const Vertex vertex{110 * kDegree, 50 * kDegree, false};
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
