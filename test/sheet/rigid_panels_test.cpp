#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>
#include <shell_origami/sheet/rigid_panels.h>

#include "verify/rigid_origami.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

TEST(RigidPanels, AValleyRisesAndAMountainSinks) {
  Sheet sheet(triangulateRectangle(0.1, 0.1, 0.03));
  makeFoldLine(sheet, {Vector2(0.05, 0), Vector2(0.05, 0.1)});
  for (const double angle : {M_PI / 2, -M_PI / 2}) {
    const Positions folded = foldRigidly(sheet, {angle});
    // Seen from the half that stays, the other one stands upright at the side of the angle.
    double highest = 0, lowest = 0;
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      highest = std::max(highest, folded(2, v));
      lowest = std::min(lowest, folded(2, v));
    }
    EXPECT_NEAR(angle > 0 ? highest : -lowest, 0.05, 1e-15);
    EXPECT_NEAR(angle > 0 ? lowest : highest, 0, 1e-15);
  }
}

TEST(RigidPanels, CloseAtTheAnglesOfAVertexOfFour) {
  for (const Degree4Vertex& vertex : randomDegree4Vertices(20)) {
    const Sheet sheet = vertex.sheet();
    const auto angles = vertex.angles(1);
    std::vector<double> given(angles.begin(), angles.end());
    EXPECT_LT(closingError(sheet, 0, given), 1e-14);
    given[0] += 0.1;
    EXPECT_GT(closingError(sheet, 0, given), 0.02);
  }
}

TEST(RigidPanels, EdgesKeepTheirLengthsWherePanelsClose) {
  const Degree4Vertex vertex{1.1, 0.8, false};
  const Sheet sheet = vertex.sheet();
  const auto angles = vertex.angles(2);
  const Positions folded = foldRigidly(sheet, {angles.begin(), angles.end()});
  for (const Edge& edge : sheet.edges()) {
    const auto [a, b] = edge.vertices;
    EXPECT_NEAR((folded.col(a) - folded.col(b)).norm(),
                (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm(), 1e-16);
  }
}

TEST(RigidPanels, KawasakiHoldsWhereAVertexFoldsFlat) {
  const Sheet flat = Degree4Vertex{1.1, 0.8, false}.sheet();
  EXPECT_LT(kawasakiError(flat, 0), 1e-14);
  const Sheet other = vertexSheet({0, 1, 2, 4.5}, {1, 1, 1, -1}, 0.03, 0.02);
  EXPECT_NEAR(kawasakiError(other, 0), std::abs(1 + 2.5 - M_PI), 1e-14);
  const Sheet odd = vertexSheet({0, 2, 4}, {1, 1, 1}, 0.03, 0.02);
  EXPECT_TRUE(std::isnan(kawasakiError(odd, 0)));
}

TEST(RigidPanels, OnlyVerticesInsideThePaperCount) {
  EXPECT_EQ(innerCreaseVertices(Degree4Vertex{1.1, 0.8, false}.sheet()).front(), 0);
  Sheet line(triangulateRectangle(0.1, 0.1, 0.2));
  makeFoldLine(line, {Vector2(0, 0), Vector2(0.1, 0.1)});
  for (int v : innerCreaseVertices(line)) EXPECT_FALSE(line.triangulation().onBorder(v));
}

}  // namespace
}  // namespace shell_origami
