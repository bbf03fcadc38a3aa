/// The contact potential's derivatives, and that they depend on the configuration alone.
#include <shell_origami/contact/contact_potential.h>
#include <shell_origami/linear/block_matrix.h>
#include <shell_origami/mesh/intersections.h>
#include <shell_origami/mesh/triangulate.h>
#include "test/contact/scenes.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace shell_origami {
namespace {

constexpr double kStiffness = 4e3;  ///< [N/m]

struct Evaluation {
  double energy = 0;
  Positions gradient;
};

/// At x, reached from it.
Evaluation evaluate(const ContactPotential& contact, const Positions& x) {
  const auto start = contact.makeIterate(), at = contact.makeIterate();
  contact.start(x, *start);
  Evaluation result{contact.value(x, *start, *at), Positions::Zero(3, x.cols())};
  contact.addGradient(x, *at, result.gradient);
  return result;
}

Eigen::MatrixXd hessianAt(const ContactPotential& contact, const Positions& x, HessianKind kind) {
  const auto start = contact.makeIterate(), at = contact.makeIterate();
  contact.start(x, *start);
  contact.value(x, *start, *at);
  Positions gradient = Positions::Zero(3, x.cols());
  contact.addGradient(x, *at, gradient);
  const Stencils& stencils = contact.stencils(*at);
  std::vector<int> rows(x.cols());
  std::iota(rows.begin(), rows.end(), 0);
  VertexGraph graph(static_cast<int>(x.cols()));
  graph.add({&stencils}, rows);
  BlockMatrix matrix(graph);
  BlockTargets targets;
  EXPECT_TRUE(targets.find(stencils, rows, matrix));
  HessianBlocks blocks(matrix, targets);
  contact.addHessian(x, *at, kind, blocks);
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(matrix.size(), matrix.size());
  for (int c = 0; c < matrix.size(); ++c) {
    for (int i = matrix.columnStarts()[c]; i < matrix.columnStarts()[c + 1]; ++i) {
      lower(matrix.rowIndices()[i], c) = matrix.values()[i];
    }
  }
  return lower.selfadjointView<Eigen::Lower>();
}

Eigen::Map<const Eigen::VectorXd> asVector(const Positions& x) { return {x.data(), x.size()}; }

/// Layers within their reach, the upper ones turned in their plane by `angle`, so that edges that
/// lay on each other are by that not parallel.
struct Layers {
  Sheet sheet;
  Positions x;

  Layers(double max_edge, double angle, Random& random)
      : sheet(triangulateRectangle(0.09, 0.05, max_edge)), x(pleated(sheet, 0.045, 0.6 * kReach)) {
    for (int v = 0; v < x.cols(); ++v) {
      if (x(2, v) == 0) continue;
      const Vector2 moved = Eigen::Rotation2Dd(angle) * x.col(v).head<2>();
      x.col(v).head<2>() = moved + Vector2(1.3e-4, 0.7e-4);  // no vertex above a vertex
    }
    x = shaken(x, 0.06 * kReach, random);
    std::vector<int> names(x.cols());
    std::iota(names.begin(), names.end(), 0);
    EXPECT_TRUE(intersections(x, sheet.triangles(), names).empty());
    x = turned(x, random);
  }
};

/// Pairs whose barrier counts and those of them that are mollified.
std::array<int, 2> countContacts(const ContactPotential& contact, const Positions& x) {
  std::array<int, 2> counts{};
  for (const Contact& c : contact.contacts(x)) {
    ++counts[0];
    counts[1] += c.mollifier.value > 0.01 && c.mollifier.value < 0.99;
  }
  return counts;
}

TEST(ContactPotential, GradientIsThatOfTheValue) {
  Random random(1);
  int mollified = 0;
  double worst = 0;
  for (const double angle : {0.003, 0.01, 0.02, 0.1}) {
    for (int i = 0; i < 5; ++i) {
      const Layers layers(0.02, angle, random);
      const ContactPotential contact(layers.sheet, {kReach, kStiffness});
      const auto [count, some] = countContacts(contact, layers.x);
      EXPECT_GT(count, 50);
      mollified += some;
      const Evaluation here = evaluate(contact, layers.x);
      EXPECT_EQ(here.energy, contact.energy(layers.x));
      const auto start = contact.makeIterate(), at = contact.makeIterate();
      contact.start(layers.x, *start);
      for (int k = 0; k < 10; ++k) {
        const double h = 1e-9;
        const Positions step = h * Positions::Random(3, layers.x.cols());
        const double rise = contact.value(layers.x + step, *start, *at) -
                            contact.value(layers.x - step, *start, *at);
        const double slope = 2 * here.gradient.cwiseProduct(step).sum();
        const double size = 2 * h * here.gradient.norm();
        worst = std::max(worst, std::abs(rise - slope) / size);
      }
    }
  }
  EXPECT_GT(mollified, 100);
  // Where closest points jump from a side to the inside within the step, the slope has a kink: to
  // the step over the smallest gap, 5e-5, times the part of such pairs. 7e-8 is measured.
  EXPECT_LT(worst, 3e-7);
}

TEST(ContactPotential, HessianIsThatOfTheGradientWhereNothingIsMollified) {
  Random random(2);
  int compared = 0;
  double worst = 0;
  for (int i = 0; i < 200 && compared < 10; ++i) {
    const Layers layers(0.03, random.between(0.05, 0.3), random);
    const ContactPotential contact(layers.sheet, {kReach, kStiffness});
    bool any = false;
    int count = 0;
    for (const Contact& c : contact.contacts(layers.x)) {
      any |= c.mollifier.value < 1;
      ++count;
    }
    if (any || count < 5) continue;
    ++compared;
    const Eigen::MatrixXd hessian = hessianAt(contact, layers.x, HessianKind::kExact);
    const double h = 1e-10;
    for (int k = 0; k < 10; ++k) {
      const Positions way = Positions::Random(3, layers.x.cols());
      const Positions rise = evaluate(contact, layers.x + h * way).gradient -
                             evaluate(contact, layers.x - h * way).gradient;
      const Eigen::VectorXd expected = asVector(rise) / (2 * h);
      const double error = (hessian * asVector(way) - expected).norm() / expected.norm();
      worst = std::max(worst, error);
    }
  }
  EXPECT_EQ(compared, 10);
  // Positions of a meter have the rounding 1e-16 m, a millionth of the step; 2e-6 is measured.
  EXPECT_LT(worst, 1e-5);
}

TEST(ContactPotential, ConvexHessianIsPositiveSemidefinite) {
  Random random(3);
  for (int i = 0; i < 5; ++i) {
    const Layers layers(0.03, 0.02 * i, random);
    const ContactPotential contact(layers.sheet, {kReach, kStiffness});
    const Eigen::MatrixXd hessian = hessianAt(contact, layers.x, HessianKind::kConvex);
    const Eigen::VectorXd values = hessian.selfadjointView<Eigen::Lower>().eigenvalues();
    EXPECT_GT(values.maxCoeff(), 0.1 * kStiffness);
    EXPECT_GT(values.minCoeff(), -1e-14 * values.maxCoeff());
  }
}

TEST(ContactPotential, ForcesSumToNothing) {
  Random random(4);
  for (int i = 0; i < 5; ++i) {
    const Layers layers(0.02, 0.01 * i, random);
    const ContactPotential contact(layers.sheet, {kReach, kStiffness});
    const Positions force = evaluate(contact, layers.x).gradient;
    Vector3 moment = Vector3::Zero();
    const Vector3 center = layers.x.rowwise().mean();
    for (int v = 0; v < force.cols(); ++v) {
      moment += (layers.x.col(v) - center).cross(Vector3(force.col(v)));
    }
    // Rounding; of the moments about lever arms of some 5 cm. 2.5e-16 and 2.5e-18 are measured.
    EXPECT_GT(force.norm(), 1);
    EXPECT_LT(force.rowwise().sum().norm(), 1e-15 * force.norm());
    EXPECT_LT(moment.norm(), 1e-17 * force.norm());
  }
}

/// Two parts that touch nothing cost nothing: no energy, force or stencil.
TEST(ContactPotential, IsNothingWhereNothingIsNear) {
  const Sheet sheet(triangulateRectangle(0.09, 0.05, 0.02));
  const ContactPotential contact(sheet, {kReach, kStiffness});
  const Positions x = pleated(sheet, 0.045, 2.1 * kReach);
  const auto start = contact.makeIterate(), at = contact.makeIterate();
  contact.start(x, *start);
  EXPECT_EQ(contact.value(x, *start, *at), 0);
  Positions gradient = Positions::Zero(3, x.cols());
  contact.addGradient(x, *at, gradient);
  EXPECT_EQ(gradient, Positions::Zero(3, x.cols()));
  EXPECT_EQ(contact.stencils(*at).count(), 0);
  EXPECT_FALSE(contact.rough(*at));
  EXPECT_TRUE(contact.contacts(x).empty());
}

/// Whatever candidates and bounds an iterate has from before, the same bits.
TEST(ContactPotential, DependsOnTheConfigurationAlone) {
  Random random(5);
  for (int i = 0; i < 10; ++i) {
    const Layers layers(0.02, 0.02, random);
    const ContactPotential contact(layers.sheet, {kReach, kStiffness});
    const Positions& x = layers.x;
    const Positions to = x + 2e-6 * Positions::Random(3, x.cols());
    const auto fresh = contact.makeIterate(), at = contact.makeIterate();
    contact.start(x, *fresh);
    const double expected = contact.value(to, *fresh, *at);
    ASSERT_TRUE(std::isfinite(expected));
    Positions gradient = Positions::Zero(3, x.cols());
    contact.addGradient(to, *at, gradient);

    // Made by steps of a tenth of a millimeter to and fro, whose bounds go with it.
    const auto used = contact.makeIterate(), other = contact.makeIterate();
    auto* from = used.get();
    auto* next = other.get();
    contact.start(x, *from);
    for (const double part : {1.0, 0.3, 2.0, -1.0, 0.5}) {
      const Positions way = part * 1e-6 * Positions::Random(3, x.cols());
      if (!std::isfinite(contact.value(x + way, *from, *next))) continue;
      std::swap(from, next);
    }
    ASSERT_TRUE(std::isfinite(contact.value(x, *from, *next)));
    std::swap(from, next);
    // Larger rooms, of a step that is looked at and not taken.
    Positions step = 3e-2 * Positions::Random(3, x.cols());
    contact.maxFeasibleStep(x, *from, step);
    const double again = contact.value(to, *from, *next);
    Positions same = Positions::Zero(3, x.cols());
    contact.addGradient(to, *next, same);
    EXPECT_EQ(again, expected);
    EXPECT_EQ(same, gradient);
    EXPECT_EQ(contact.stencils(*next).revision(), contact.stencils(*at).revision());
  }
}

}  // namespace
}  // namespace shell_origami
