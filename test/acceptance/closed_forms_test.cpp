/// The closed forms themselves, where tables or limits of them are known.
#include "verify/clamped_sheet.h"
#include "verify/elastica.h"
#include "verify/rigid_origami.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

TEST(ClosedForms, HeavyElasticaOfTheTables) {
  struct {
    double gamma, drop, reach;
  } table[]{{1, .12347, .99125}, {5, .49591, .84666}, {10, .70020, .65635}, {20, .82988, .44523}};
  for (const auto& row : table) {
    const Vector2 tip = heavyElastica(row.gamma).back();
    EXPECT_NEAR(-tip.y(), row.drop, 6e-6);
    EXPECT_NEAR(tip.x(), row.reach, 6e-6);
  }
  EXPECT_NEAR(-heavyElastica(1e-3).back().y() / 1e-3, 1 / 8.0, 1e-6);
}

TEST(ClosedForms, ElasticaOverAnEdgeOfSmallDeflections) {
  // Euler's beam y'''' = -gamma. Where it lies flat again, y = y' = y'' = 0.
  const double gamma = 1e-3, lift = std::sqrt(2), slope = lift / 12;
  const EdgeElastica strip = elasticaOverEdge(gamma);
  // Terms of the next order are gamma^2 of the first.
  EXPECT_NEAR(strip.lift, lift, 1e-5);
  EXPECT_NEAR(strip.slope / gamma, slope, 1e-6);
  EXPECT_NEAR(-strip.hanging.back().y() / gamma, slope + 1 / 8.0, 1e-6);
  // Behind the edge y = gamma x^3 (lift - x) / 24 from there on.
  EXPECT_NEAR(strip.bulge / gamma, std::pow(lift, 4) * 27 / 256 / 24, 1e-6);
}

TEST(ClosedForms, Degree4AnglesCloseAroundTheVertex) {
  // Turned about each crease in turn, the sheet comes back to where it was.
  for (const Degree4Vertex& vertex : randomDegree4Vertices(10)) {
    for (const double rho0 : {0.5, 2.0}) {
      const auto angles = vertex.angles(rho0);
      const double directions[]{0, vertex.a, vertex.a + vertex.b, M_PI + vertex.b};
      Eigen::Matrix3d around = Eigen::Matrix3d::Identity();
      for (int k = 0; k < 4; ++k) {
        const Vector3 crease(std::cos(directions[k]), std::sin(directions[k]), 0);
        around = around * Eigen::AngleAxisd(angles[k], crease);
      }
      EXPECT_LT((around - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    }
  }
}

TEST(ClosedForms, MiuraIsFlatUnfoldedAndNarrowFolded) {
  const Miura flat{0.02, 0.03, 1, 1e-6}, shut{0.02, 0.03, 1, M_PI / 2 - 1e-6};
  EXPECT_NEAR(flat.length(), 0.02, 1e-9);
  EXPECT_NEAR(flat.width(), 0.03 * std::sin(1.0), 1e-9);
  EXPECT_NEAR(shut.length(), 0.02 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(shut.width(), 0, 1e-6);
  // Strain along the rows over that across them.
  const double g = 0.7, dg = 1e-5;
  const Miura before{1, 1, 1, g - dg}, after{1, 1, 1, g + dg};
  const double ratio =
      -std::log(after.length() / before.length()) / std::log(after.width() / before.width());
  EXPECT_NEAR(ratio, Miura({1, 1, 1, g}).poissonRatio(), 1e-8);
}

}  // namespace
}  // namespace shell_origami
