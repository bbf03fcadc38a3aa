#include <shell_origami/origami/compliance.h>

#include <shell_origami/sheet/rigid_panels.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace shell_origami {
namespace {

/// Softness of a fold of a pattern that leads through angles at which rigid panels do not close.
constexpr double kPatternFactor = 1000;
/// Creases are stiffer by the power of the membrane's softness with this exponent.
constexpr double kCreaseExponent = 0.25;
constexpr double kSofteningTime = 0.1, kHardeningTime = 0.5;  ///< [s]
/// A step that fails with a soft membrane is tried again with one stiffer by this factor.
constexpr double kStiffening = 4;
/// Panels close where less than this is left [rad]: files round their angles.
constexpr double kClosed = 0.02;

/// Whether the panels of a pattern close around every vertex at which folds start now, at some
/// angles on their way. Free creases adapt: with one of them a vertex is taken to close.
bool closeOnTheWay(const Sheet& sheet, const std::vector<FoldRamp>& ramps, double time) {
  std::set<int> starting, adapting;
  for (std::size_t i = 0; i < ramps.size(); ++i) {
    const std::vector<int>& vertices = sheet.creases()[i].vertices;
    if (!ramps[i].driven) adapting.insert(vertices.begin(), vertices.end());
    else if (ramps[i].of_pattern && ramps[i].start == time) {
      starting.insert(vertices.begin(), vertices.end());
    }
  }
  for (const double part : {0.25, 0.5, 0.75, 1.0}) {
    std::vector<double> angles;
    for (const FoldRamp& ramp : ramps) angles.push_back(ramp.angleAt(time + part * ramp.duration));
    for (int v : starting) {
      if (!adapting.count(v) && closingError(sheet, v, angles) > kClosed) return false;
    }
  }
  return true;
}

/// The corners of creases' edges.
std::vector<bool> onCrease(const Shell& shell) {
  std::vector<bool> on(shell.vertexCount(), false);
  for (const Hinge& hinge : shell.hinges()) {
    if (hinge.crease < 0) continue;
    on[hinge.vertices[0]] = on[hinge.vertices[1]] = true;
  }
  return on;
}

}  // namespace

const std::map<std::string, CompliantRegion>& compliantRegionNames() {
  static const std::map<std::string, CompliantRegion> names{{"creases", CompliantRegion::kCreases},
                                                            {"sheet", CompliantRegion::kSheet}};
  return names;
}

double complianceOf(const ComplianceConfig& config, const Sheet& sheet,
                    const std::vector<FoldRamp>& ramps, double time) {
  if (std::none_of(ramps.begin(), ramps.end(), [time](const FoldRamp& ramp) {
        return ramp.start == time && ramp.runningAt(time);
      })) {
    return 1;
  }
  if (config.factor > 0) return config.factor;
  return closeOnTheWay(sheet, ramps, time) ? 1 : kPatternFactor;
}

void Compliance::start(double factor) {
  factor_ = std::max(factor, soft() ? factor_ : 1);
  folding_ = factor_ > 1;
}

void Compliance::advance(bool folding, double duration) {
  folding_ = folding_ && folding;
  const double change = folding_ ? duration / kSofteningTime : -duration / kHardeningTime;
  level_ = std::clamp(level_ + change, 0.0, 1.0);
}

bool Compliance::stiffen() {
  if (!soft() || factor_ == 1) return false;
  factor_ = std::max(1.0, factor_ / kStiffening);
  return true;
}

double Compliance::creaseFactor() const { return std::pow(factor_, kCreaseExponent * level_); }

void Compliance::apply(CompliantRegion where, const Shell& shell, RestState& rest) const {
  std::fill(rest.membrane.begin(), rest.membrane.end(), 1);
  if (!soft()) return;
  const double part = std::pow(factor_, -level_);
  const std::vector<bool> on_crease = onCrease(shell);
  for (std::size_t i = 0; i < rest.membrane.size(); ++i) {
    const Triangle& t = shell.triangles()[i];
    if (where == CompliantRegion::kSheet || on_crease[t[0]] || on_crease[t[1]] || on_crease[t[2]]) {
      rest.membrane[i] = part;
    }
  }
}

}  // namespace shell_origami
