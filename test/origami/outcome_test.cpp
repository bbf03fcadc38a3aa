#include <shell_origami/origami/outcome.h>

#include <shell_origami/mesh/triangulate.h>

#include "verify/rigid_origami.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

/// Folds the creases rho0, rho1, ... around vertex 0 of a disc by these angles [degrees].
Simulation foldedVertex(const std::vector<double>& directions, const std::vector<double>& degrees) {
  Simulation simulation(vertexSheet(directions, degrees, 0.03, 0.02), quasiStatic());
  std::vector<std::pair<std::string, double>> creases;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    creases.emplace_back("rho" + std::to_string(i), degrees[i] / 170);
  }
  foldAndRest(simulation, creases, 170 * kDegree);
  return simulation;
}

TEST(Outcome, CreasesThatArriveAreNotMissed) {
  const Simulation simulation = foldedVertex({0, M_PI / 2, M_PI, 3 * M_PI / 2}, {2, 170, 2, 170});
  EXPECT_TRUE(missedCreases(simulation).empty());
  EXPECT_EQ(missedSentence({}), "");
}

TEST(Outcome, NamesMaekawasVertex) {
  // Four mountains and no valley.
  const Simulation simulation =
      foldedVertex({0, M_PI / 2, M_PI, 3 * M_PI / 2}, {-170, -170, -170, -170});
  const std::vector<MissedCrease> missed = missedCreases(simulation);
  ASSERT_FALSE(missed.empty());
  EXPECT_NE(missed[0].why.find("0 valleys and 4 mountains"), std::string::npos) << missed[0].why;
  EXPECT_NE(missed[0].why.find("vertex 0 at (0, 0)"), std::string::npos) << missed[0].why;
  EXPECT_GT(std::abs(missed[0].angle - missed[0].target), kMissedBy);
}

TEST(Outcome, NamesKawasakisVertex) {
  const Simulation simulation = foldedVertex({0, 1, 2, 4.5}, {170, 170, 170, -170});
  const std::vector<MissedCrease> missed = missedCreases(simulation);
  ASSERT_FALSE(missed.empty());
  EXPECT_NE(missedSentence(missed).find("(Kawasaki)"), std::string::npos) << missed[0].why;
}

TEST(Outcome, NamesPanelsThatDoNotClose) {
  const Simulation simulation = foldedVertex({0, M_PI / 2, M_PI, 3 * M_PI / 2}, {90, 90, 90, 90});
  const std::vector<MissedCrease> missed = missedCreases(simulation);
  ASSERT_FALSE(missed.empty());
  EXPECT_NE(missed[0].why.find("is open"), std::string::npos) << missed[0].why;
}

TEST(Outcome, SaysNothingOfPaperThatIsAsAskedFor) {
  EXPECT_TRUE(shortfalls(foldedVertex({0, M_PI / 2, M_PI, 3 * M_PI / 2}, {0, 90, 0, 90})).empty());
}

TEST(Outcome, TellsBentPanelsAndStretchedPaper) {
  Simulation simulation = foldedVertex({0, M_PI / 2, M_PI, 3 * M_PI / 2}, {0, 90, 0, 90});
  const Sheet& sheet = simulation.sheet();
  Positions bent = simulation.positions();
  // The panel's corner farthest from creases, up by a third of the disc's radius.
  const int corner = sheet.nearestVertex(Vector2(0.021, 0.021));
  bent(2, corner) += 0.01;
  SimulationConfig config = simulation.config();
  config.contact.enabled = false;
  const double right = 90 * kDegree;
  const Simulation after(sheet, config, bent, {0, right, 0, right});
  EXPECT_NE(bentSentence(after).find("a panel is bent by"), std::string::npos);
  EXPECT_NE(stretchedSentence(after).find("further than paper bears"), std::string::npos);
  EXPECT_GE(shortfalls(after).size(), 2u);
  // Where panels cannot close they must bend.
  const Simulation open(sheet, config, bent, {right, right, right, right});
  EXPECT_EQ(bentSentence(open), "");
}

}  // namespace
}  // namespace shell_origami
