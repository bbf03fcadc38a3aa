/// How hard layers press on each other: the forces balance, and the pressures carry them.
#include <shell_origami/contact/contact_forces.h>
#include <shell_origami/mesh/triangulate.h>
#include "test/contact/scenes.h"

#include <gtest/gtest.h>

namespace shell_origami {
namespace {

/// Two flat layers, one a gap above the other, with upright faces between them: the fold is midway
/// between two columns of vertices, at x = 45 and 52.5 mm of the flat sheet.
struct Pressed {
  static constexpr double kGap = 0.6 * kReach;

  Sheet sheet{triangulateRectangle(0.09, 0.05, 0.02)};
  ContactPotential contact{sheet, {kReach, 4e3}};

  Positions positions(double gap = kGap) const { return pleated(sheet, 0.04875, gap); }
  std::vector<ContactForce> forces() const { return contactForces(contact, positions()); }

  bool above(int v) const { return sheet.flatPositions()[v].x() > 0.04875; }

  /// The force on one of the layers [N].
  Vector3 on(bool upper) const {
    Vector3 sum = Vector3::Zero();
    for (const ContactForce& force : forces()) {
      for (int k = 0; k < 4; ++k) {
        if (above(force.vertices[k]) == upper) sum += force.on(k);
      }
    }
    return sum;
  }

  /// The force on the upper layer by virtual work, as the energy falls when it is lifted [N].
  double lift() const {
    const double h = 1e-3 * kGap;
    return (contact.energy(positions(kGap - h)) - contact.energy(positions(kGap + h))) / (2 * h);
  }
};

double areaOf(const Sheet& sheet, int v) {
  double area = 0;
  const auto& flat = sheet.flatPositions();
  for (const auto& [a, b, c] : sheet.triangles()) {
    if (a == v || b == v || c == v) area += doubleArea(flat[a], flat[b], flat[c]) / 2;
  }
  return area;
}

/// Error of lift(): h^2 / 6 times the third derivative of the barrier over its first one. With the
/// gap of 0.6 reaches it is 1.6e-6, and nothing else is seen beside it.
constexpr double kOfDifference = 2e-6;

TEST(ContactForces, OfPressedLayersAreOppositeAndDoTheWorkOfTheEnergy) {
  const Pressed pressed;
  const double lift = pressed.lift();
  ASSERT_GT(lift, 0);
  EXPECT_NEAR(pressed.on(true).z() / lift, 1, kOfDifference);
  EXPECT_LT(pressed.on(true).head<2>().norm(), 1e-13 * lift);
  EXPECT_LT((pressed.on(true) + pressed.on(false)).norm(), 1e-14 * lift);
}

TEST(ContactForces, ActMidwayBetweenTheLayers) {
  const Pressed pressed;
  ASSERT_GT(pressed.forces().size(), 100u);
  for (const ContactForce& force : pressed.forces()) {
    EXPECT_NEAR(force.point.z(), Pressed::kGap / 2, 1e-13 * Pressed::kGap);
    EXPECT_GE(force.point.y(), 0);
    EXPECT_LE(force.point.y(), 0.05);
  }
}

TEST(ContactForces, PressuresOverTheAreaOfALayerAreTheForceOnIt) {
  const Pressed pressed;
  const std::vector<double> pressures = contactPressures(pressed.sheet, pressed.forces());
  for (const bool upper : {false, true}) {
    double sum = 0;
    for (int v = 0; v < pressed.sheet.vertexCount(); ++v) {
      if (pressed.above(v) == upper) sum += pressures[v] * areaOf(pressed.sheet, v) / 3;
    }
    EXPECT_NEAR(sum / pressed.lift(), 1, kOfDifference) << upper;
  }
}

TEST(ContactForces, PaperThatTouchesNothingIsWithoutPressure) {
  const Pressed pressed;
  const auto forces = contactForces(pressed.contact, pressed.positions(1.1 * kReach));
  EXPECT_TRUE(forces.empty());
  for (const double p : contactPressures(pressed.sheet, forces)) EXPECT_EQ(p, 0);
}

TEST(ContactForces, OfTheTwoSidesOfALayerTheOnePressedHarderCounts) {
  const Sheet sheet(triangulateRectangle(0.09, 0.05, 0.02));
  const Vector3 down(0, 0, -2e-3);
  const auto pressureAt0 = [&](const std::vector<Vector3>& pushes) {
    std::vector<ContactForce> forces;
    for (const Vector3& push : pushes) {
      forces.push_back({{0, 5, 6, 7}, {0.5, 0.5, -1, 0}, 2 * push, Vector3::Zero()});
    }
    return contactPressures(sheet, forces)[0];
  };
  const double one = down.norm() / (areaOf(sheet, 0) / 3);
  EXPECT_NEAR(pressureAt0({down}) / one, 1, 1e-12);
  EXPECT_NEAR(pressureAt0({down, -down}) / one, 1, 1e-12);
  EXPECT_NEAR(pressureAt0({down, -0.25 * down}) / one, 1, 1e-12);
  EXPECT_NEAR(pressureAt0({down, down}) / one, 2, 1e-12);
}

}  // namespace
}  // namespace shell_origami
