#include <shell_origami/origami/crease_actuation.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// A free crease has this part of a crease's stiffness: it follows whatever pulls at it.
constexpr double kFreeCreaseSoftness = 0.01;
/// It gives way, too: where it rests creeps to where it is within this time [s]. Held at rest flat
/// it would bend the panels beside it by tens of degrees, towards the half turn.
constexpr double kCreepTime = 0.05;
/// Flat paper may go either of two ways at a vertex. So that it goes its pattern's, a free crease
/// of which the pattern asks for a mountain or a valley leans to that side, as stiff as any, while
/// the folds begin: by this part of the farthest one's angle, and no farther than this [rad]. Where
/// it leaned more than it will have to fold (0.71 of the others in a waterbomb base) the vertex
/// would pop the wrong way; half would not turn every fast vertex of four.
constexpr double kLean = 0.6;
constexpr double kMostLean = 2 * M_PI / 180;

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
                            double stiffness, const Shell& shell, const Positions& positions) {
  FoldRamp& ramp = ramps_[crease];
  ramp.from = ramp.driven ? ramp.angleAt(time) : meanAngle(crease, shell, positions);
  ramp.driven = true;
  ramp.set = 0;
  ramp.target = target;
  ramp.start = time;
  ramp.duration = duration;
  ramp.stiffness = stiffness;
}

void CreaseActuation::synchronize(double time) {
  // Of the ramps that begin now, the one of each duration and direction that goes farthest.
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

void CreaseActuation::creep(double time, double duration, const Sheet& sheet, const Shell& shell,
                            const Positions& positions) {
  double farthest = 0;
  for (const FoldRamp& ramp : ramps_) {
    if (ramp.driven) farthest = std::max(farthest, std::abs(ramp.angleAt(time)));
  }
  const double lean = std::min(kLean * farthest, kMostLean);
  const double part = 1 - std::exp(-duration / kCreepTime);
  for (std::size_t i = 0; i < ramps_.size(); ++i) {
    FoldRamp& ramp = ramps_[i];
    if (ramp.driven) continue;
    const double asked = sheet.creases()[i].pattern_angle;  // NaN: nothing
    const double side = asked > 0 ? 1 : asked < 0 ? -1 : 0;
    const double angle = meanAngle(static_cast<int>(i), shell, positions);
    const bool leans = side != 0 && lean > 0 && side * angle < lean;
    ramp.target = leans ? side * lean : ramp.target + part * (angle - ramp.target);
    ramp.stiffness = leans ? stiffness_ : kFreeCreaseSoftness * stiffness_;
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

void CreaseActuation::apply(double time, const Shell& shell, RestState& rest) const {
  for (std::size_t i = 0; i < ramps_.size(); ++i) {
    shell.setCrease(static_cast<int>(i), ramps_[i].angleAt(time), ramps_[i].stiffness, rest);
  }
}

}  // namespace shell_origami
