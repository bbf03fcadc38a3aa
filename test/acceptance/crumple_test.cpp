/// Paper that is driven against itself without a plan: it never passes through itself.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/simulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;

// Six vertices are carried in two seconds from their places on the flat sheet to places at random
// around its middle, nearer to each other by more than half: paper is crumpled, and hardly has to
// stretch.
TEST(Crumple, NothingPassesThroughPaper) {
  constexpr int kCarried = 6, kSteps = 120;
  SimulationConfig config;
  config.gravity = {0, 0, -9.81};
  Simulation simulation(Sheet(triangulateRectangle(kSide, kSide, 0.015)), config);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> within(-0.1 * kSide, 0.1 * kSide);
  std::vector<Vector3> from, to;
  for (int i = 0; i < kCarried; ++i) {
    const int v = i * simulation.sheet().vertexCount() / kCarried;
    from.emplace_back(simulation.positions().col(v));
    const Vector3 offset(within(random), within(random), within(random));
    const Vector3 middle(kSide / 2, kSide / 2, 0);
    to.emplace_back(middle + Vector3(0, 0, 0.03) + 0.4 * (from.back() - middle) + offset);
    simulation.pin(std::vector<std::int64_t>{v}, std::to_string(i),
                   {from.back(), Eigen::Quaterniond::Identity()});
  }
  std::size_t most = 0;
  for (int step = 1; step <= kSteps; ++step) {
    const double part = 0.5 - 0.5 * std::cos(M_PI * step / kSteps);
    for (int i = 0; i < kCarried; ++i) {
      simulation.carry(std::to_string(i),
                       {from[i] + part * (to[i] - from[i]), Eigen::Quaterniond::Identity()});
    }
    const StepReport report = simulation.step();
    ASSERT_TRUE(report.converged) << report.failure;
    most = std::max(most, simulation.contacts().size());
    ASSERT_EQ(crossingSentence(simulation), "") << simulation.time() << " s";
    ASSERT_TRUE(std::isfinite(simulation.energies().strain()));
  }
  EXPECT_GT(most, 3u) << "it hardly touched itself";
}

}  // namespace
}  // namespace shell_origami
