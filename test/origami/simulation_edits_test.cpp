/// Edits of the paper: what each does and records, and which are refused.
#include "test/origami/squares.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

namespace shell_origami {
namespace {

TEST(Simulation, GravityAndAirMayChangeInTheMiddleOfAFall) {
  // Under constant acceleration Newmark is exact, also where the acceleration jumps. It floats
  // first: no scheme knows the accelerations before its first step.
  SimulationConfig config;
  config.material.air_damping = 0;
  config.solver.gamma = 0.5;
  Simulation simulation = square(config);
  const auto fall = [&simulation](int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(simulation.step().converged);
  };
  fall(1);
  simulation.configure({{0, 0, -9.81}, 0, 1});
  fall(30);
  simulation.configure({{2, 0, 5}, 0, 1});
  fall(30);
  const double t = 0.5;
  const Vector3 mean = simulation.positions().rowwise().mean();
  const Vector3 start = flatInSpace(simulation.sheet()).rowwise().mean();
  EXPECT_NEAR(mean.z() - start.z(), -9.81 * t * t * 3 / 2 + 5 * t * t / 2, 1e-9);
  EXPECT_NEAR(mean.x() - start.x(), 2 * t * t / 2, 1e-9);
  // In thick air without gravity speeds die away by exp(-c t).
  simulation.configure({Vector3::Zero(), 4, 1});
  const Vector3 before = simulation.velocities().rowwise().mean();
  fall(30);
  const Vector3 after = simulation.velocities().rowwise().mean();
  EXPECT_LT((after - std::exp(-4 * t) * before).norm(), 1e-3 * before.norm());
}

TEST(Simulation, BeforeTheFirstStepItIsAsIfThePaperHadStartedSo) {
  SimulationConfig config;
  config.gravity = {0, 1, -9.81};
  config.material.air_damping = 3;
  Simulation changed = square(), started = square(config);
  changed.configure({config.gravity, config.material.air_damping, 1});
  for (int i = 0; i < 10; ++i) {
    changed.step();
    started.step();
  }
  EXPECT_EQ(changed.positions(), started.positions());
}

TEST(Simulation, ANewGravityWakesPaperThatRestsAndLeavesPinsAlone) {
  Simulation simulation = square();
  const std::vector<int> held = simulation.pin(Region{{{0, 0}, {kSide, 0}, {kSide, 0.001}}});
  simulation.step();
  ASSERT_EQ(simulation.step().newton_iterations, 0);  // it rests
  const Positions before = simulation.positions();
  simulation.configure({{0, 0, -9.81}, 5, 1});
  EXPECT_FALSE(simulation.settled());
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(simulation.step().converged);
  for (int v : held) EXPECT_EQ(simulation.positions().col(v), before.col(v));
  EXPECT_LT((simulation.positions() - before).row(2).minCoeff(), -0.01);
}

TEST(Simulation, ANewFoldDurationIsThatOfTheNextFold) {
  Simulation simulation = square();
  simulation.configure({Vector3::Zero(), 5, 0.25});
  FoldEdit fold = diagonal(1);
  fold.duration.reset();
  simulation.fold(fold);
  for (int i = 0; i < 14; ++i) simulation.step();
  EXPECT_TRUE(simulation.folding());
  for (int i = 0; i < 2; ++i) simulation.step();
  EXPECT_FALSE(simulation.folding());
}

TEST(Simulation, EditsOnBentPaperKeepItsShape) {
  Simulation simulation = square();
  simulation.fold(diagonal(100 * kDegree));
  settle(simulation);
  const double energy = simulation.energies().membrane + simulation.energies().bending;
  FoldEdit second;
  second.where = Segment{Vector2(0, 0.04), Vector2(kSide, 0.1)};
  second.angle = 1;
  simulation.fold(second);
  simulation.sheet().validate();
  const double after = simulation.energies().membrane + simulation.energies().bending;
  EXPECT_LT(simulation.maxStrain(), 1e-4);
  EXPECT_LT(std::abs(after - energy), 1e-6);  // the fold itself stores 1e-3 J
}

TEST(Simulation, RefusedEditsChangeNothing) {
  Simulation simulation = square();
  simulation.fold(diagonal(1));
  for (int i = 0; i < 5; ++i) simulation.step();
  const Positions before = simulation.positions();
  const std::uint32_t revision = simulation.sheet().revision();
  const double nan = std::nan("");
  std::vector<FoldEdit> bad;
  for (const double angle : {M_PI, -M_PI, 4.0, nan, HUGE_VAL}) bad.push_back(diagonal(angle));
  for (const double duration : {-1.0, nan, HUGE_VAL}) bad.push_back(diagonal(1, duration));
  for (const double stiffness : {0.0, -1.0, nan, HUGE_VAL, 1e9}) {
    bad.push_back(diagonal(1));
    bad.back().stiffness = stiffness;
  }
  bad.push_back(diagonal(1));
  bad.back().where = CreaseName{"nobody"};
  for (const std::array<std::int64_t, 2>& pair :
       {std::array<std::int64_t, 2>{0, 0}, {0, 100000}, {-1, 3}, {0, 4294967295}}) {
    bad.push_back(diagonal(1));
    bad.back().where = VertexPair{pair};
  }
  bad.push_back(diagonal(1));
  bad.back().where = Segment{Vector2(0, 0), Vector2(1, 1)};
  for (const FoldEdit& request : bad) {
    EXPECT_THROW(simulation.fold(request), std::invalid_argument);
  }
  EXPECT_THROW(simulation.pin(std::vector<std::int64_t>{-1}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(std::vector<std::int64_t>{}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(std::vector<Vector2>{{9, 9}}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(Region{{{0, 0}, {1, 1}}}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(Ball{{0, 0, 0}, -1}), std::invalid_argument);
  EXPECT_THROW(simulation.pin(Ball{{0, 0, 9}, 0.1}), std::invalid_argument);
  EXPECT_THROW(simulation.unpin(std::vector<std::int64_t>{3}), std::invalid_argument);
  EXPECT_THROW(simulation.unpin(std::vector<Vector2>{{9, 9}}), std::invalid_argument);
  EXPECT_THROW(simulation.addVertex(0, 1000, 0.5), std::invalid_argument);
  const Vector3 none = Vector3::Zero();
  for (const LiveConfig& live :
       {LiveConfig{{0, nan, 0}, 5, 1}, LiveConfig{{0, 0, -1e5}, 5, 1}, LiveConfig{none, -1, 1},
        LiveConfig{none, 1e7, 1}, LiveConfig{none, nan, 1}, LiveConfig{none, 5, 0},
        LiveConfig{none, 5, -1}, LiveConfig{none, 5, HUGE_VAL}}) {
    EXPECT_THROW(simulation.configure(live), std::invalid_argument);
  }
  EXPECT_EQ(simulation.config().material.air_damping, SimulationConfig().material.air_damping);
  EXPECT_EQ(simulation.positions(), before);
  EXPECT_EQ(simulation.sheet().revision(), revision);
  EXPECT_TRUE(simulation.pinned().empty());
}

TEST(Simulation, RefusesAConfigThatMakesNoSense) {
  const auto refuses = [](const auto& change) {
    SimulationConfig config;
    change(config);
    EXPECT_THROW(square(config), std::invalid_argument);
  };
  refuses([](auto& c) { c.material.thickness = 0; });
  refuses([](auto& c) { c.material.youngs_modulus = std::nan(""); });
  refuses([](auto& c) { c.material.poisson_ratio = 0.5; });
  refuses([](auto& c) { c.material.density = -1; });
  refuses([](auto& c) { c.solver.time_step = 0; });
  refuses([](auto& c) { c.solver.gamma = 0.4; });
  refuses([](auto& c) { c.solver.max_iterations = 0; });
  refuses([](auto& c) { c.solver.threads = -1; });
  refuses([](auto& c) { c.gravity.x() = HUGE_VAL; });
  refuses([](auto& c) { c.fold_duration = -1; });
}

TEST(Simulation, APiecePartOfACreaseKeepsItsRamp) {
  Simulation simulation = square();
  simulation.fold(diagonal(90 * kDegree));
  settle(simulation);
  FoldEdit tip = diagonal(-90 * kDegree);
  tip.where = Segment{Vector2(0.1, 0.1), Vector2(kSide, kSide)};
  tip.name = "tip";
  simulation.fold(tip);
  ASSERT_EQ(simulation.creases().size(), 2u);
  for (const CreaseStatus& crease : simulation.creases()) {
    EXPECT_NEAR(crease.rest_angle / kDegree, 90, 1e-9);
    EXPECT_NEAR(crease.target_angle / kDegree, crease.name == "tip" ? -90 : 90, 1e-9);
  }
}

/// A crease that cannot fold, for the paper beside it is held flat.
Simulation heldFlat(const SimulationConfig& config) {
  Simulation simulation = square(config);
  simulation.pin(Region{{{0, 0}, {0.06, 0}, {0.06, kSide}, {0, kSide}}});
  simulation.pin(Region{{{0.09, 0}, {kSide, 0}, {kSide, kSide}, {0.09, kSide}}});
  FoldEdit fold;
  fold.where = Segment{Vector2(0.075, 0), Vector2(0.075, kSide)};
  fold.angle = 1;
  fold.duration = 0;
  simulation.fold(fold);
  return simulation;
}

TEST(Simulation, SettlingYieldsInelasticPaper) {
  SimulationConfig config;
  Simulation elastic = heldFlat(config);
  config.material.yield_curvature = 20;
  Simulation inelastic = heldFlat(config);
  elastic.settle();
  inelastic.settle();
  EXPECT_DOUBLE_EQ(elastic.creases()[0].rest_angle, 1);
  const double most = config.material.bendingStiffness() * config.material.yield_curvature;
  EXPECT_LT(inelastic.creases()[0].rest_angle, 0.9);
  EXPECT_LE(std::abs(inelastic.creases()[0].moment), most * (1 + 1e-9));
}

TEST(Simulation, AnInterruptedSettleChangesNothing) {
  SimulationConfig config;
  config.material.yield_curvature = 20;
  Simulation interrupted = heldFlat(config), untouched = heldFlat(config);
  int rounds = 0;
  interrupted.setInterrupt([&rounds] { return ++rounds == 5; });
  EXPECT_THROW(interrupted.settle(), std::invalid_argument);
  EXPECT_EQ(rounds, 5);
  interrupted.setInterrupt(nullptr);
  for (Simulation* simulation : {&interrupted, &untouched}) {
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(simulation->step().converged);
  }
  EXPECT_EQ(interrupted.positions(), untouched.positions());
  EXPECT_EQ(interrupted.creases()[0].rest_angle, untouched.creases()[0].rest_angle);
}

TEST(Simulation, ARecordHoldsWhatTheEditMeantAndDid) {
  Simulation simulation = square();
  const int corner = simulation.sheet().nearestVertex({kSide, kSide});
  const std::vector<std::int64_t> pair{simulation.sheet().nearestVertex({0, 0}), corner};
  FoldEdit fold = diagonal(1);
  fold.where = VertexPair{{pair[0], pair[1]}};
  fold.duration.reset();
  const EditRecord folded = simulation.apply(fold);
  EXPECT_EQ(folded.step, 0u);
  EXPECT_EQ(folded.vertices.back(), corner);
  EXPECT_EQ(folded.revision, simulation.sheet().revision());
  const auto& made = std::get<FoldEdit>(folded.edit);
  EXPECT_EQ(std::get<Segment>(made.where)[1], Vector2(kSide, kSide));
  EXPECT_EQ(made.duration, SimulationConfig().fold_duration);
  EXPECT_EQ(made.stiffness, Material().crease_stiffness);

  simulation.step();
  const EditRecord pinned = simulation.apply(PinEdit{std::vector<Vector2>{{kSide, kSide}}});
  EXPECT_EQ(pinned.step, 1u);
  EXPECT_EQ(pinned.time, simulation.time());
  EXPECT_EQ(pinned.vertices, std::vector<int>{corner});
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(std::get<PinEdit>(pinned.edit).where),
            std::vector<std::int64_t>{corner});

  const EditRecord freed = simulation.apply(UnpinEdit{});
  EXPECT_EQ(freed.vertices, std::vector<int>{corner});
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(*std::get<UnpinEdit>(freed.edit).where),
            std::vector<std::int64_t>{corner});
  EXPECT_TRUE(simulation.apply(UnpinEdit{}).vertices.empty());

  const Edge edge = simulation.sheet().edges()[0];
  const EditRecord added =
      simulation.apply(AddVertexEdit{{edge.vertices[0], edge.vertices[1]}, 0.5});
  EXPECT_EQ(added.vertices, std::vector<int>{simulation.sheet().vertexCount() - 1});
  EXPECT_EQ(added.revision, simulation.sheet().revision());
}

}  // namespace
}  // namespace shell_origami
