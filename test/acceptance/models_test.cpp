/// The recipes, those of Discrete Shells Origami, section 4, first: each comes to rest, with every
/// crease whose folds are compatible at its target, and the paper whole.
#include <shell_origami/origami/recipe.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <cstring>
#include <set>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;

struct Model {
  const char* name;
  /// Creases whose targets the kinematics of rigid panels cannot meet: two creases alone
  /// at an inner vertex (apple), panels between curved creases, which have to bend (curved_crease).
  std::set<std::string> incompatible;
};

class ModelTest : public testing::TestWithParam<Model> {
 protected:
  /// Folds the recipe to its end and watches the paper on the way.
  static Simulation fold(const std::string& name) {
    RecipeRunner runner(loadRecipe("../recipes/" + name + ".yaml"));
    Simulation simulation = makeSimulation(runner.recipe().sheet, runner.recipe().config);
    while (runner.update(simulation)) {
      const StepReport report = simulation.step();
      EXPECT_TRUE(report.converged) << report.failure;
      if (!report.converged) break;
      EXPECT_TRUE(simulation.positions().allFinite());
      if (simulation.counters().steps % 10 == 0) {
        EXPECT_TRUE(simulation.crossings().empty()) << "at " << simulation.time() << " s";
      }
      EXPECT_LT(simulation.maxStrain(), 0.01) << "at " << simulation.time() << " s";
    }
    EXPECT_TRUE(runner.finished());
    return simulation;
  }
};

TEST_P(ModelTest, SettlesWithItsCreasesAtTheirTargets) {
  const Simulation simulation = fold(GetParam().name);
  simulation.sheet().validate();
  EXPECT_TRUE(simulation.settled());
  ASSERT_FALSE(simulation.creases().empty());
  int compatible = 0;
  for (const CreaseStatus& crease : simulation.creases()) {
    if (!crease.driven) continue;
    if (GetParam().incompatible.count(crease.name)) {
      // Still folded to the asked side, by more than three quarters.
      EXPECT_GT(crease.angle / crease.target_angle, 0.75) << crease.name;
      continue;
    }
    ++compatible;
    EXPECT_NEAR(crease.angle / kDegree, crease.target_angle / kDegree, 3) << crease.name;
  }
  EXPECT_GE(compatible + static_cast<int>(GetParam().incompatible.size()), 2);
}

TEST_P(ModelTest, NoTriangleIsInvertedOrStretched) {
  // In space a triangle has no orientation of its own: its area must be that of the flat one, and
  // no hinge of the sheet, other than a crease, may be bent to a half turn.
  const Simulation simulation = fold(GetParam().name);
  const Shell shell(simulation.sheet(), simulation.config().material);
  for (const Triangle& t : simulation.sheet().triangles()) {
    const auto& flat = simulation.sheet().flatPositions();
    const auto& x = simulation.positions();
    const double area =
        Vector3(x.col(t[1]) - x.col(t[0])).cross(Vector3(x.col(t[2]) - x.col(t[0]))).norm();
    EXPECT_NEAR(area / doubleArea(flat[t[0]], flat[t[1]], flat[t[2]]), 1, 0.02);
  }
  for (std::size_t j = 0; j < shell.hinges().size(); ++j) {
    if (shell.hinges()[j].crease >= 0) continue;
    EXPECT_LT(std::abs(shell.foldAngle(static_cast<int>(j), simulation.positions())),
              120 * kDegree);
  }
}

TEST_P(ModelTest, TheSameRecipeTwiceGivesTheSameBits) {
  const Simulation a = fold(GetParam().name), b = fold(GetParam().name);
  ASSERT_EQ(a.positions().cols(), b.positions().cols());
  EXPECT_EQ(a.counters().steps, b.counters().steps);
  EXPECT_EQ(a.counters().newton_iterations, b.counters().newton_iterations);
  EXPECT_EQ(std::memcmp(a.positions().data(), b.positions().data(),
                        a.positions().size() * sizeof(double)),
            0);
}

INSTANTIATE_TEST_SUITE_P(Models, ModelTest,
                         testing::Values(Model{"dog", {}}, Model{"elephant", {}},
                                         Model{"apple", {"stem_mountain", "stem_valley"}},
                                         Model{"curl", {}}, Model{"miura", {}},
                                         Model{"miura_1000", {}}, Model{"waterbomb", {}},
                                         Model{"preliminary", {}}, Model{"house", {}},
                                         Model{"curved_crease", {"inner", "outer"}}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace shell_origami
