#include <shell_origami/energy/shell_potential.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <random>

namespace shell_origami {
namespace {

constexpr double kSide = 0.1;

struct Paper {
  Sheet sheet{triangulateRectangle(kSide, kSide, 0.02)};
  Positions flat;

  Paper() {
    makeFoldLine(sheet, {Vector2(0, 0.05), Vector2(kSide, 0.05)});
    flat = Positions::Zero(3, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      flat.col(v).head<2>() = sheet.flatPositions()[v];
    }
  }
};

Positions rolled(const Positions& flat, double curvature, double direction) {
  const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
  const Eigen::Vector2d across(-along.y(), along.x());
  Positions x = flat;
  for (Eigen::Index v = 0; v < flat.cols(); ++v) {
    const double s = along.dot(flat.col(v).head<2>()), t = across.dot(flat.col(v).head<2>());
    x.col(v).head<2>() = std::sin(curvature * s) / curvature * along + t * across;
    x(2, v) = (1 - std::cos(curvature * s)) / curvature;
  }
  return x;
}

/// The potential's value at `to`, reached from `from`.
double valueNear(const Potential& potential, const Positions& from, const Positions& to) {
  const auto start = potential.makeIterate(), end = potential.makeIterate();
  potential.start(from, *start);
  return potential.value(to, *start, *end);
}

TEST(Shell, MassIsThatOfTheSheet) {
  const Paper paper;
  const Shell shell(paper.sheet, {});
  EXPECT_NEAR(shell.masses().sum(), 800 * 1e-4 * kSide * kSide, 1e-15);
  EXPECT_GT(shell.masses().minCoeff(), 0);
}

TEST(Shell, GradientAndHessianMatchFiniteDifferences) {
  const Paper paper;
  ShellPotential potential(paper.sheet, {}, {0.3, -1, -9.81});
  const Shell& shell = potential.shell();
  shell.setCrease(0, 1.2, 5e-3, potential.rest);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 2e-4);
  Positions x = rolled(paper.flat, 8, 0.4);
  x = x.unaryExpr([&](double value) { return value + noise(random); });
  Positions gradient = Positions::Zero(3, x.cols());
  potential.addGradient(x, gradient);
  Positions direction =
      Positions::Zero(3, x.cols()).unaryExpr([&](double) { return noise(random); });
  direction.normalize();

  const double h = 1e-7;
  const double numeric =
      (valueNear(potential, x, x + h * direction) - valueNear(potential, x, x - h * direction)) /
      (2 * h);
  EXPECT_NEAR(gradient.cwiseProduct(direction).sum() / numeric, 1, 1e-6);

  // H d by the element blocks against the difference of gradients.
  Positions product = Positions::Zero(3, x.cols());
  const int triangle_count = static_cast<int>(shell.triangles().size());
  shell.forEachExactHessian(x, potential.rest, [&](int stencil, const auto& block) {
    const int* corners = stencil < triangle_count
                             ? shell.triangles()[stencil].data()
                             : shell.hinges()[stencil - triangle_count].vertices.data();
    const int count = static_cast<int>(block.rows()) / 3;
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        product.col(corners[i]) +=
            block.template block<3, 3>(3 * i, 3 * j) * direction.col(corners[j]);
      }
    }
  });
  const auto gradientAt = [&](const Positions& at) {
    Positions g = Positions::Zero(3, at.cols());
    potential.addGradient(at, g);
    return g;
  };
  const Positions difference =
      (gradientAt(x + h * direction) - gradientAt(x - h * direction)) / (2 * h);
  EXPECT_LT((product - difference).norm(), 1e-5 * difference.norm());
}

TEST(Shell, RigidMotionsCostNothingAndMakeNoForce) {
  const Paper paper;
  ShellPotential potential(paper.sheet, {}, Vector3::Zero());
  potential.shell().setCrease(0, 0, 5e-3, potential.rest);
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.5, -0.1, 0.7, 0.4).normalized().toRotationMatrix();
  const Positions x = (turn * paper.flat).colwise() + Vector3(0.1, -0.3, 0.2);
  Positions gradient = Positions::Zero(3, x.cols());
  potential.addGradient(x, gradient);
  EXPECT_LT(valueNear(potential, x, x), 1e-20);
  EXPECT_LT(gradient.norm(), 1e-8);
}

class Cylinder : public testing::TestWithParam<double> {};

TEST_P(Cylinder, BendingEnergyIsThePlatesInEveryDirection) {
  // Closed form 5: B/2 kappa^2 per area. The border's hinges are missing half of their area, so
  // that the energy comes short by about the border's share of the hinges.
  const Material material;
  const double kappa = 5;
  const Sheet sheet(triangulateRectangle(kSide, kSide, 0.004));
  Positions flat = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) flat.col(v).head<2>() = sheet.flatPositions()[v];
  const Shell shell(sheet, material);
  const double plate = material.bendingStiffness() / 2 * kappa * kappa * kSide * kSide;
  const double energy = shell.bendingEnergy(rolled(flat, kappa, GetParam()), shell.restState());
  EXPECT_NEAR(energy / plate, 1, 0.04);
}

INSTANTIATE_TEST_SUITE_P(Directions, Cylinder, testing::Values(0, 0.5, 1.0, 1.5, 2.0, 2.5));

TEST(Crease, StiffnessMeansTheSameAtEveryRestAngle) {
  for (const double rest : {0.0, 0.5, 2.0, 2.9, -2.9}) {
    const double d = 1e-6;
    EXPECT_NEAR((creaseBend(rest + d, rest).value - creaseBend(rest - d, rest).value) / (2 * d), 1,
                1e-4);
  }
}

TEST(Crease, BendIsSmoothAndMirrored) {
  const double h = 1e-6;
  for (const double rest : {0.0, 0.7, 2.5}) {
    for (const double theta : {-3.0, -1.0, -1e-3, 0.3, 0.7, 1.8, 2.5, 3.0}) {
      const Bend bend = creaseBend(theta, rest);
      const Bend mirrored = creaseBend(-theta, -rest);
      EXPECT_DOUBLE_EQ(bend.value, -mirrored.value);
      EXPECT_DOUBLE_EQ(bend.first, mirrored.first);
      const double slope =
          (creaseBend(theta + h, rest).value - creaseBend(theta - h, rest).value) / (2 * h);
      EXPECT_NEAR(slope / bend.first, 1, 1e-5);
      // The energy's second derivative.
      const auto torque = [&](double t) {
        const Bend b = creaseBend(t, rest);
        return b.value * b.first;
      };
      const double curvature = (torque(theta + h) - torque(theta - h)) / (2 * h);
      EXPECT_NEAR((bend.first * bend.first + bend.value * bend.second) / curvature, 1, 1e-4);
    }
  }
}

TEST(Crease, OpenedByAMomentFollowsTheClosedForm) {
  // Closed form 6 at rest 0: M = c (phi - phi_rest) sec^2(theta / 2).
  const Paper paper;
  const Shell shell(paper.sheet, {});
  RestState rest = shell.restState();
  shell.setCrease(0, 0, 5e-3, rest);
  const int hinge = shell.creaseHinges()[0][0];
  for (const double theta : {0.1, 1.0, 2.0, 3.0}) {
    const double secant = 1 / std::cos(theta / 2);
    EXPECT_NEAR(
        -shell.moment(hinge, theta, rest) / (5e-3 * 2 * std::tan(theta / 2) * secant * secant), 1,
        1e-12);
  }
}

TEST(Shell, NoStepCarriesAHingeThroughTheHalfTurn) {
  const Paper paper;
  ShellPotential potential(paper.sheet, {}, Vector3::Zero());
  potential.shell().setCrease(0, 0, 5e-3, potential.rest);
  // Folded by 170 degrees along y = 0.05, then pushed through.
  Positions x = paper.flat, step = Positions::Zero(3, paper.flat.cols());
  const double theta = 170 * M_PI / 180;
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const double out = x(1, v) - 0.05;
    if (out <= 0) continue;
    x(1, v) = 0.05 + out * std::cos(theta);
    x(2, v) = out * std::sin(theta);
    step(2, v) = -5 * x(2, v);
  }
  const auto start = potential.makeIterate();
  Positions gradient = Positions::Zero(3, x.cols());
  potential.start(x, *start);
  potential.addGradient(x, *start, gradient);
  EXPECT_TRUE(std::isfinite(valueNear(potential, x, x)));
  EXPECT_FALSE(std::isfinite(valueNear(potential, x, x + step)));
  EXPECT_STREQ(potential.findInfeasibility(x + step, *start)->what, "a hinge would jump");
  const double fraction = potential.maxFeasibleStep(x, *start, step);
  EXPECT_LT(fraction, 0.5);
  EXPECT_TRUE(std::isfinite(valueNear(potential, x, x + fraction * step)));
  EXPECT_FALSE(potential.findInfeasibility(x + fraction * step, *start));
}

/// What a step along an old factor's tangents needs: forces that were not foreseen turn along with
/// the paper.
TEST(Shell, RedirectedForcesPointAlongTheOtherConfiguration) {
  const Paper paper;
  for (const MembraneKind kind :
       {MembraneKind::kStVenantKirchhoff, MembraneKind::kDiscreteShells}) {
    Material material;
    material.membrane = kind;
    const ShellPotential potential(paper.sheet, material, Vector3::Zero());
    const Shell& shell = potential.shell();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3, Vector3(1, 2, -1).normalized()).matrix();
    Positions stretched = paper.flat;
    stretched.row(0) *= 1.01;
    const Positions turned = turn * stretched;
    Positions force = Positions::Zero(3, stretched.cols());
    potential.addGradient(stretched, force);
    ASSERT_GT(force.norm(), 1);

    std::vector<MembraneStrain> none(shell.triangles().size(), MembraneStrain::Zero()), all;
    shell.strains(stretched, all);
    Positions foreseen = force, unchanged = force, redirected = force;
    shell.redirect(stretched, turned, potential.rest, all, foreseen);
    shell.redirect(stretched, stretched, potential.rest, none, unchanged);
    shell.redirect(stretched, turned, potential.rest, none, redirected);
    const double rounding = 1e-12 * force.norm();
    EXPECT_LT((foreseen - force).norm(), rounding);
    EXPECT_LT((unchanged - force).norm(), rounding);
    EXPECT_LT((redirected - turn * force).norm(), rounding);
  }
}

}  // namespace
}  // namespace shell_origami
