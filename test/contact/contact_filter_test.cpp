/// The guard of every motion: what may be reached, how far steps may go, where starts are moved to,
/// and the impacts that a step anticipates.
#include <shell_origami/contact/contact_potential.h>
#include <shell_origami/energy/shell_potential.h>
#include <shell_origami/linear/stencil_system.h>
#include <shell_origami/mesh/intersections.h>
#include <shell_origami/mesh/triangulate.h>
#include "test/contact/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace shell_origami {
namespace {

bool crosses(const Sheet& sheet, const Positions& x) {
  std::vector<int> names(x.cols());
  std::iota(names.begin(), names.end(), 0);
  return !intersections(x, sheet.triangles(), names).empty();
}

/// A sheet of 6 by 4 cm folded in half: layers a gap apart, its corners 0 and 1 on each other.
struct Half {
  Sheet sheet{triangulateRectangle(0.06, 0.04, 0.01)};
  Positions x;
  ContactPotential contact{sheet, {kReach, 4e3}};
  std::unique_ptr<Potential::Iterate> start = contact.makeIterate(), at = contact.makeIterate();

  explicit Half(double gap) : x(pleated(sheet, 0.03, gap)) { contact.start(x, *start); }
  bool reaches(const Positions& to) const { return std::isfinite(contact.value(to, *start, *at)); }
  /// With corner 1, of the upper layer, moved by this.
  Positions withCornerMoved(const Vector3& way) const {
    Positions to = x;
    to.col(1) += way;
    return to;
  }
};

TEST(ContactPotential, VerticesDoNotPassThroughFaces) {
  Half half(1e-3);
  ASSERT_NEAR(half.x(2, 1), 1e-3, 1e-15);
  ASSERT_NEAR((half.x.col(1) - half.x.col(0)).norm(), 1e-3, 1e-15);
  const Positions through = half.withCornerMoved({7e-3, 6e-3, -2e-3});
  EXPECT_FALSE(half.reaches(through));
  const auto found = half.contact.findInfeasibility(through, *half.start);
  ASSERT_TRUE(found);
  EXPECT_STREQ(found->what, "paper would pass through paper");
  // Far beyond, where it touches nothing at the end.
  EXPECT_FALSE(half.reaches(half.withCornerMoved({7e-3, 6e-3, -0.5})));
  EXPECT_TRUE(half.reaches(half.withCornerMoved({7e-3, 6e-3, -0.8e-3})));
}

TEST(ContactPotential, EdgesDoNotPassThroughEdges) {
  Half half(1e-3);
  // Outside the lower layer all the time; its edges go down through the border of it.
  const Positions through = half.withCornerMoved({-0.01, 5e-3, -6e-3});
  EXPECT_TRUE(crosses(half.sheet, through));
  EXPECT_FALSE(half.reaches(through));
  EXPECT_TRUE(half.contact.findInfeasibility(through, *half.start));
}

TEST(ContactPotential, PaperMovesPastPaper) {
  Half half(1e-3);
  // Down beside the lower layer, so far off that the edges to it stay above.
  const Positions past = half.withCornerMoved({-0.05, 5e-3, -1.5e-3});
  EXPECT_FALSE(crosses(half.sheet, past));
  EXPECT_TRUE(half.reaches(past));
  EXPECT_FALSE(half.contact.findInfeasibility(past, *half.start));
  // Layers that part, and all together, wherever.
  Positions apart = half.x;
  for (int v = 0; v < apart.cols(); ++v) apart(2, v) *= 20;
  EXPECT_TRUE(half.reaches(apart));
  EXPECT_TRUE(half.reaches(half.x.colwise() + Vector3(3, -50, 20)));
}

/// Whether no hinge passes through itself on a straight way: contact leaves that to the hinges.
bool hingesHold(const ShellPotential& shell, const Positions& x, const Positions& to) {
  const auto start = shell.makeIterate(), at = shell.makeIterate();
  shell.start(x, *start);
  for (int k = 1; k <= 20; ++k) {
    if (shell.findInfeasibility(x + k / 20.0 * (to - x), *start)) return false;
    shell.start(x + k / 20.0 * (to - x), *start);
  }
  return true;
}

/// What the guard permits never crosses on its way, whatever the step; crossings are looked for by
/// exact predicates in fifty states of it.
TEST(ContactPotential, PermitsNoCrossing) {
  Random random(1);
  int whole = 0, shortened = 0;
  for (const double gap : {1e-3, 3e-5, 1e-6}) {
    for (int i = 0; i < 100; ++i) {
      const Sheet sheet(triangulateRectangle(0.09, 0.04, 0.02));
      const Positions x = turned(shaken(pleated(sheet, 0.03, gap), 0.1 * gap, random), random);
      ASSERT_FALSE(crosses(sheet, x));
      const ContactPotential contact(sheet, {kReach, 4e3});
      const ShellPotential shell(sheet, {}, Vector3::Zero());
      const auto start = contact.makeIterate(), at = contact.makeIterate();
      contact.start(x, *start);
      Positions step = gap * std::pow(10, random.between(-1, 2)) * Positions::Random(3, x.cols());
      const bool reached = std::isfinite(contact.value(x + step, *start, *at));
      EXPECT_EQ(contact.findInfeasibility(x + step, *start).has_value(), !reached);
      const double part = contact.maxFeasibleStep(x, *start, step);
      ASSERT_GT(part, 0);
      EXPECT_TRUE(reached || part < 1);
      EXPECT_TRUE(std::isfinite(contact.value(x + part * step, *start, *at))) << gap << " " << part;
      if (!reached) step *= part;
      if (!hingesHold(shell, x, x + step)) continue;
      ++(reached ? whole : shortened);
      for (int k = 1; k <= 50; ++k) {
        EXPECT_FALSE(crosses(sheet, x + k / 50.0 * step)) << gap << " " << i;
      }
    }
  }
  EXPECT_GT(whole, 50);
  EXPECT_GT(shortened, 50);
}

TEST(ContactPotential, StartsAreMovedBackWhereTheyWouldPass) {
  for (const double gap : {1e-3, 2e-5}) {
    Half half(gap);
    // All of it moves along the layers, and one vertex of the upper one falls.
    const Vector3 way(2e-3, -1e-3, 0);
    const Vector2 place(0.045, 0.02);
    const int fallen = half.sheet.nearestVertex(place);
    Positions to = half.x.colwise() + way;
    to(2, fallen) -= 0.02;
    ASSERT_FALSE(half.reaches(to));
    Positions filtered = to;
    half.contact.filterStart(half.x, *half.start, filtered);
    EXPECT_TRUE(half.reaches(filtered));
    int moved = 0, far = 0;
    for (int v = 0; v < to.cols(); ++v) {
      const bool back = filtered.col(v) != to.col(v);
      moved += back;
      if ((half.x.col(v) - half.x.col(fallen)).norm() < 0.022) continue;
      ++far;
      EXPECT_FALSE(back) << v;
    }
    EXPECT_GT(far, 5);
    EXPECT_GT(moved, 0);
  }
}

TEST(ContactPotential, StartsThatPassNothingStay) {
  Half half(1e-3);
  const Positions to =
      (half.x + 1e-4 * Positions::Random(3, half.x.cols())).colwise() + Vector3(0.1, 0.2, 0.3);
  Positions filtered = to;
  half.contact.filterStart(half.x, *half.start, filtered);
  EXPECT_EQ(filtered, to);
}

TEST(ContactPotential, RandomStartsAreAccepted) {
  Random random(2);
  int changed = 0, moved = 0;
  for (int i = 0; i < 100; ++i) {
    const double gap = std::pow(10, random.between(-6, -3));
    const Sheet sheet(triangulateRectangle(0.09, 0.04, 0.015));
    const Positions x = turned(shaken(pleated(sheet, 0.03, gap), 0.1 * gap, random), random);
    const ContactPotential contact(sheet, {kReach, 4e3});
    const auto start = contact.makeIterate(), at = contact.makeIterate();
    contact.start(x, *start);
    const Positions to =
        x + gap * std::pow(10, random.between(-1, 2)) * Positions::Random(3, x.cols());
    Positions filtered = to;
    contact.filterStart(x, *start, filtered);
    EXPECT_TRUE(std::isfinite(contact.value(filtered, *start, *at))) << i;
    changed += filtered != to;
    moved += filtered != x;
  }
  EXPECT_GT(changed, 50);
  EXPECT_EQ(moved, 100) << "starts that stay where the last step ended";
}

/// The minimum of a quadratic model that would take the upper layer through the lower one stops
/// where the springs of the impacts hold it.
TEST(ContactPotential, AnticipatedImpactsStopTheNextStep) {
  const double gap = 3e-4, fall = 1e-3, weight = 4.0;  // 1/1000 of the pairs' stiffness
  Half half(gap);
  ASSERT_TRUE(half.reaches(half.x));
  const Eigen::VectorXd weights = Eigen::VectorXd::Constant(half.x.cols(), weight);
  Positions step = Positions::Zero(3, half.x.cols());
  for (int v = 0; v < step.cols(); ++v) step(2, v) = half.x(2, v) > 0 ? -fall : 0;
  Positions gradient = Positions::Zero(3, half.x.cols());
  half.contact.addGradient(half.x, *half.at, gradient);
  ASSERT_EQ(gradient.norm(), 0) << "nothing is near yet";
  ASSERT_LT(half.contact.maxFeasibleStep(half.x, *half.at, step), gap / fall);

  ASSERT_TRUE(half.contact.anticipate(half.x, *half.at, step));
  gradient = -weight * step;
  half.contact.addAnticipated(half.x, *half.at, gradient);
  StencilSystem system;
  system.setFree(std::vector<bool>(half.x.cols(), true));
  ASSERT_TRUE(system.prepare({&half.contact.stencils(*half.at)}));
  system.setZero();
  HessianBlocks blocks = system.blocks(0);
  half.contact.addHessian(half.x, *half.at, HessianKind::kExact, blocks);
  system.addToDiagonal(1, weights);
  ASSERT_TRUE(system.factorize());
  Positions stopped = Positions::Zero(3, half.x.cols());
  ASSERT_TRUE(system.solve(gradient, stopped));

  const Positions there = half.x + stopped;
  int compared = 0;
  EXPECT_GT(half.contact.maxFeasibleStep(half.x, *half.at, stopped), 0.9) << "up to the reach";
  EXPECT_TRUE(half.reaches(there));
  // The springs end at 0.7 reaches. Three times as stiff as a pair is in contact, each is pressed
  // by one vertex's weight or less: 4 N/m * 1e-3 m / (3 * 4e3 N/m) = 3.3e-7 m. As both layers give
  // way several pairs may share a vertex: 2.2e-6 m is measured.
  for (int v = 0; v < there.cols(); ++v) {
    for (int w = 0; w < there.cols(); ++w) {
      if (half.x(2, v) == 0 || half.x(2, w) != 0 || half.x(0, v) > 0.025) continue;
      if ((half.x.col(v) - half.x.col(w)).head<2>().norm() > 1e-9) continue;
      const double left = there(2, v) - there(2, w);
      EXPECT_LT(left, 0.7 * kReach);
      EXPECT_GT(left, 0.7 * kReach - 5e-6);
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);

  ASSERT_TRUE(half.reaches(half.x));
  Positions forgotten = Positions::Zero(3, half.x.cols());
  half.contact.anticipate(half.x, *half.at, step);
  half.contact.addGradient(half.x, *half.at, forgotten);
  EXPECT_EQ(half.contact.stencils(*half.at).count(), 0) << "the next gradient forgets impacts";
}

TEST(ContactPotential, AnticipatesNothingWhereNothingIsInTheWay) {
  Half half(1e-3);
  ASSERT_TRUE(half.reaches(half.x));
  const Positions step = Positions::Zero(3, half.x.cols()).colwise() + Vector3(0, 0.2, -0.3);
  EXPECT_FALSE(half.contact.anticipate(half.x, *half.at, step));
}

}  // namespace
}  // namespace shell_origami
