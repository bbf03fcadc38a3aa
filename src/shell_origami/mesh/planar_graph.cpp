#include <shell_origami/mesh/planar_graph.h>

#include <shell_origami/base/error.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shell_origami {
namespace {

/// Whether two segments without a shared end meet, or come closer than the tolerance.
bool meet(const Segment& s, const Segment& t, double tolerance) {
  const double s0 = doubleArea(t[0], t[1], s[0]), s1 = doubleArea(t[0], t[1], s[1]);
  const double t0 = doubleArea(s[0], s[1], t[0]), t1 = doubleArea(s[0], s[1], t[1]);
  if (((s0 > 0) != (s1 > 0)) && ((t0 > 0) != (t1 > 0))) return true;
  return distanceToSegment(s[0], t[0], t[1]) <= tolerance ||
         distanceToSegment(s[1], t[0], t[1]) <= tolerance ||
         distanceToSegment(t[0], s[0], s[1]) <= tolerance ||
         distanceToSegment(t[1], s[0], s[1]) <= tolerance;
}

bool clash(const PlanarGraph& graph, int i, int j, double tolerance) {
  const auto [a, b] = graph.segments[i];
  auto [c, d] = graph.segments[j];
  if (b == c || b == d || a == c || a == d) {
    const int shared = a == c || a == d ? a : b;
    const int p = a == shared ? b : a, q = c == shared ? d : c;
    const Vector2 &o = graph.points[shared], &far = graph.points[p], &other = graph.points[q];
    return distanceToSegment(far, o, other) <= tolerance ||
           distanceToSegment(other, o, far) <= tolerance;
  }
  return meet({graph.points[a], graph.points[b]}, {graph.points[c], graph.points[d]}, tolerance);
}

double extent(const std::vector<Vector2>& points) {
  Eigen::AlignedBox2d box;
  for (const Vector2& p : points) box.extend(p);
  return points.empty() ? 0 : box.sizes().maxCoeff();
}

}  // namespace

std::optional<std::array<int, 2>> crossingSegments(const PlanarGraph& graph) {
  const double tolerance = 1e-9 * extent(graph.points);
  const auto range = [&graph](int i) {
    const auto [left, right] = std::minmax(
        {graph.points[graph.segments[i][0]].x(), graph.points[graph.segments[i][1]].x()});
    return std::array<double, 2>{left, right};
  };
  // A sweep from left to right: only segments whose x ranges overlap are compared.
  std::vector<int> order(graph.segments.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&range](int i, int j) { return range(i)[0] < range(j)[0]; });
  std::optional<std::array<int, 2>> found;
  for (std::size_t n = 0; n < order.size(); ++n) {
    const double right = range(order[n])[1] + tolerance;
    for (std::size_t m = n + 1; m < order.size() && range(order[m])[0] <= right; ++m) {
      const std::array<int, 2> pair{std::min(order[n], order[m]), std::max(order[n], order[m])};
      if (found && *found < pair) continue;
      if (clash(graph, pair[0], pair[1], tolerance)) found = pair;
    }
  }
  return found;
}

void checkGraph(const PlanarGraph& graph) {
  const int count = static_cast<int>(graph.points.size());
  for (int i = 0; i < count; ++i) {
    if (!graph.points[i].allFinite()) reject("point ", i, " is not finite");
  }
  for (std::size_t i = 0; i < graph.segments.size(); ++i) {
    const auto [a, b] = graph.segments[i];
    for (int end : {a, b}) {
      if (end < 0 || end >= count) {
        reject("segment ", i, " names point ", end, ", but there are ", count);
      }
    }
    if (graph.points[a] == graph.points[b]) reject("segment ", i, " has no length");
  }
  if (const auto pair = crossingSegments(graph)) {
    reject("segments ", (*pair)[0], " and ", (*pair)[1], " cross");
  }
}

std::vector<std::vector<int>> subdivide(PlanarGraph& graph, double spacing, double longest) {
  std::vector<std::vector<int>> chains;
  std::vector<std::array<int, 2>> pieces;
  for (const auto& [a, b] : graph.segments) {
    const Vector2 from = graph.points[a], to = graph.points[b];
    const double length = (to - from).norm();
    const int parts = static_cast<int>(
        std::max({1.0, std::round(length / spacing), std::ceil(length / longest * (1 - 1e-12))}));
    std::vector<int> chain{a};
    for (int k = 1; k < parts; ++k) {
      chain.push_back(static_cast<int>(graph.points.size()));
      graph.points.push_back(from + (to - from) * (static_cast<double>(k) / parts));
    }
    chain.push_back(b);
    for (std::size_t k = 1; k < chain.size(); ++k) pieces.push_back({chain[k - 1], chain[k]});
    chains.push_back(std::move(chain));
  }
  graph.segments = std::move(pieces);
  return chains;
}

namespace {

/// The rows of the lattice, with what crosses or comes near each.
struct Rows {
  double bottom = 0, height = 1;               ///< y of row 0, distance of the rows
  std::vector<std::vector<double>> crossings;  ///< x at which the outline crosses the row
  std::vector<std::vector<Segment>> near;      ///< pieces within the clearance of the row

  double y(int row) const { return bottom + row * height; }
  /// The rows in [low, high].
  std::array<int, 2> between(double low, double high) const {
    const int last = static_cast<int>(crossings.size()) - 1;
    return {std::max(0, static_cast<int>(std::ceil((low - bottom) / height))),
            std::min(last, static_cast<int>(std::floor((high - bottom) / height)))};
  }
};

void addCrossings(Rows& rows, const Segment& edge) {
  const auto [low, high] = std::minmax({edge[0].y(), edge[1].y()});
  const auto [first, last] = rows.between(low, high);
  for (int row = first; row <= last; ++row) {
    const double y = rows.y(row);
    if ((edge[0].y() > y) == (edge[1].y() > y)) continue;
    const double s = (y - edge[0].y()) / (edge[1].y() - edge[0].y());
    rows.crossings[row].push_back(edge[0].x() + s * (edge[1].x() - edge[0].x()));
  }
}

bool tooNear(const std::vector<Segment>& pieces, const Vector2& p, double clearance) {
  for (const Segment& piece : pieces) {
    const auto [left, right] = std::minmax({piece[0].x(), piece[1].x()});
    if (p.x() < left - clearance || p.x() > right + clearance) continue;
    if (distanceToSegment(p, piece[0], piece[1]) < clearance) return true;
  }
  return false;
}

}  // namespace

std::vector<Vector2> latticePoints(const PlanarGraph& graph, const std::vector<Segment>& outline,
                                   double spacing, double clearance) {
  Eigen::AlignedBox2d box;
  for (const Segment& edge : outline) box.extend(edge[0]).extend(edge[1]);
  const double width = box.sizes().x(), height = box.sizes().y();
  // Rows and columns stretched a little, so that the lattice fits the box on all four sides.
  const int row_count = std::max(1.0, std::round(height / (spacing * std::sqrt(0.75))));
  const int columns = std::max(1.0, std::round(width / spacing));
  Rows rows;
  rows.bottom = box.min().y();
  rows.height = height / row_count;
  rows.crossings.resize(row_count + 1);
  rows.near.resize(row_count + 1);
  for (const Segment& edge : outline) addCrossings(rows, edge);
  for (auto& crossings : rows.crossings) std::sort(crossings.begin(), crossings.end());
  for (const auto& [a, b] : graph.segments) {
    const Segment piece{graph.points[a], graph.points[b]};
    const auto [low, high] = std::minmax({piece[0].y(), piece[1].y()});
    const auto [first, last] = rows.between(low - clearance, high + clearance);
    for (int row = first; row <= last; ++row) rows.near[row].push_back(piece);
  }

  std::vector<Vector2> points;
  const double step = width / columns;
  for (int row = 0; row <= row_count; ++row) {
    const double left = box.min().x() + (row % 2 == 1 ? step / 2 : 0.0);
    const std::vector<double>& crossings = rows.crossings[row];
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const int last = static_cast<int>(std::floor((crossings[k + 1] - left) / step));
      for (int i = static_cast<int>(std::ceil((crossings[k] - left) / step)); i <= last; ++i) {
        const Vector2 p(left + i * step, rows.y(row));
        if (!tooNear(rows.near[row], p, clearance)) points.push_back(p);
      }
    }
  }
  return points;
}

}  // namespace shell_origami
