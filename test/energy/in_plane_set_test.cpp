#include <shell_origami/energy/in_plane_set.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

/// A sheet stretched along x by 1 %.
struct Stretched {
  Sheet sheet{triangulateRectangle(0.1, 0.1, 0.02)};
  Shell shell{sheet, {}};
  RestState state = shell.restState();
  InPlaneSet set{sheet};
  Positions x = Positions::Zero(3, sheet.vertexCount());

  Stretched() {
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      x(0, v) = 1.01 * sheet.flatPositions()[v].x();
      x(1, v) = sheet.flatPositions()[v].y();
    }
  }
};

constexpr double kStrain = (1.01 * 1.01 - 1) / 2;

TEST(InPlaneSet, WhatIsBeyondYieldBecomesSet) {
  Stretched paper;
  const double yield = 0.004;
  paper.set.flow(yield, paper.sheet, paper.x, paper.shell, paper.state);
  for (const GreenStrain& strain : paper.set.strains()) {
    EXPECT_NEAR(strain[0], kStrain - yield, 1e-13);
    EXPECT_NEAR(strain[1], 0, 1e-13);
    EXPECT_NEAR(strain[2], 0, 1e-13);
  }
  // A second time nothing is left to flow.
  const std::vector<GreenStrain> once = paper.set.strains();
  paper.set.flow(yield, paper.sheet, paper.x, paper.shell, paper.state);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_LT((paper.set.strains()[i] - once[i]).norm(), 1e-15);
  }
}

TEST(InPlaneSet, WhatIsNoLongerNeededGoesAgain) {
  Stretched paper;
  const double yield = 0.004, half = (1.005 * 1.005 - 1) / 2;
  paper.set.flow(yield, paper.sheet, paper.x, paper.shell, paper.state);
  paper.x.row(0) *= 1.005 / 1.01;
  paper.set.flow(yield, paper.sheet, paper.x, paper.shell, paper.state);
  for (const GreenStrain& strain : paper.set.strains()) EXPECT_NEAR(strain[0], half - yield, 1e-13);
  paper.x.row(0) /= 1.005;
  paper.set.flow(yield, paper.sheet, paper.x, paper.shell, paper.state);
  for (const GreenStrain& strain : paper.set.strains()) EXPECT_EQ(strain.norm(), 0);
  EXPECT_LT(paper.shell.membraneEnergy(paper.x, paper.state), 1e-25) << "flat and at rest";
}

TEST(InPlaneSet, FlowKeepsTheForcesOfWhatSoftPaperBears) {
  // Paper a hundred times softer at 1 % bears as much as true paper at 0.01 %. Where it is set so
  // that true paper would yield there, it holds the same shape with the same forces.
  Stretched paper;
  Positions soft = Positions::Zero(3, paper.x.cols());
  std::fill(paper.state.membrane.begin(), paper.state.membrane.end(), 0.01);
  std::vector<FoldAngle> angles(paper.shell.hinges().size());
  std::vector<HingeGradient> turns;
  paper.shell.angleGradients(paper.x, turns);
  paper.shell.addGradient(paper.x, paper.state, angles, turns, soft);

  const double borne = 0.01 * kStrain;
  std::fill(paper.state.membrane.begin(), paper.state.membrane.end(), 1);
  paper.set.flow(borne, paper.sheet, paper.x, paper.shell, paper.state);
  Positions hard = Positions::Zero(3, paper.x.cols());
  paper.shell.addGradient(paper.x, paper.state, angles, turns, hard);
  EXPECT_GT(soft.norm(), 0.1);
  EXPECT_LT((hard - soft).norm(), 1e-10 * soft.norm());
}

TEST(InPlaneSet, WhatStaysBelowYieldIsElastic) {
  Stretched paper;
  std::fill(paper.state.membrane.begin(), paper.state.membrane.end(), 0.1);
  paper.set.flow(0.11 * kStrain, paper.sheet, paper.x, paper.shell, paper.state);
  for (const GreenStrain& strain : paper.set.strains()) EXPECT_EQ(strain.norm(), 0);
}

TEST(InPlaneSet, ItsSizeIsTheChangeOfLengths) {
  Stretched paper;
  paper.set.flow(0, paper.sheet, paper.x, paper.shell, paper.state);
  EXPECT_NEAR(paper.set.size(paper.sheet).mean, 0.01, 1e-12);
  EXPECT_NEAR(paper.set.size(paper.sheet).worst, 0.01, 1e-12);
  EXPECT_LT(paper.shell.membraneEnergy(paper.x, paper.state), 1e-25);
}

TEST(InPlaneSet, SurvivesEdgeMaking) {
  Stretched paper;
  paper.set.flow(0, paper.sheet, paper.x, paper.shell, paper.state);
  const Remap remap = makeFoldLine(paper.sheet, {Vector2(0.02, 0), Vector2(0.07, 0.1)}, "",
                                   EditContext{&paper.x, {}})
                          .remap;
  paper.set.follow(remap);
  const Shell shell(paper.sheet, {});
  RestState state = shell.restState();
  paper.set.apply(shell, state);
  const Positions x = remap.apply(paper.x, paper.sheet.vertexCount());
  EXPECT_FALSE(remap.changed.empty());
  EXPECT_LT(shell.membraneEnergy(x, state), 1e-25);
}

}  // namespace
}  // namespace shell_origami
