#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>
#include "test/fuzz/fuzz.h"
#include "test/fuzz/whole.h"
#include "test/sheet/random_sheets.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace shell_origami {
namespace {

/// A point of the paper may move where an edge was flipped or a vertex shifted on paper that is
/// bent there, by 0.02 rad at most: by a quarter of the quadrilateral's diagonal (sqrt(3) edges)
/// times that, once for each flip on top of another, of which four are seen.
constexpr double kMostMoved = 4 * 0.25 * 1.7320508 * 0.02;  // times max_edge

/// Where points of the flat sheet are in space.
struct Material {
  Sheet sheet;
  Positions positions;

  Vector3 at(const Vector2& flat) const {
    const auto place = sheet.triangulation().locate(flat, 1e-6 * sheet.size());
    const Triangle& t = sheet.triangles()[place->triangle];
    Vector3 point = Vector3::Zero();
    for (int k = 0; k < 3; ++k) point += place->weights[k] * positions.col(t[k]);
    return point;
  }
};

struct Seen {
  int folds = 0, along_border = 0, too_small = 0, unconverged = 0, slivers = 0;
  long points = 0, moved = 0, steps = 0, iterations = 0, retries = 0;
  double farthest = 0;  ///< as a part of the sheet's max_edge
};

void require(bool kept, const char* promise) {
  if (!kept) throw std::logic_error(promise);
}

void compare(const Material& before, const Material& after, double max_edge, Seen& seen) {
  for (const Vector2& flat : before.sheet.flatPositions()) {
    const double distance = (after.at(flat) - before.at(flat)).norm();
    ++seen.points;
    seen.moved += distance > 1e-9 * before.sheet.size();
    seen.farthest = std::max(seen.farthest, distance / max_edge);
  }
  require(seen.farthest < kMostMoved, "a point of the paper moved too far");
}

void foldOneSheet(RandomSheets& random, int most, Seen& seen) {
  const double max_edge = random.between(0.012, 0.032);
  Simulation simulation(Sheet(triangulate(random.outline(), max_edge)), {});
  const double area = simulation.sheet().area(), border = borderLength(simulation.sheet());
  const int count = std::min(most, 1 + random.below(12));
  for (int i = 0; i < count; ++i) {
    ++seen.folds;
    FoldEdit request;
    request.where = random.line(simulation.sheet());
    request.angle = random.between(-175, 175) * M_PI / 180;
    request.duration = random.between(0.3, 1);
    const Material before{simulation.sheet(), simulation.positions()};
    try {
      simulation.fold(request);
    } catch (const std::invalid_argument& refusal) {
      const std::string message = refusal.what();
      const bool is_too_small = message.find("the shortest possible is") != std::string::npos;
      require(is_too_small || message == "the line runs along the border of the paper",
              refusal.what());
      ++(is_too_small ? seen.too_small : seen.along_border);
      continue;
    }
    const Sheet& sheet = simulation.sheet();
    sheet.validate();
    require(std::abs(sheet.area() / area - 1) < 1e-12, "the area changed");
    require(std::abs(borderLength(sheet) / border - 1) < 1e-12, "the outline changed");
    seen.slivers += unforcedSlivers(sheet, max_edge);
    compare(before, {sheet, simulation.positions()}, max_edge, seen);
    for (int k = 2 + random.below(8); k > 0; --k) seen.unconverged += !simulation.step().converged;
    checkWhole(simulation);
  }
  seen.steps += static_cast<long>(simulation.counters().steps);
  seen.iterations += static_cast<long>(simulation.counters().newton_iterations);
  seen.retries += static_cast<long>(simulation.counters().retries);
}

}  // namespace

bool fuzzFolds(int folds, unsigned seed) {
  RandomSheets random(seed);
  Seen seen;
  bool kept = true;
  while (kept && seen.folds < folds) {
    try {
      foldOneSheet(random, folds - seen.folds, seen);
    } catch (const std::logic_error& broken) {
      std::printf("fold %d: %s\n", seen.folds, broken.what());
      kept = false;
    }
  }
  std::printf(
      "%d folds, %d rejected along the border, %d for an edge too short; %ld of %ld points moved, "
      "by %.2g of max_edge "
      "at most (bound %.2g); %d angles under 15 degrees; %ld steps, %.1f Newton iterations "
      "each, %ld cut in two, %d did not converge\n",
      seen.folds, seen.along_border, seen.too_small, seen.moved, seen.points, seen.farthest,
      kMostMoved, seen.slivers, seen.steps, static_cast<double>(seen.iterations) / seen.steps,
      seen.retries, seen.unconverged);
  return kept && seen.slivers == 0;
}

}  // namespace shell_origami
