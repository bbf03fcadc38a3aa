#include <shell_origami/origami/simulation.h>
#include "test/fuzz/fuzz.h"
#include "test/fuzz/whole.h"
#include "test/sheet/random_sheets.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

constexpr int kMostObstacles = 4, kSceneSteps = 60;

Pose randomPose(RandomSheets& random, double reach) {
  const Vector3 axis(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  return {{random.between(-reach, 2 * reach), random.between(-reach, 2 * reach),
           random.between(-reach, reach)},
          Eigen::Quaterniond(Eigen::AngleAxisd(random.between(0, 3), axis.stableNormalized()))};
}

ObstacleShape randomShape(RandomSheets& random) {
  const auto size = [&] { return random.between(0.005, 0.1); };
  switch (random.below(4)) {
    case 0: return Box{{size(), size(), size()}};
    case 1: return Sphere{size()};
    case 2: return Cylinder{size(), size()};
    default: return HalfSpace{};
  }
}

struct Seen {
  int added = 0, refused = 0, stopped = 0, stuck = 0;
};

/// Adds obstacles, a half of which move, some of them far too fast, and a fold.
Simulation randomScene(RandomSheets& random, Seen& seen) {
  SimulationConfig config;
  if (random.below(2) == 0) config.gravity = {0, 0, -9.81};
  config.contact.friction = random.between(0, 1);
  // The sides of a slit pass through each other.
  const double max_edge = random.between(0.02, 0.04);
  Simulation paper(Sheet(triangulate(random.outline(), max_edge)), config);
  const double reach = paper.sheet().size();
  for (int i = 0; i < kMostObstacles; ++i) {
    const std::string id = "o" + std::to_string(i);
    try {
      paper.apply(AddObstacleEdit{id, randomShape(random), randomPose(random, reach), {}, "", {}});
      ++seen.added;
    } catch (const std::invalid_argument&) {
      ++seen.refused;
      continue;
    }
    if (random.below(2) == 0) continue;
    paper.apply(MoveObstacleEdit{id, randomPose(random, reach), random.between(0.05, 1)});
  }
  if (random.below(2) == 0) paper.pin(std::vector<std::int64_t>{0, 1});
  FoldEdit fold;
  fold.where = random.line(paper.sheet());
  fold.angle = random.between(-3, 3);
  fold.duration = random.between(0.1, 0.5);
  paper.fold(fold);
  return paper;
}

void checkScene(const Simulation& paper) {
  checkWhole(paper);
  if (!paper.crossings().empty()) throw std::logic_error("paper passes through paper");
  const std::string cut = paper.cutObstacle();
  if (!cut.empty()) throw std::logic_error("paper is cut by obstacle " + cut);
}

void runScene(RandomSheets& random, Seen& seen) {
  Simulation paper = randomScene(random, seen);
  bool stopped = false;
  for (int i = 0; i < kSceneSteps; ++i) {
    const StepReport report = paper.step();
    checkScene(paper);
    stopped = stopped || paper.stopped();
    if (report.converged) continue;
    if (report.failure.empty()) throw std::logic_error("a step fails without a reason");
    ++seen.stuck;
    break;
  }
  seen.stopped += stopped ? 1 : 0;
}

}  // namespace

bool fuzzObstacles(int scenes, unsigned seed) {
  Seen seen;
  for (int i = 0; i < scenes; ++i) {
    RandomSheets random(seed + static_cast<unsigned>(i));
    try {
      runScene(random, seen);
    } catch (const std::exception& broken) {
      std::printf("scene %d, seed %u: %s\n", i, seed + static_cast<unsigned>(i), broken.what());
      return false;
    }
  }
  std::printf(
      "%d scenes of %d obstacles, %d refused: obstacles slowed or stopped in %d, paper stuck in "
      "%d\n",
      scenes, seen.added, seen.refused, seen.stopped, seen.stuck);
  return true;
}

}  // namespace shell_origami
