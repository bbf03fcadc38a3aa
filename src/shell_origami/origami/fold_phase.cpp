#include <shell_origami/origami/fold_phase.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <variant>

namespace shell_origami {
namespace {

/// A landmark is at a vertex that is nearer than this part of the sheet's size.
constexpr double kAtVertex = 0.008;
/// A crease of a manoeuvre that is farther from its angle has failed [rad].
constexpr double kFarOff = 0.35;
/// A crease that is to have a smaller angle is flat [rad].
constexpr double kFlat = 0.1;
/// A crease that is to have a larger angle is shut [rad].
constexpr double kShut = 2.5;

}  // namespace

double lengthOf(const FoldPhase& phase) {
  double longest = 0;
  for (const FoldEdit& fold : phase.folds) longest = std::max(longest, fold.duration.value_or(0));
  return longest + phase.rest;
}

std::vector<std::string> failuresOf(const std::vector<FoldEdit>& folds,
                                    const Simulation& simulation) {
  std::vector<std::string> failures;
  const std::vector<CreaseStatus> creases = simulation.creases();
  for (const FoldEdit& fold : folds) {
    for (int i : creasesAlong(simulation.sheet(), std::get<Segment>(fold.where))) {
      const CreaseStatus& crease = creases[i];
      if (std::abs(crease.angle - fold.angle) < kFarOff) continue;
      std::ostringstream sentence;
      sentence << "crease " << crease.name << " is at " << crease.angle * 180 / M_PI << " of "
               << fold.angle * 180 / M_PI << " degrees";
      failures.push_back(sentence.str());
    }
  }
  return failures;
}

FoldEdit lineFold(const Segment& line, double angle, double duration) {
  FoldEdit fold;
  fold.where = line;
  fold.angle = angle;
  fold.duration = duration;
  return fold;
}

int outlineVertexAt(const Landmark& landmark, const char* what, const Sheet& sheet) {
  const Vector2 point = flatPoint(landmark, sheet);
  int nearest = -1;
  double least = kAtVertex * sheet.size();
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const double distance = (sheet.flatPositions()[v] - point).norm();
    if (distance >= least || !sheet.triangulation().onBorder(v)) continue;
    nearest = v;
    least = distance;
  }
  if (nearest < 0) {
    reject(what, " (", point.x(), ", ", point.y(), ") is not on the edge of the paper");
  }
  return nearest;
}

FoldedCreases foldedCreases(const Simulation& simulation) {
  std::vector<bool> folded;
  for (const CreaseStatus& crease : simulation.creases()) {
    folded.push_back(std::abs(crease.target_angle) > kFlat);
  }
  return {simulation.sheet(), std::move(folded)};
}

double shutAngle(int crease, const Simulation& simulation) {
  const CreaseStatus status = simulation.creases()[crease];
  if (std::abs(status.target_angle) < kShut) {
    reject("crease ", status.name, " is folded to ", status.target_angle * 180 / M_PI,
           " degrees, and must be shut first");
  }
  return status.target_angle;
}

}  // namespace shell_origami
