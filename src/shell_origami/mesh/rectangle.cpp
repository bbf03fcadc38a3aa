#include <shell_origami/base/error.h>
#include <shell_origami/mesh/delaunay.h>
#include <shell_origami/mesh/mesh_refine.h>
#include <shell_origami/mesh/triangulate.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// Angles of at least this are good enough: at the ends of the rows, where they can hardly be
/// larger, and in between, where they make the paper bend alike in every direction.
constexpr double kEndAngle = 34 * M_PI / 180, kInnerAngle = 54 * M_PI / 180;

double smallestAngle(const std::array<Vector2, 3>& t) {
  double smallest = M_PI;
  for (int k = 0; k < 3; ++k) {
    const Vector2 &p = t[k], &q = t[(k + 1) % 3], &r = t[(k + 2) % 3];
    smallest = std::min(smallest, std::atan2(doubleArea(p, q, r), (q - p).dot(r - p)));
  }
  return smallest;
}

/// A rectangle in rows of triangles, here with three columns:
///
///     +-----+-----+-----+     row 2
///     |  /\   /\   /\   |
///     +----+----+----+--+     row 1: the half cells at both ends are widened
///     |  \/   \/   \/   |
///     +-----+-----+-----+     row 0
class RowPlan {
 public:
  RowPlan(double length, double breadth, int columns, int rows, double longest)
      : length_(length), breadth_(breadth), columns_(columns), rows_(rows) {
    const double reach = std::sqrt(std::max(0.0, longest * longest - height() * height()));
    end_ = columns == 1 ? step() / 2 : std::min(0.7 * step(), std::max(0.5 * step(), reach));
  }

  int rows() const { return rows_; }
  double breadth() const { return breadth_; }
  double triangles() const { return rows_ * (2.0 * columns_ + 1); }
  double longestEdge() const { return std::max(step(), std::hypot(end_, height())); }

  /// The places of a row's points along it.
  std::vector<double> row(int index) const {
    std::vector<double> at{0};
    if (index % 2 == 0) {
      for (int i = 1; i < columns_; ++i) at.push_back(i * step());
    } else {
      at.push_back(end_);
      for (int i = 1; i + 1 < columns_; ++i) at.push_back((i + 0.5) * step());
      if (columns_ > 1) at.push_back(length_ - end_);
    }
    at.push_back(length_);
    return at;
  }

  /// Smallest angles over good ones, at most 1.
  double quality() const {
    const double second = columns_ == 1 ? length_ : std::min(1.5 * step(), length_ - end_);
    const Vector2 corner(0, 0), above(0, height()), first(end_, height()), along(step(), 0);
    const double end =
        std::min({smallestAngle({corner, first, above}), smallestAngle({corner, along, first}),
                  smallestAngle({first, along, Vector2(second, height())})});
    const double inner = smallestAngle({corner, along, Vector2(step() / 2, height())});
    return std::min({1.0, end / kEndAngle, inner / kInnerAngle});
  }

  /// Fewer triangles win between good plans, otherwise larger angles do.
  bool betterThan(const RowPlan& other) const {
    const double mine = quality(), its = other.quality();
    return mine != its ? mine > its : triangles() < other.triangles();
  }

 private:
  double step() const { return length_ / columns_; }
  double height() const { return breadth_ / rows_; }

  double length_, breadth_;  ///< along and across the rows [m]
  int columns_, rows_;
  double end_;  ///< width of the end cells of odd rows [m]
};

/// The best plan with rows along `length`.
RowPlan planRows(double length, double breadth, double max_edge) {
  constexpr double tall = 0.8660254037844386;  // height of an equilateral triangle
  constexpr int tries = 8;
  // Along a strip narrower than max_edge the triangles are as tall as the strip.
  const double edge = std::min({max_edge, breadth / tall, length});
  const int least_rows = std::max(1, static_cast<int>(std::ceil(breadth / edge)) - 1);
  const int stride = 1 + least_rows / 60;
  const auto plan = [&](int rows, int more) {
    const double even = std::min(max_edge, breadth / rows / tall);
    const int columns = static_cast<int>(std::ceil(length / even * (1 - 1e-12)));
    return RowPlan(length, breadth, std::max(1, columns - 1 + more), rows, max_edge);
  };
  RowPlan best = plan(2 * least_rows + tries, tries);
  for (int rows = least_rows; rows < 1.4 * breadth / edge / tall + tries; rows += stride) {
    for (int more = 0; more < tries; ++more) {
      const RowPlan candidate = plan(rows, more);
      if (candidate.longestEdge() > max_edge * (1 + 1e-12)) continue;
      if (candidate.betterThan(best)) best = candidate;
    }
  }
  return best;
}

void checkSide(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    reject(name, " is ", value, ", but must be positive and finite");
  }
}

}  // namespace

Triangulation triangulateRectangle(double width, double height, double max_edge) {
  checkSide("width", width);
  checkSide("height", height);
  checkMaxEdge(max_edge);
  const double edge = std::min({max_edge, width, height});
  checkPlan(2 * (width / edge) * (height / edge), max_edge);

  const bool turned = height > width;  // rows along the longer side
  const RowPlan plan =
      turned ? planRows(height, width, max_edge) : planRows(width, height, max_edge);

  PlanarGraph graph;
  graph.points = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  std::vector<std::vector<int>> rows;  // point ids
  for (int r = 0; r <= plan.rows(); ++r) {
    const double y = r == plan.rows() ? plan.breadth() : plan.breadth() * r / plan.rows();
    rows.emplace_back();
    for (double x : plan.row(r)) {
      const Vector2 p = turned ? Vector2(y, x) : Vector2(x, y);
      const auto known = std::find(graph.points.begin(), graph.points.begin() + 4, p);
      const bool is_corner = known != graph.points.begin() + 4;
      rows.back().push_back(
          static_cast<int>(is_corner ? known - graph.points.begin() : graph.points.size()));
      if (!is_corner) graph.points.push_back(p);
    }
  }
  const auto join = [&graph](int a, int b) { graph.segments.push_back({a, b}); };
  for (const auto* row : {&rows.front(), &rows.back()}) {
    for (std::size_t i = 1; i < row->size(); ++i) join((*row)[i - 1], (*row)[i]);
  }
  for (std::size_t r = 1; r < rows.size(); ++r) {
    join(rows[r - 1].front(), rows[r].front());
    join(rows[r - 1].back(), rows[r].back());
  }
  return Triangulation(graph.points, constrainedDelaunay(graph));
}

}  // namespace shell_origami
