#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/crease_pattern.h>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

double signedArea(const std::vector<Vector2>& polygon) {
  double doubled = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    doubled += doubleArea(polygon[0], polygon[i - 1], polygon[i]);
  }
  return doubled / 2;
}

/// The neighbours of each vertex along the border.
std::vector<std::vector<int>> borderNeighbours(const CreasePattern& pattern) {
  std::vector<std::vector<int>> neighbours(pattern.points.size());
  for (const PatternEdge& edge : pattern.edges) {
    if (!edge.isBorder()) continue;
    neighbours[edge.vertices[0]].push_back(edge.vertices[1]);
    neighbours[edge.vertices[1]].push_back(edge.vertices[0]);
  }
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    const std::size_t count = neighbours[v].size();
    if (count == 0 || count == 2) continue;
    reject("the outline ", count == 1 ? "ends" : "meets itself", " at ",
           pattern.vertexName(static_cast<int>(v)));
  }
  return neighbours;
}

/// Crossings among some of the edges. \throws std::invalid_argument naming two
void checkCrossings(const CreasePattern& pattern, bool border_only) {
  PlanarGraph graph;
  graph.points = pattern.points;
  std::vector<const PatternEdge*> edges;
  for (const PatternEdge& edge : pattern.edges) {
    if (border_only && !edge.isBorder()) continue;
    edges.push_back(&edge);
    graph.segments.push_back(edge.vertices);
  }
  if (const auto pair = crossingSegments(graph)) {
    reject(pattern.edgeName(*edges[(*pair)[0]]), " and ", pattern.edgeName(*edges[(*pair)[1]]),
           " cross or touch between their ends");
  }
}

}  // namespace

double Outline::area() const {
  double area = std::abs(signedArea(border));
  for (const auto& hole : holes) area -= std::abs(signedArea(hole));
  return area;
}

bool Outline::contains(const Vector2& p) const {
  return polygonContains(border, p, 0) &&
         std::none_of(holes.begin(), holes.end(),
                      [&p](const auto& hole) { return polygonContains(hole, p, 0); });
}

Outline traceOutline(const CreasePattern& pattern) {
  checkCrossings(pattern, true);
  const auto neighbours = borderNeighbours(pattern);
  std::vector<std::vector<Vector2>> loops;
  std::vector<bool> passed(neighbours.size());
  for (std::size_t start = 0; start < neighbours.size(); ++start) {
    if (neighbours[start].empty() || passed[start]) continue;
    loops.emplace_back();
    for (int before = -1, v = static_cast<int>(start); !passed[v];) {
      passed[v] = true;
      loops.back().push_back(pattern.points[v]);
      const int next = neighbours[v][0] != before ? neighbours[v][0] : neighbours[v][1];
      before = v;
      v = next;
    }
  }
  if (loops.empty()) reject("its border edges (B) enclose no paper");
  const auto largest = std::max_element(loops.begin(), loops.end(), [](auto& a, auto& b) {
    return std::abs(signedArea(a)) < std::abs(signedArea(b));
  });
  std::iter_swap(loops.begin(), largest);
  Outline outline{loops.front(), {}};
  for (std::size_t i = 1; i < loops.size(); ++i) {
    if (!outline.contains(loops[i].front())) reject("holds more than one sheet of paper");
    outline.holes.push_back(loops[i]);
  }
  return outline;
}

void checkEdges(const CreasePattern& pattern, const Outline& outline) {
  checkCrossings(pattern, false);
  for (const PatternEdge& edge : pattern.edges) {
    if (edge.isBorder()) continue;
    const auto [a, b] = edge.vertices;
    const Vector2 middle = (pattern.points[a] + pattern.points[b]) / 2;
    if (!outline.contains(middle)) reject(pattern.edgeName(edge), " lies off the paper");
  }
}

Vector2 pointInside(const std::vector<Vector2>& polygon) {
  // The leftmost corner is convex. The diagonal from there to the corner that reaches farthest
  // into its triangle stays inside; without such a corner the triangle is all inside.
  const std::size_t count = polygon.size();
  std::size_t v = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (std::make_pair(polygon[i].x(), polygon[i].y()) <
        std::make_pair(polygon[v].x(), polygon[v].y())) {
      v = i;
    }
  }
  const Vector2 &corner = polygon[v], &a = polygon[(v + count - 1) % count],
                &b = polygon[(v + 1) % count];
  const std::vector<Vector2> ear{corner, b, a};
  const Vector2 base = (b - a).normalized();
  double deepest = 0;
  Vector2 inside = (corner + a + b) / 3;
  for (const Vector2& p : polygon) {
    if (p == corner || p == a || p == b || !polygonContains(ear, p, 0)) continue;
    const double depth = std::abs(cross(base, p - a));
    if (depth <= deepest) continue;
    deepest = depth;
    inside = (corner + p) / 2;
  }
  return inside;
}

}  // namespace shell_origami
