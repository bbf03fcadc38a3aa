/// Several threads give the same paper as one, to the bit.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kSide = 0.15;
constexpr double kDegree = M_PI / 180;

/// Four pleats, pressed together, in paper that yields.
Simulation pleats(int threads) {
  SimulationConfig config;
  config.solver.threads = threads;
  config.material.yield_curvature = 200;
  Simulation simulation(Sheet(triangulateRectangle(kSide, kSide, 0.01)), config);
  double angle = 179;
  for (const double x : {0.029, 0.061, 0.091, 0.119}) {
    FoldEdit edit;
    edit.where = Segment{Vector2(x, 0), Vector2(x, kSide)};
    edit.angle = angle * kDegree;
    edit.duration = 0.4;
    simulation.fold(edit);
    angle = -angle;
  }
  return simulation;
}

TEST(Threads, AnyNumberGivesTheSameBits) {
  std::vector<Simulation> simulations;
  for (const int threads : {1, 2, 3}) simulations.push_back(pleats(threads));
  std::size_t contacts = 0;
  for (int i = 0; i < 40; ++i) {
    for (Simulation& simulation : simulations) {
      const StepReport report = simulation.step();
      ASSERT_TRUE(report.converged) << report.failure;
    }
    const Simulation& one = simulations.front();
    contacts = std::max(contacts, one.contacts().size());
    for (const Simulation& simulation : simulations) {
      ASSERT_EQ(simulation.positions(), one.positions()) << i;
      ASSERT_EQ(simulation.velocities(), one.velocities()) << i;
      ASSERT_EQ(simulation.counters().newton_iterations, one.counters().newton_iterations) << i;
    }
  }
  EXPECT_GT(contacts, 100u) << "the scene tests nothing";
  for (Simulation& simulation : simulations) {
    simulation.settle();
    EXPECT_EQ(simulation.positions(), simulations.front().positions());
  }
}

}  // namespace
}  // namespace shell_origami
