#include <shell_origami/energy/curvature.h>

#include <shell_origami/energy/dihedral.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

/// Low enough for fold angles to be as linear in the heights as their gradients say.
constexpr double kSmallCurvature = 1e-3;  // [1/m]

/// The angles by which edges that are no creases bend on a surface of second order.
std::vector<double> anglesOn(const Sheet& sheet, const Curvature& curvature) {
  const auto place = [&](int v) {
    const Vector2& p = sheet.flatPositions()[v];
    const double height = curvature[0] / 2 * p.x() * p.x() +
                          curvature[1] / std::sqrt(2.0) * p.x() * p.y() +
                          curvature[2] / 2 * p.y() * p.y();
    return Vector3(p.x(), p.y(), height);
  };
  std::vector<double> angles;
  for (const Edge& edge : sheet.edges()) {
    if (edge.onBorder() || edge.crease >= 0) continue;
    angles.push_back(foldAngle({place(edge.vertices[0]), place(edge.vertices[1]),
                                place(edge.opposite[0]), place(edge.opposite[1])})
                         .radians);
  }
  return angles;
}

/// A cylinder that bends along a direction [rad], and a saddle.
std::vector<Curvature> surfaces() {
  std::vector<Curvature> all{kSmallCurvature * Curvature(1, 0, -1)};
  for (double direction = 0; direction < M_PI; direction += M_PI / 7) {
    const double c = std::cos(direction), s = std::sin(direction);
    all.push_back(kSmallCurvature * Curvature(c * c, std::sqrt(2.0) * c * s, s * s));
  }
  return all;
}

/// By triangles, the distance of the fitted curvature from that of the surface, over the latter.
struct Errors {
  double mean = 0, worst = 0;
};

Errors errorsOn(const Sheet& sheet, const Curvature& surface) {
  const auto curvatures = CurvatureFit(sheet).curvatures(anglesOn(sheet, surface));
  Errors errors;
  for (const Curvature& curvature : curvatures) {
    const double error = (curvature - surface).norm() / surface.norm();
    errors.mean += error / static_cast<double>(curvatures.size());
    errors.worst = std::max(errors.worst, error);
  }
  return errors;
}

// What keeps the fit regular, a thousandth of an edge's say, pulls each curvature towards zero:
// beside the border by more, where fewer edges say something.
TEST(Curvature, ItIsThatOfTheSurfaceInEveryDirection) {
  for (const Curvature& surface : surfaces()) {
    const Errors errors = errorsOn(Sheet(triangulateRectangle(0.1, 0.06, 0.01)), surface);
    EXPECT_LT(errors.mean, 2e-3);
    EXPECT_LT(errors.worst, 0.02);
  }
}

// A triangle in a corner between a crease and the border knows too little, and says less than the
// truth.
TEST(Curvature, BesideACreaseTheNeighborsSayIt) {
  Sheet sheet(triangulateRectangle(0.1, 0.06, 0.01));
  makeFoldLine(sheet, {Vector2(0.013, 0), Vector2(0.08, 0.06)});
  for (const Curvature& surface : surfaces()) {
    const Errors errors = errorsOn(sheet, surface);
    EXPECT_LT(errors.mean, 0.02);
    EXPECT_LT(errors.worst, 1);
  }
}

TEST(Curvature, TheLargestPrincipalOneKeepsItsSign) {
  EXPECT_DOUBLE_EQ(largestPrincipal({1, 0, 3}), 3);
  EXPECT_DOUBLE_EQ(largestPrincipal({-4, 0, 3}), -4);
  // (1 2; 2 1) has the values 3 and -1.
  EXPECT_DOUBLE_EQ(largestPrincipal({1, 2 * std::sqrt(2.0), 1}), 3);
}

}  // namespace
}  // namespace shell_origami
