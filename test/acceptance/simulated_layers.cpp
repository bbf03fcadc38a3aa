#include "test/acceptance/simulated_layers.h"

#include <shell_origami/base/error.h>
#include <shell_origami/origami/viewed_paper.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

namespace shell_origami {
namespace {

/// A crease may be so far from shut or flat [rad]: those around other layers stay open by degrees.
constexpr double kNearlyShut = 0.5;

/// The paper in space, seen along the stack.
struct Seen {
  std::vector<Vector2> places;
  std::vector<double> heights;
};

/// The direction in which panels lie above each other, the mean of their upper sides' normals.
Vector3 upwards(const Sheet& sheet, const Positions& x, const FlatFold& fold) {
  Vector3 sum = Vector3::Zero();
  for (const FlatPanel& panel : fold.panels) {
    for (int t : panel.triangles) {
      sum += (panel.front_up ? 1 : -1) * areaNormal(sheet.triangles()[t], x);
    }
  }
  return sum.normalized();
}

Seen seenFromAbove(const Positions& x, const Vector3& up) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(up, Vector3::UnitZ());
  const Positions turned = turn.toRotationMatrix() * x;
  Seen seen;
  for (int v = 0; v < turned.cols(); ++v) {
    seen.places.push_back(turned.col(v).head<2>());
    seen.heights.push_back(turned(2, v));
  }
  return seen;
}

/// The height of a triangle at a place, where it need not be inside.
double heightAt(const Vector2& p, const Triangle& t, const Seen& seen) {
  const Vector2 &a = seen.places[t[0]], &b = seen.places[t[1]], &c = seen.places[t[2]];
  return (doubleArea(p, b, c) * seen.heights[t[0]] + doubleArea(a, p, c) * seen.heights[t[1]] +
          doubleArea(a, b, p) * seen.heights[t[2]]) /
         doubleArea(a, b, c);
}

Polygon outlineOf(const Triangle& t, const Seen& seen) {
  const Vector2 &a = seen.places[t[0]], &b = seen.places[t[1]], &c = seen.places[t[2]];
  return doubleArea(a, b, c) > 0 ? Polygon{a, b, c} : Polygon{a, c, b};
}

class Comparison {
 public:
  Comparison(const Sheet& sheet, const Positions& x, const FlatFold& fold)
      : sheet_(sheet), fold_(fold), seen_(seenFromAbove(x, upwards(sheet, x, fold))) {}

  void add(const std::array<int, 2>& pair, SimulatedLayers& layers) const {
    const auto& [a, b] = pair;
    std::optional<Vector2> above, below;
    for (int s : fold_.panels[a].triangles) {
      for (int t : fold_.panels[b].triangles) compare(s, t, above, below);
    }
    layers.stacking.push_back(above.has_value() - below.has_value());
    if (layers.stacking.back() != 0) return;
    std::ostringstream sentence;
    sentence << "panels " << a << " and " << b;
    if (above) {
      sentence << " pass each other between (" << above->transpose() << ") and ("
               << below->transpose() << ") of the flat sheet";
    } else {
      sentence << " lie beside each other";
    }
    layers.faults.push_back(sentence.str());
  }

 private:
  /// Notes where on the flat sheet the triangle s lies above t, or below.
  void compare(int s, int t, std::optional<Vector2>& above, std::optional<Vector2>& below) const {
    const Triangle &one = sheet_.triangles()[s], &other = sheet_.triangles()[t];
    const Polygon both = clip(outlineOf(one, seen_), outlineOf(other, seen_));
    if (areaOf(both) < fold_.tolerance * fold_.tolerance) return;
    const Vector2 sum = std::accumulate(both.begin(), both.end(), Vector2(0, 0));
    const Vector2 place = sum / both.size();
    const bool is_above = heightAt(place, one, seen_) > heightAt(place, other, seen_);
    (is_above ? above : below) = sheet_.triangulation().centroid(s);
  }

  const Sheet& sheet_;
  const FlatFold& fold_;
  Seen seen_;
};

}  // namespace

FlatFold foldFlat(const Simulation& simulation) {
  std::vector<double> angles;
  for (const CreaseStatus& crease : simulation.creases()) {
    const double flat = std::round(crease.angle / M_PI) * M_PI;
    if (std::abs(crease.angle - flat) > kNearlyShut) {
      reject("crease ", crease.name, " is open: its angle is ", crease.angle * 180 / M_PI,
             " degrees");
    }
    angles.push_back(flat);
  }
  return foldFlat(simulation.sheet(), angles);
}

SimulatedLayers simulatedLayers(const Sheet& sheet, const Positions& positions,
                                const FlatFold& fold, const LayerConditions& conditions) {
  const Comparison comparison(sheet, positions, fold);
  SimulatedLayers layers;
  for (const std::array<int, 2>& pair : conditions.pairs) comparison.add(pair, layers);
  return layers;
}

std::vector<std::string> layerFaults(const Simulation& simulation) {
  const FlatFold fold = foldFlat(simulation);
  const LayerConditions conditions = layerConditions(fold);
  SimulatedLayers layers =
      simulatedLayers(simulation.sheet(), simulation.positions(), fold, conditions);
  const std::vector<std::string> more = broken(conditions, layers.stacking);
  layers.faults.insert(layers.faults.end(), more.begin(), more.end());
  return layers.faults;
}

}  // namespace shell_origami
