#include <shell_origami/rviz/ray_caster.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace shell_origami {
namespace {

/// Part of a box's distance by which it is widened for what rounding shifts.
constexpr double kWidening = 1e-12;

/// Returns the distance, in lengths of the direction, at which a ray enters a box, which may lie
/// behind its origin; infinity where it passes by.
double entry(const Eigen::AlignedBox3d& box, const Ray& ray) {
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double slack = kWidening * (box.min().norm() + box.max().norm() + ray.origin.norm());
    const double low = box.min()[k] - slack - ray.origin[k];
    const double high = box.max()[k] + slack - ray.origin[k];
    if (ray.direction[k] == 0) {
      if (low > 0 || high < 0) return std::numeric_limits<double>::infinity();
      continue;
    }
    const double a = low / ray.direction[k], b = high / ray.direction[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last ? first : std::numeric_limits<double>::infinity();
}

}  // namespace

RayCaster::RayCaster(const std::vector<Vector2>& flat, std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)) {
  std::vector<Vector2> centers;
  for (const auto& [a, b, c] : triangles_) centers.push_back((flat[a] + flat[b] + flat[c]) / 3);
  std::vector<int> order(centers.size());
  std::iota(order.begin(), order.end(), 0);
  nodes_.reserve(2 * order.size());
  if (!order.empty()) divide(centers, order.begin(), order.end());
}

/// Adds the node of these triangles and those below it, halved across the longer side.
void RayCaster::divide(const std::vector<Vector2>& centers, std::vector<int>::iterator begin,
                       std::vector<int>::iterator end) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  if (end - begin == 1) {
    nodes_[node].triangle = *begin;
    return;
  }
  Eigen::AlignedBox2d box;
  for (auto t = begin; t != end; ++t) box.extend(centers[*t]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](int s, int t) {
    return std::make_pair(centers[s][axis], s) < std::make_pair(centers[t][axis], t);
  });
  divide(centers, begin, middle);
  nodes_[node].second = static_cast<int>(nodes_.size());
  divide(centers, middle, end);
}

void RayCaster::follow(const Positions& positions) {
  positions_ = positions;
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    Node& node = nodes_[i];
    node.box.setEmpty();
    if (node.second < 0) {
      for (int v : triangles_[node.triangle]) node.box.extend(positions_.col(v));
    } else {
      node.box = nodes_[i + 1].box.merged(nodes_[node.second].box);
    }
  }
}

std::optional<RayHit> RayCaster::cast(const Ray& ray) const {
  std::optional<RayHit> nearest;
  if (nodes_.empty()) return nearest;
  const Ray unit{ray.origin, ray.direction.stableNormalized()};
  std::vector<int> waiting{0};
  while (!waiting.empty()) {
    const int i = waiting.back();
    waiting.pop_back();
    const double ahead = entry(nodes_[i].box, unit);
    if (!std::isfinite(ahead) || (nearest && ahead > nearest->distance)) continue;
    if (nodes_[i].second < 0) {
      meet(nodes_[i].triangle, unit, nearest);
    } else {
      waiting.push_back(nodes_[i].second);
      waiting.push_back(i + 1);
    }
  }
  return nearest;
}

/// Replaces the nearest hit by that of the triangle where this one is nearer. For an edge that two
/// triangles share they compute the same volume, but for the sign, to the bit.
void RayCaster::meet(int triangle, const Ray& ray, std::optional<RayHit>& nearest) const {
  const Triangle& corners = triangles_[triangle];
  Eigen::Matrix3d p;
  for (int k = 0; k < 3; ++k) p.col(k) = positions_.col(corners[k]) - ray.origin;
  Vector3 volumes;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const bool ordered = corners[a] < corners[b];
    const Vector3 first = p.col(ordered ? a : b), second = p.col(ordered ? b : a);
    volumes[k] = (ordered ? 1 : -1) * first.cross(second).dot(ray.direction);
  }
  if ((volumes.array() < 0).any() && (volumes.array() > 0).any()) return;
  const double sum = volumes.sum();
  if (sum == 0) return;  // seen from its edge
  const Vector3 weights = volumes / sum;
  const Vector3 way = p * weights;
  const double distance = way.dot(ray.direction);
  if (!(distance >= 0)) return;
  if (nearest &&
      std::make_pair(nearest->distance, nearest->triangle) <= std::make_pair(distance, triangle)) {
    return;
  }
  nearest = RayHit{triangle, weights, ray.origin + way, distance};
}

}  // namespace shell_origami
