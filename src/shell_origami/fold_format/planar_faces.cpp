#include <shell_origami/fold_format/planar_faces.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

/// Half-edge 2 e runs along edge e, half-edge 2 e + 1 back.
class HalfEdges {
 public:
  HalfEdges(const std::vector<Vector2>& points, const std::vector<std::array<int, 2>>& edges)
      : points_(points), edges_(edges), after_(2 * edges.size()) {
    std::vector<std::vector<int>> leaving(points.size());
    for (int h = 0; h < count(); ++h) leaving[from(h)].push_back(h);
    for (auto& around : leaving) {
      std::sort(around.begin(), around.end(), [this](int g, int h) { return angle(g) < angle(h); });
      // The face to the left of what arrives against around[k] goes on clockwise from it.
      for (std::size_t k = 0; k < around.size(); ++k) {
        after_[around[k] ^ 1] = around[(k + around.size() - 1) % around.size()];
      }
    }
  }

  int count() const { return static_cast<int>(after_.size()); }
  int from(int h) const { return edges_[h / 2][h % 2]; }
  int after(int h) const { return after_[h]; }
  double area(int h) const {
    const Vector2& origin = points_[0];
    return cross(points_[from(h)] - origin, points_[from(h ^ 1)] - origin) / 2;
  }

 private:
  double angle(int h) const {
    const Vector2 along = points_[from(h ^ 1)] - points_[from(h)];
    return std::atan2(along.y(), along.x());
  }

  const std::vector<Vector2>& points_;
  const std::vector<std::array<int, 2>>& edges_;
  std::vector<int> after_;
};

}  // namespace

int FaceWalks::outermost(double least) const {
  const auto smallest = std::min_element(areas.begin(), areas.end());
  if (smallest == areas.end() || !(*smallest < -least)) return -1;
  return static_cast<int>(smallest - areas.begin());
}

FaceWalks walkFaces(const std::vector<Vector2>& points,
                    const std::vector<std::array<int, 2>>& edges) {
  const HalfEdges half_edges(points, edges);
  FaceWalks walks;
  walks.of_edges.assign(edges.size(), {-1, -1});
  for (int start = 0; start < half_edges.count(); ++start) {
    if (walks.of_edges[start / 2][start % 2] >= 0) continue;
    const int walk = static_cast<int>(walks.areas.size());
    walks.areas.push_back(0);
    for (int h = start; walks.of_edges[h / 2][h % 2] < 0; h = half_edges.after(h)) {
      walks.of_edges[h / 2][h % 2] = walk;
      walks.areas.back() += half_edges.area(h);
    }
  }
  return walks;
}

}  // namespace shell_origami
