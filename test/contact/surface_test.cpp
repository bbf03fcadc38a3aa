/// Surfaces of bodies, and that nothing passes through them.
#include <shell_origami/contact/contact_potential.h>
#include <shell_origami/contact/crossings.h>
#include <shell_origami/mesh/triangulate.h>
#include "test/contact/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace shell_origami {
namespace {

/// Twice the volume that faces enclose, positive where they are counter-clockwise from outside.
double volumeOf(const Surface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.faces) {
    sum += surface.vertices.col(a).dot(
        Vector3(surface.vertices.col(b)).cross(Vector3(surface.vertices.col(c))));
  }
  return sum / 6;
}

bool isClosed(const Surface& surface) {
  std::map<std::pair<int, int>, int> sides;
  for (const Triangle& t : surface.faces) {
    for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [side, count] : sides) {
    if (count != 1 || sides.count({side.second, side.first}) == 0) return false;
  }
  return true;
}

TEST(Surface, SolidsAreClosedAndAsLargeAsTheyShouldBe) {
  const Surface box = boxSurface({1, 2, 3}), sphere = sphereSurface(0.5),
                cylinder = cylinderSurface(0.5, 2);
  for (const Surface* surface : {&box, &sphere, &cylinder}) EXPECT_TRUE(isClosed(*surface));
  EXPECT_NEAR(volumeOf(box), 6, 1e-12);
  // The flat parts are inside by up to 2e-3 and 5.4e-4 of the radius.
  const double ball = 4 * M_PI / 3 * 0.125, round = M_PI * 0.25 * 2;
  EXPECT_LT(volumeOf(sphere), ball);
  EXPECT_GT(volumeOf(sphere), ball * (1 - 3 * 2e-3));
  EXPECT_LT(volumeOf(cylinder), round);
  EXPECT_GT(volumeOf(cylinder), round * (1 - 2 * 5.4e-4));
}

TEST(Surface, ContainsWhatIsInside) {
  Random random(1);
  const Surface sphere = sphereSurface(1), box = boxSurface({1, 2, 3});
  for (int i = 0; i < 300; ++i) {
    const Vector3 p(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
    const double distance = p.norm();
    if (distance < 0.998 || distance > 1) {
      EXPECT_EQ(contains(sphere, p), distance < 1) << p;
    }
    const bool in_box = std::abs(p.x()) < 0.5 && std::abs(p.y()) < 1 && std::abs(p.z()) < 1.5;
    EXPECT_EQ(contains(box, p), in_box) << p;
  }
}

TEST(CutTriangle, FindsPaperThatIsCutOrInside) {
  const Sheet sheet(triangulateRectangle(0.1, 0.1, 0.02));
  Positions x = Positions::Zero(3, sheet.vertexCount());
  for (int v = 0; v < sheet.vertexCount(); ++v) x.col(v).head<2>() = sheet.flatPositions()[v];
  const auto cut = [&](const Surface& surface, const Vector3& at) {
    return cutTriangle(sheet, x, surface, surface.vertices.colwise() + at) >= 0;
  };
  const Surface small = boxSurface({0.01, 0.01, 0.01}), large = boxSurface({1, 1, 1});
  EXPECT_TRUE(cut(small, {0.05, 0.05, 0}));
  EXPECT_TRUE(cut(small, {0.05, 0.05, 0.0049}));
  EXPECT_FALSE(cut(small, {0.05, 0.05, 0.0051}));
  EXPECT_TRUE(cut(large, {0, 0, 0}));
  EXPECT_FALSE(cut(large, {0, 0, 0.51}));
  const Surface table = planePatch(Vector3::Zero(), 5);
  EXPECT_TRUE(cut(table, {0, 0, 1e-9}));
  EXPECT_FALSE(cut(table, {0, 0, -1e-9}));
}

/// A body and a sheet above it, which both move at random: what the guard permits cuts nowhere on
/// the way.
TEST(ContactPotential, PermitsNoCutByABody) {
  Random random(2);
  int whole = 0, shortened = 0;
  const Surface shapes[] = {boxSurface({0.03, 0.02, 0.04}), sphereSurface(0.02),
                            cylinderSurface(0.01, 0.05), planePatch(Vector3::Zero(), 5)};
  for (int i = 0; i < 200; ++i) {
    const Surface& shape = shapes[i % 4];
    const Sheet sheet(triangulateRectangle(0.06, 0.06, 0.02));
    const int count = sheet.vertexCount();
    Positions x(3, count + shape.vertices.cols());
    Positions body = shape.vertices;
    if (!shape.half_space) body = turned(body, random);
    const double top = body.row(2).maxCoeff(), gap = std::pow(10, random.between(-6, -2));
    const Vector3 middle = body.rowwise().mean();
    for (int v = 0; v < count; ++v) {
      const Vector2& p = sheet.flatPositions()[v];
      x.col(v) << middle.x() + p.x() - 0.03, middle.y() + p.y() - 0.03, top + gap;
    }
    x.rightCols(shape.vertices.cols()) = body;
    const Body bodies[] = {{std::make_shared<const Surface>(shape), 0.3}};
    const ContactPotential contact(sheet, {bodies[0]}, {kReach, 4e3});
    const auto start = contact.makeIterate(), at = contact.makeIterate();
    contact.start(x, *start);
    Positions step = Positions::Zero(3, x.cols());
    step.leftCols(count) = gap * std::pow(10, random.between(-1, 2)) * Positions::Random(3, count);
    const double speed = gap * std::pow(10, random.between(-1.5, 0.5));
    const Vector3 way = speed * Vector3(random.between(-1, 1), random.between(-1, 1), 1);
    step.rightCols(shape.vertices.cols()).colwise() += way;
    const bool reached = std::isfinite(contact.value(x + step, *start, *at));
    const double part = contact.maxFeasibleStep(x, *start, step);
    ASSERT_GT(part, 0);
    EXPECT_TRUE(reached || part < 1);
    if (!reached) step *= part;
    ++(reached ? whole : shortened);
    for (int k = 1; k <= 10; ++k) {
      const Positions there = x + k / 10.0 * step;
      EXPECT_EQ(cutTriangle(sheet, there, shape, there.rightCols(shape.vertices.cols())), -1)
          << i << " at " << k;
    }
  }
  EXPECT_GT(whole, 30);
  EXPECT_GT(shortened, 30);
}

TEST(ContactPotential, GradientIsThatOfTheValueWithABody) {
  Random random(3);
  const Surface box = boxSurface({0.03, 0.02, 0.04});
  const Sheet sheet(triangulateRectangle(0.06, 0.06, 0.02));
  const int count = sheet.vertexCount();
  Positions x(3, count + 8);
  for (int v = 0; v < count; ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    x.col(v) << p.x() - 0.03, p.y() - 0.03, 0.02 + 0.6 * kReach;
  }
  x.leftCols(count) = shaken(x.leftCols(count), 0.2 * kReach, random);
  x.rightCols(8) = box.vertices;
  const ContactPotential contact(sheet, {{std::make_shared<const Surface>(box), 0.3}},
                                 {kReach, 4e3});
  ASSERT_GT(contact.contacts(x).size(), 4u);
  Positions gradient = Positions::Zero(3, x.cols());
  contact.addGradient(x, gradient);
  // The forces on the paper and on the body are opposite.
  EXPECT_LT(gradient.rowwise().sum().norm(), 1e-9 * gradient.norm());
  for (int v = 0; v < x.cols(); ++v) {
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-3 * kReach;
      Positions up = x, down = x;
      up(k, v) += h;
      down(k, v) -= h;
      const double difference = (contact.energy(up) - contact.energy(down)) / (2 * h);
      EXPECT_NEAR(gradient(k, v), difference, 1e-4 * gradient.norm()) << v << " " << k;
    }
  }
}

}  // namespace
}  // namespace shell_origami
