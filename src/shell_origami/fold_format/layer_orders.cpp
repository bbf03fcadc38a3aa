#include <shell_origami/fold_format/layer_orders.h>

#include <algorithm>

namespace shell_origami {
namespace {

/// A point inside each face, and whether its normal points up in the pattern's plane.
struct FacePlaces {
  std::vector<Vector2> inside;
  std::vector<bool> up;

  FacePlaces(const std::vector<std::vector<int>>& faces, const std::vector<Vector2>& points) {
    for (std::vector<int> face : faces) {
      up.push_back(polygonArea(points, face) > 0);
      if (!up.back()) std::reverse(face.begin(), face.end());
      std::vector<Vector2> polygon;
      for (int v : face) polygon.push_back(points[v]);
      inside.push_back(pointInside(polygon));
    }
  }
};

/// Of points that lie in triangles, far from their sides [part of the sheet].
constexpr double kOffPaper = 1e-9;

}  // namespace

std::vector<LayerOrder> readLayerOrders(const FoldDocument& document,
                                        const CreasePattern& pattern) {
  int frame = document.frameCount() - 1;
  const auto states = [&](int f) {
    return document.hasOwn(f, "faceOrders") && document.descendsFrom(f, pattern.frame) &&
           document.sharesMesh(f, pattern.frame);
  };
  while (frame >= 0 && !states(frame)) --frame;
  if (frame < 0) return {};
  const auto faces = document.faces(pattern.frame, static_cast<int>(pattern.points.size()));
  const auto stated = document.faceOrders(frame, faces.size());
  const FacePlaces places(faces, pattern.points);
  std::vector<LayerOrder> orders;
  for (const auto& [f, g, side] : stated) {
    orders.push_back({places.inside[f], places.inside[g], places.up[g] ? side : -side});
  }
  return orders;
}

nlohmann::json layerOrdersOf(const Sheet& sheet) {
  nlohmann::json orders = nlohmann::json::array();
  const double tolerance = kOffPaper * sheet.size();
  int near = 0;
  const auto triangleAt = [&](const Vector2& p) {
    return near = sheet.triangulation().locateNear(p, tolerance, near).value().triangle;
  };
  for (const LayerOrder& order : sheet.layerOrders()) {
    const int first = triangleAt(order.first), second = triangleAt(order.second);
    orders.push_back({first, second, order.side});
  }
  return orders;
}

}  // namespace shell_origami
