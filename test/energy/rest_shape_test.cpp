#include <shell_origami/energy/rest_shape.h>

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/fold_line.h>

#include <gtest/gtest.h>

#include <cmath>

namespace shell_origami {
namespace {

constexpr double kCurvature = 30;  // [1/m]

/// The sheet rolled up around an axis through the origin.
Positions rolledUp(const Sheet& sheet, double axis) {
  const Vector2 along(std::cos(axis), std::sin(axis)), around(along.y(), -along.x());
  Positions x(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    const double angle = kCurvature * around.dot(p);
    x.col(v).head<2>() = along.dot(p) * along + std::sin(angle) / kCurvature * around;
    x(2, v) = (1 - std::cos(angle)) / kCurvature;
  }
  return x;
}

Sheet paper() { return Sheet(triangulateRectangle(0.1, 0.1, 0.01)); }

double bending(const Sheet& sheet, const RestShape& rest, const Positions& x) {
  const Shell shell(sheet, {});
  RestState state = shell.restState();
  rest.apply(shell, state);
  return shell.bendingEnergy(x, state);
}

TEST(RestShape, ARolledSheetRestsOnItsCylinder) {
  for (const double axis : {0.0, 0.5, 1.5708, 2.5}) {
    const Sheet sheet = paper();
    const RestShape rest({kCurvature, axis}, sheet);
    EXPECT_LT(bending(sheet, rest, rolledUp(sheet, axis)), 1e-20);
    // Flat it has the plate's energy of that curvature, B/2 kappa^2 per area.
    const double plate = Material{}.bendingStiffness() / 2 * kCurvature * kCurvature * 0.01;
    Positions flat = rolledUp(sheet, axis);
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      flat.col(v) << sheet.flatPositions()[v], 0;
    }
    // A fiftieth of the sheet lies beyond the outer hinges.
    EXPECT_NEAR(bending(sheet, rest, flat) / plate, 1, 0.12);
  }
}

TEST(RestShape, ARollSurvivesEdgeMaking) {
  Sheet sheet = paper();
  RestShape rest({kCurvature, 0.5}, sheet);
  const Remap remap = makeFoldLine(sheet, {Vector2(0.013, 0), Vector2(0.08, 0.1)}).remap;
  rest.follow(remap, sheet);
  const Shell shell(sheet, {});
  RestState state = shell.restState();
  rest.apply(shell, state);
  const Positions x = rolledUp(sheet, 0.5);
  for (int j = 0; j < static_cast<int>(shell.hinges().size()); ++j) {
    if (shell.hinges()[j].crease >= 0) continue;
    EXPECT_NEAR(shell.foldAngle(j, x), state.angles[j].radians, 1e-12);
  }
}

/// A sheet bent around an axis of some direction [rad].
struct Bent {
  explicit Bent(double axis = M_PI / 2) : x(rolledUp(sheet, axis)) {}

  void yield(const Material& material) { rest.yield(material, fit, x, shell, state); }

  Sheet sheet = paper();
  RestShape rest{NaturalCurvature{}, sheet};
  CurvatureFit fit{sheet};
  Shell shell{sheet, {}};
  RestState state = shell.restState();
  Positions x;
};

Material soft(double yield_curvature, double hardening) {
  Material material;
  material.yield_curvature = yield_curvature;
  material.hardening = hardening;
  return material;
}

TEST(RestShape, PaperBentFurtherThanItsYieldCurvatureKeepsTheExcessInEveryDirection) {
  constexpr double kYield = 20;
  for (const double axis : {0.0, 0.5, M_PI / 2, 2.5}) {
    for (const double hardening : {0.0, 0.5, -0.3}) {
      Bent bent(axis);
      bent.yield(soft(kYield, hardening));
      const double kept = (kCurvature - kYield) / (1 + hardening) / kCurvature;
      for (std::size_t j = 0; j < bent.shell.hinges().size(); ++j) {
        const double angle = bent.shell.foldAngle(static_cast<int>(j), bent.x);
        // Chords of the cylinder bend by (kappa h)^2 / 24 less than its arcs, 0.3 %; beside the
        // border the fit of the curvature is 2 % off. Both are a part of kappa, of which a third is
        // kept.
        EXPECT_NEAR(bent.state.angles[j].radians, kept * angle,
                    0.025 / (1 + hardening) * std::abs(angle) + 1e-12);
      }
    }
  }
}

TEST(RestShape, HeldWhereItYieldedPaperYieldsNoFurther) {
  Bent bent;
  bent.yield(soft(20, 0.5));
  const RestState before = bent.state;
  bent.yield(soft(20, 0.5));
  for (std::size_t j = 0; j < before.angles.size(); ++j) {
    EXPECT_NEAR(bent.state.angles[j].radians, before.angles[j].radians, 1e-3 * 0.3);
  }
}

TEST(RestShape, PaperBentLessThanItsYieldCurvatureKeepsNothing) {
  for (const Material& material : {Material(), soft(1.1 * kCurvature, 0)}) {
    Bent bent;
    bent.yield(material);
    for (const FoldAngle& angle : bent.state.angles) EXPECT_EQ(angle.radians, 0);
  }
}

TEST(RestShape, WhatYieldedSurvivesEdgeMaking) {
  Bent bent;
  bent.yield(soft(10, 0));
  const Sheet before = bent.sheet;
  std::vector<double> set(before.edges().size());
  for (std::size_t j = 0; j < bent.shell.hinges().size(); ++j) {
    set[bent.shell.hinges()[j].edge] = bent.state.angles[j].radians;
  }

  const EditContext context{&bent.x, {}};
  const Remap remap =
      makeFoldLine(bent.sheet, {Vector2(0.02, 0), Vector2(0.07, 0.1)}, "", context).remap;
  bent.rest.follow(remap, bent.sheet);
  const Shell shell(bent.sheet, {});
  RestState state = shell.restState();
  bent.rest.apply(shell, state);
  int kept = 0;
  for (std::size_t j = 0; j < shell.hinges().size(); ++j) {
    const Hinge& hinge = shell.hinges()[j];
    if (hinge.crease >= 0) continue;
    const int parent = remap.edges[hinge.edge];
    EXPECT_EQ(state.angles[j].radians, parent == Remap::kNone ? 0 : set[parent]);
    kept += parent != Remap::kNone && set[parent] != 0;
  }
  EXPECT_GT(kept, 50);
}

}  // namespace
}  // namespace shell_origami
