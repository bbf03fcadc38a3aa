#include <shell_origami/fold_format/crease_pattern.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace shell_origami {
namespace {

/// Sets of numbers, each represented by its smallest (union-find).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  int find(int i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void unite(int i, int j) {
    const auto [first, second] = std::minmax({find(i), find(j)});
    parents_[second] = first;
  }

 private:
  std::vector<int> parents_;
};

/// The vertices of border edges, from left to right.
std::vector<int> borderVertices(const CreasePattern& pattern) {
  std::vector<int> vertices;
  for (const PatternEdge& edge : pattern.edges) {
    if (!edge.isBorder()) continue;
    vertices.insert(vertices.end(), edge.vertices.begin(), edge.vertices.end());
  }
  const auto left = [&pattern](int v, int w) {
    return std::make_pair(pattern.points[v].x(), v) < std::make_pair(pattern.points[w].x(), w);
  };
  std::sort(vertices.begin(), vertices.end(), left);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// The edge's ends and, in order between them, those of the vertices that lie on it.
std::vector<int> chainAlong(const PatternEdge& edge, const std::vector<int>& vertices,
                            const std::vector<Vector2>& points, double tolerance) {
  const auto [a, b] = edge.vertices;
  const Vector2 &from = points[a], &to = points[b];
  const auto [left, right] = std::minmax({from.x(), to.x()});
  auto v = std::lower_bound(vertices.begin(), vertices.end(), left - tolerance,
                            [&points](int w, double x) { return points[w].x() < x; });
  std::vector<int> between;
  for (; v != vertices.end() && points[*v].x() <= right + tolerance; ++v) {
    if (*v == a || *v == b || distanceToSegment(points[*v], from, to) > tolerance) continue;
    between.push_back(*v);
  }
  std::sort(between.begin(), between.end(),
            [&](int v, int w) { return (to - from).dot(points[v] - points[w]) < 0; });
  std::vector<int> chain{a};
  chain.insert(chain.end(), between.begin(), between.end());
  chain.push_back(b);
  return chain;
}

}  // namespace

double extentOf(const std::vector<Vector2>& points) {
  Eigen::AlignedBox2d box;
  for (const Vector2& p : points) box.extend(p);
  return points.empty() ? 0 : box.sizes().maxCoeff();
}

Vector2 lowerLeft(const std::vector<Vector2>& points) {
  Vector2 corner = points.empty() ? Vector2(0, 0) : points[0];
  for (const Vector2& p : points) corner = corner.cwiseMin(p);
  return corner;
}

double coincidence(const std::vector<Vector2>& points) { return 1e-9 * extentOf(points); }

std::vector<int> mergeCoincident(const std::vector<Vector2>& points) {
  const double tolerance = coincidence(points);
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int i, int j) { return points[i].x() < points[j].x(); });
  DisjointSets sets(points.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Vector2& p = points[order[n]];
    for (std::size_t m = n + 1; m < order.size(); ++m) {
      const Vector2& q = points[order[m]];
      if (q.x() > p.x() + tolerance) break;
      if ((q - p).norm() <= tolerance) sets.unite(order[n], order[m]);
    }
  }
  std::vector<int> stand_in(points.size());
  for (std::size_t v = 0; v < stand_in.size(); ++v) stand_in[v] = sets.find(static_cast<int>(v));
  return stand_in;
}

namespace {

/// Names each vertex by the one that stands for it.
void mergeVertices(CreasePattern& pattern) {
  const std::vector<int> stand_in = mergeCoincident(pattern.points);
  for (PatternEdge& edge : pattern.edges) {
    for (int& v : edge.vertices) v = stand_in[v];
  }
  for (NotedCrease& crease : pattern.noted) {
    for (int& v : crease.vertices) v = stand_in[v];
  }
}

/// Makes one cut of border edges that lie on each other, at least in part: the sides of a slit may
/// have their vertices at different places.
void mergeEdges(CreasePattern& pattern) {
  const double tolerance = coincidence(pattern.points);
  const std::vector<int> border = borderVertices(pattern);
  std::vector<PatternEdge> edges;
  edges.swap(pattern.edges);
  EdgeCollector collector(pattern);
  for (PatternEdge edge : edges) {
    if (!edge.isBorder()) {
      collector.add(edge);
      continue;
    }
    const std::vector<int> chain = chainAlong(edge, border, pattern.points, tolerance);
    for (std::size_t k = 1; k < chain.size(); ++k) {
      edge.vertices = {chain[k - 1], chain[k]};
      const auto other = collector.find(chain[k - 1], chain[k]);
      const bool lies_on_border = other && pattern.edges[*other].isBorder();
      if (lies_on_border) pattern.edges[*other].kind = 'C';
      if (!lies_on_border) collector.add(edge);
    }
  }
}

}  // namespace

CreasePattern closeSlits(const CreasePattern& pattern, bool keep_flat_edges) {
  CreasePattern closed = pattern;
  mergeVertices(closed);
  mergeEdges(closed);
  closed.faces.clear();
  dropUnused(closed, keep_flat_edges);
  return closed;
}

}  // namespace shell_origami
