/// Potentials that a program adds: dynamics/ knows none of them.
#include <shell_origami/dynamics/stepper.h>
#include <shell_origami/energy/shell_potential.h>
#include <shell_origami/mesh/triangulate.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace shell_origami {
namespace {

/// Springs between vertices that need not be neighbors: W = k / 2 (|x_a - x_b| - length)^2 each.
class Springs : public Potential {
 public:
  struct Spring {
    std::array<int, 2> ends;
    double length;  ///< [m]
  };
  static constexpr double kStiffness = 40;  ///< [N/m]

  void set(std::vector<Spring> springs) {
    springs_ = std::move(springs);
    stencils_.restart(++revision_);
    for (const Spring& spring : springs_) stencils_.add(spring.ends.data(), 2);
  }

  std::unique_ptr<Iterate> makeIterate() const override { return std::make_unique<Iterate>(); }
  void start(const Positions&, Iterate&) const override {}
  double value(const Positions& x, const Iterate&, Iterate&) const override {
    double sum = 0;
    for (const Spring& spring : springs_) {
      const double stretch = along(spring, x).norm() - spring.length;
      sum += kStiffness / 2 * stretch * stretch;
    }
    return sum;
  }
  std::optional<Infeasibility> findInfeasibility(const Positions&, const Iterate&) const override {
    return std::nullopt;
  }
  void addGradient(const Positions& x, Iterate&, Positions& gradient) const override {
    for (const Spring& spring : springs_) {
      const Vector3 d = along(spring, x);
      const Vector3 force = kStiffness * (1 - spring.length / d.norm()) * d;
      gradient.col(spring.ends[1]) += force;
      gradient.col(spring.ends[0]) -= force;
    }
  }
  const Stencils& stencils(const Iterate&) const override { return stencils_; }
  void addHessian(const Positions& x, const Iterate&, HessianKind kind,
                  HessianBlocks& blocks) const override {
    for (int i = 0; i < static_cast<int>(springs_.size()); ++i) {
      const Vector3 d = along(springs_[i], x);
      const Eigen::Matrix3d direction = d * d.transpose() / d.squaredNorm();
      double across = 1 - springs_[i].length / d.norm();
      if (kind == HessianKind::kConvex) across = std::max(0.0, across);
      const Eigen::Matrix3d block =
          kStiffness * (direction + across * (Eigen::Matrix3d::Identity() - direction));
      Eigen::Matrix<double, 6, 6> hessian;
      hessian << block, -block, -block, block;
      blocks.add(i, hessian);
    }
  }
  double maxFeasibleStep(const Positions&, Iterate&, const Positions&) const override { return 1; }

 private:
  static Vector3 along(const Spring& spring, const Positions& x) {
    return x.col(spring.ends[1]) - x.col(spring.ends[0]);
  }

  std::vector<Spring> springs_;
  Stencils stencils_;
  std::uint64_t revision_ = 0;
};

/// No energy, but nothing may go below z = 0.
class Floor : public Potential {
 public:
  std::unique_ptr<Iterate> makeIterate() const override { return std::make_unique<Iterate>(); }
  void start(const Positions&, Iterate&) const override {}
  double value(const Positions& x, const Iterate&, Iterate&) const override {
    return x.row(2).minCoeff() > 0 ? 0 : std::numeric_limits<double>::infinity();
  }
  std::optional<Infeasibility> findInfeasibility(const Positions& x,
                                                 const Iterate&) const override {
    int lowest = 0;
    if (x.row(2).minCoeff(&lowest) > 0) return std::nullopt;
    return Infeasibility{"a vertex would be below the floor", lowest};
  }
  void addGradient(const Positions&, Iterate&, Positions&) const override {}
  const Stencils& stencils(const Iterate&) const override { return none_; }
  void addHessian(const Positions&, const Iterate&, HessianKind, HessianBlocks&) const override {}
  double maxFeasibleStep(const Positions& x, Iterate&, const Positions& step) const override {
    double part = 1;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
      if (step(2, v) < 0) part = std::min(part, -0.9 * x(2, v) / step(2, v));
    }
    return part;
  }

 private:
  Stencils none_;
};

class Still : public BoundaryConditions {
 public:
  void applyAt(double, Positions&) override {}
  bool constant() const override { return true; }
};

/// Moves the prescribed vertices by `way` within a step.
class Move : public BoundaryConditions {
 public:
  Move(Vector3 way, Positions start) : way_(std::move(way)), start_(std::move(start)) {}
  void applyAt(double s, Positions& prescribed) override {
    prescribed = start_.colwise() + s * way_;
  }
  bool constant() const override { return false; }

 private:
  Vector3 way_;
  Positions start_;
};

struct Paper {
  Sheet sheet{triangulateRectangle(0.1, 0.1, 0.02)};
  ShellPotential shell;
  Motion motion;

  explicit Paper(const Vector3& gravity = Vector3::Zero()) : shell(sheet, {}, gravity) {
    motion.positions = Positions::Zero(3, sheet.vertexCount());
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      motion.positions.col(v).head<2>() = sheet.flatPositions()[v];
    }
    motion.velocities = motion.accelerations = Positions::Zero(3, sheet.vertexCount());
  }
  const Eigen::VectorXd& masses() const { return shell.shell().masses(); }
};

SolverConfig backwardEuler() {
  SolverConfig config;
  config.integrator = IntegratorKind::kBackwardEuler;
  config.time_step = 1e-3;
  config.tolerance = 1e-9;
  return config;
}

TEST(Potentials, SpringsBetweenFarVerticesComeAndGo) {
  Paper paper;
  Springs springs;
  springs.set({});
  const Potentials potentials{&paper.shell, &springs};
  // The corners are 0 to 3, and no triangle or hinge joins two of them.
  const std::vector<Springs::Spring> diagonals{{{0, 2}, 0.08}, {{1, 3}, 0.09}};
  const std::vector<Springs::Spring> sides{{{0, 1}, 0.07}, {{2, 3}, 0.07}};
  const SolverConfig config = backwardEuler();
  Stepper stepper(config);
  stepper.setFree(std::vector<bool>(paper.sheet.vertexCount(), true));
  Still still;
  int analyses = 0;
  for (int i = 0; i < 24; ++i) {
    if (i % 3 == 0) springs.set(i % 9 == 0 ? diagonals : i % 9 == 3 ? sides : decltype(sides){});
    const Motion before = paper.motion;
    const StepReport report = stepper.step(potentials, paper.masses(), 0, still, paper.motion);
    ASSERT_TRUE(report.converged) << report.failure;
    ASSERT_EQ(report.retries, 0);
    analyses += report.analyses;
    // Backward Euler's equation, M (v' - v) / dt + dW/dx = 0, for whatever springs there are now.
    Positions force = Positions::Zero(3, paper.motion.positions.cols());
    paper.shell.addGradient(paper.motion.positions, force);
    const auto iterate = springs.makeIterate();
    springs.addGradient(paper.motion.positions, *iterate, force);
    const Positions inertia = (paper.motion.velocities - before.velocities) / config.time_step *
                              paper.masses().asDiagonal();
    EXPECT_LT((inertia + force).norm(), 1e-4 * std::max(inertia.norm(), 1e-6)) << i;
  }
  EXPECT_EQ(analyses, 2) << "the shell with the diagonals, then with the sides as well";
  const double diagonal = (paper.motion.positions.col(0) - paper.motion.positions.col(2)).norm();
  EXPECT_LT(diagonal, 0.1 * std::sqrt(2.0) - 1e-6) << "the springs do not pull";
}

TEST(Potentials, NothingPassesAFilter) {
  const Vector3 gravity(0, 0, -9.81);
  Paper paper(gravity);
  paper.motion.positions.row(2).setConstant(1e-3);
  Floor floor;
  const Potentials potentials{&paper.shell, &floor};
  SolverConfig config;
  config.integrator = IntegratorKind::kBackwardEuler;
  Stepper stepper(config);
  stepper.setFree(std::vector<bool>(paper.sheet.vertexCount(), true));
  Still still;
  bool failed = false;
  for (int i = 0; i < 30 && !failed; ++i) {
    const StepReport report = stepper.step(potentials, paper.masses(), 0, still, paper.motion);
    failed = !report.converged;
    EXPECT_GT(paper.motion.positions.row(2).minCoeff(), 0);
    EXPECT_EQ(failed, !report.failure.empty());
  }
  EXPECT_TRUE(failed) << "a floor that gives no force cannot be reached by a whole step";
}

TEST(Potentials, HeldVerticesDoNotPassAFilter) {
  Paper paper;
  paper.motion.positions.row(2).setConstant(1e-3);
  Floor floor;
  const Potentials potentials{&paper.shell, &floor};
  Stepper stepper(SolverConfig{});
  std::vector<bool> free(paper.sheet.vertexCount(), true);
  free[0] = free[1] = false;
  stepper.setFree(free);
  Move down({0, 0, -2e-3}, paper.motion.positions);
  const Positions before = paper.motion.positions;
  const StepReport report = stepper.step(potentials, paper.masses(), 0, down, paper.motion);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.failure, "a vertex would be below the floor");
  EXPECT_TRUE(report.vertex == 0 || report.vertex == 1);
  EXPECT_EQ(paper.motion.positions, before);
}

}  // namespace
}  // namespace shell_origami
