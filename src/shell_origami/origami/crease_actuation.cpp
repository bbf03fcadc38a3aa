#include <shell_origami/origami/crease_actuation.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// Stiffness of a free crease over that of a driven one: it follows the creases around it.
constexpr double kFreeCreaseSoftness = 0.01;
/// Time constant with which the rest angle of a free crease relaxes to its present angle [s]. With
/// a rest angle of zero it would bend the panels beside it by tens of degrees near the half turn.
constexpr double kRelaxationTime = 0.05;
/// At a vertex flat paper may leave its plane in either of two ways. A free crease that the pattern
/// calls a mountain or a valley is biased to that side, with a driven crease's stiffness, while the
/// folds begin: by this part of the largest fold angle, and by kLargestBias [rad] at most. A bias
/// larger than the angle that the crease will have (0.71 of the others' in a waterbomb base) would
/// pop the vertex the wrong way; with 0.5 some fast vertices of four creases go the wrong way.
constexpr double kBias = 0.6;
constexpr double kLargestBias = 2 * M_PI / 180;

}  // namespace

double meanAngle(int crease, const Shell& shell, const Positions& positions) {
  double weighted = 0, length = 0;
  for (int j : shell.creaseHinges()[crease]) {
    weighted += shell.hinges()[j].length * shell.foldAngle(j, positions);
    length += shell.hinges()[j].length;
  }
  return weighted / length;
}

CreaseActuation::CreaseActuation(const std::vector<double>& rest_angles, double stiffness,
                                 const Shell& shell, const Positions& positions)
    : stiffness_(stiffness) {
  for (std::size_t i = 0; i < rest_angles.size(); ++i) {
    FoldRamp ramp;
    ramp.driven = std::isfinite(rest_angles[i]);
    ramp.stiffness = ramp.driven ? stiffness : kFreeCreaseSoftness * stiffness;
    ramp.target = ramp.driven ? rest_angles[i] : meanAngle(static_cast<int>(i), shell, positions);
    ramps_.push_back(ramp);
  }
}

bool CreaseActuation::runningAt(double time) const {
  return std::any_of(ramps_.begin(), ramps_.end(),
                     [time](const FoldRamp& ramp) { return ramp.runningAt(time); });
}

void CreaseActuation::start(int crease, double target, double time, double duration,
                            double stiffness, bool of_pattern, const Shell& shell,
                            const Positions& positions) {
  FoldRamp& ramp = ramps_[crease];
  ramp.from = ramp.driven ? ramp.angleAt(time) : meanAngle(crease, shell, positions);
  if (ramp.driven && stiffness != ramp.stiffness) {
    const double angle = meanAngle(crease, shell, positions);
    ramp.from = std::clamp(angle + ramp.stiffness / stiffness * (ramp.from - angle),
                           -kLargestRestAngle, kLargestRestAngle);
  }
  ramp.driven = true;
  ramp.set = 0;
  ramp.target = target;
  ramp.start = time;
  ramp.duration = duration;
  ramp.stiffness = stiffness;
  ramp.of_pattern = of_pattern;
}

void CreaseActuation::synchronize(double time) {
  // For each duration and direction the ramp that goes farthest, among those that begin now.
  std::map<std::pair<double, bool>, const FoldRamp*> leads;
  std::vector<FoldRamp*> starting;
  for (FoldRamp& ramp : ramps_) {
    if (!ramp.driven || ramp.start != time) continue;
    starting.push_back(&ramp);
    const FoldRamp*& lead = leads[{ramp.duration, ramp.folds()}];
    if (!lead || ramp.way() > lead->way()) lead = &ramp;
  }
  for (FoldRamp* ramp : starting) {
    const FoldRamp* lead = leads[{ramp->duration, ramp->folds()}];
    if (ramp->way() == lead->way()) lead = ramp;  // one that goes as far follows its own angle
    ramp->lead_from = lead->from;
    ramp->lead_target = lead->target;
  }
}

void CreaseActuation::stop(double time) {
  for (FoldRamp& ramp : ramps_) {
    if (!ramp.runningAt(time)) continue;
    ramp.target = ramp.angleAt(time);
    ramp.duration = 0;
  }
}

void CreaseActuation::relaxFreeCreases(double time, double duration, const Sheet& sheet,
                                       const Shell& shell, const Positions& positions) {
  double farthest = 0;
  for (const FoldRamp& ramp : ramps_) {
    if (ramp.driven) farthest = std::max(farthest, std::abs(ramp.angleAt(time)));
  }
  const double bias = std::min(kBias * farthest, kLargestBias);
  const double part = 1 - std::exp(-duration / kRelaxationTime);
  for (std::size_t i = 0; i < ramps_.size(); ++i) {
    FoldRamp& ramp = ramps_[i];
    if (ramp.driven) continue;
    const double asked = sheet.creases()[i].pattern_angle;  // NaN: nothing
    const double side = asked > 0 ? 1 : asked < 0 ? -1 : 0;
    const double angle = meanAngle(static_cast<int>(i), shell, positions);
    const bool biased = side != 0 && bias > 0 && side * angle < bias;
    ramp.target = biased ? side * bias : ramp.target + part * (angle - ramp.target);
    ramp.stiffness = biased ? stiffness_ : kFreeCreaseSoftness * stiffness_;
  }
}

void CreaseActuation::yield(double time, const Material& material, const Shell& shell,
                            const Positions& positions) {
  if (material.yield_curvature == 0) return;
  const double most = material.bendingStiffness() * material.yield_curvature;  // moment [N*m/m]
  for (std::size_t i = 0; i < ramps_.size(); ++i) {
    FoldRamp& ramp = ramps_[i];
    if (!ramp.driven || ramp.runningAt(time)) continue;
    const double bend = meanAngle(static_cast<int>(i), shell, positions) - ramp.angleAt(time);
    const double bearable = most / ramp.stiffness;
    if (std::abs(bend) > bearable) ramp.set += bend - std::copysign(bearable, bend);
  }
}

void CreaseActuation::follow(const Remap& remap, const std::vector<Crease>& before,
                             const std::vector<Crease>& after) {
  std::vector<FoldRamp> ramps;
  for (const Crease& crease : after) {
    std::uint32_t ancestor = crease.id;
    for (const Remap::Born& born : remap.born) {
      if (born.crease == crease.id) ancestor = born.parent;
    }
    const auto old = std::find_if(before.begin(), before.end(),
                                  [&](const Crease& c) { return c.id == ancestor; });
    ramps.push_back(old == before.end() ? FoldRamp{} : ramps_[old - before.begin()]);
  }
  ramps_ = std::move(ramps);
}

void CreaseActuation::apply(double time, double factor, const Shell& shell, RestState& rest) const {
  for (std::size_t i = 0; i < ramps_.size(); ++i) {
    const FoldRamp& ramp = ramps_[i];
    shell.setCrease(static_cast<int>(i), ramp.angleAt(time), factor * ramp.stiffness, rest);
  }
}

}  // namespace shell_origami
