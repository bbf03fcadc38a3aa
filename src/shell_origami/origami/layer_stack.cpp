#include <shell_origami/origami/layer_stack.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace shell_origami {
namespace {

/// A corner of the paper is seen although rounding puts it beside its triangles by this part of
/// their size.
constexpr double kBeside = 1e-9;
/// Two triangles of one panel that are hit within this depth of each other are one layer [m].
constexpr double kSameDepth = 1e-6;
/// Cosine of the angle to a triangle's normal below which a direction looks along the paper.
constexpr double kAlong = 0.1;

/// Leaves one of each panel's layers that were seen through several triangles.
void mergeTriangles(std::vector<StackedLayer>& layers) {
  std::vector<StackedLayer> kept;
  for (const StackedLayer& layer : layers) {
    const bool seen = std::any_of(kept.begin(), kept.end(), [&](const StackedLayer& other) {
      return other.panel == layer.panel && layer.depth - other.depth < kSameDepth;
    });
    if (!seen) kept.push_back(layer);
  }
  layers = std::move(kept);
}

}  // namespace

std::vector<StackedLayer> layersAt(const Landmark& point, const Viewpoint& view,
                                   const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  const Vector2 flat = flatPoint(point, sheet);
  const ViewedPaper paper = viewedPaper(view, simulation);
  const Vector3 place = pointInSpace(flat, sheet, paper.positions);
  const std::vector<int> panels = panelOfTriangle(sheet);
  std::vector<StackedLayer> layers;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Triangle& t = sheet.triangles()[i];
    const std::optional<Vector3> weights = weightsSeen(place, t, paper);
    if (!weights || weights->minCoeff() < -kBeside) continue;
    StackedLayer layer{panels[i], Vector2::Zero(), 0};
    for (int k = 0; k < 3; ++k) {
      layer.flat += (*weights)[k] * sheet.flatPositions()[t[k]];
      layer.depth -= (*weights)[k] * paper.heights[t[k]];
    }
    layers.push_back(layer);
  }
  std::sort(layers.begin(), layers.end(), [](const StackedLayer& a, const StackedLayer& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.panel < b.panel;
  });
  mergeTriangles(layers);
  const double front = layers.empty() ? 0 : layers.front().depth;
  for (StackedLayer& layer : layers) layer.depth -= front;
  return layers;
}

Viewpoint viewFrom(const Vector3& from, const Simulation& simulation) {
  if (!from.allFinite() || from.isZero(0)) {
    reject("viewer is (", from.x(), ", ", from.y(), ", ", from.z(),
           "), but must be a direction from the paper");
  }
  const Sheet& sheet = simulation.sheet();
  const Positions& x = simulation.positions();
  int facing = 0;
  double most = 0, cosine = 0;
  for (std::size_t i = 0; i < sheet.triangles().size(); ++i) {
    const Triangle& t = sheet.triangles()[i];
    const Vector3 normal = areaNormal(t, x);
    const double faces = normal.dot(from.normalized());
    if (std::abs(faces) <= std::abs(most)) continue;
    most = faces;
    cosine = faces / normal.norm();
    facing = static_cast<int>(i);
  }
  if (std::abs(cosine) < kAlong) {
    reject("viewer is (", from.x(), ", ", from.y(), ", ", from.z(),
           "), from where only the paper's edges are seen");
  }
  return {sheet.triangulation().centroid(facing), most > 0};
}

}  // namespace shell_origami
