#include <shell_origami/node/draw/sheet_measures.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace shell_origami {
namespace {

using EdgeEnds = std::array<std::uint32_t, 2>;  ///< ascending

EdgeEnds ends(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

std::set<EdgeEnds> creaseEdges(const msg::Sheet& sheet) {
  std::set<EdgeEnds> edges;
  for (const msg::Crease& crease : sheet.creases) {
    const auto& line = crease.vertices;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) edges.insert(ends(line[i], line[i + 1]));
  }
  return edges;
}

/// A symmetric matrix as (xx, sqrt 2 xy, yy), so that its norm is the matrix's.
double largestPrincipal(const Vector3& m) {
  const double mean = (m[0] + m[2]) / 2;
  const double radius = std::hypot((m[0] - m[2]) / 2, m[1] / std::sqrt(2.0));
  return mean < 0 ? mean - radius : mean + radius;
}

/// Where a surface of the curvature (xx, sqrt 2 xy, yy), level at the origin, is at p: by the three
/// entries of its curvature [m^2].
Vector3 lift(const Vector2& p) {
  return {p.x() * p.x() / 2, p.x() * p.y() / std::sqrt(2.0), p.y() * p.y() / 2};
}

/// An edge of the flat sheet.
struct FlatEdge {
  Vector2 a, b;

  double height(const Vector2& apex) const {
    return std::abs(doubleArea(a, b, apex)) / (b - a).norm();
  }
  /// How steeply the triangle to the apex rises from the edge, its corners on a curved surface: by
  /// the three entries of the curvature [m].
  Vector3 rise(const Vector2& apex) const {
    const double foot = (b - a).dot(apex - a) / (b - a).squaredNorm();
    return (lift(apex - a) - foot * lift(b - a)) / height(apex);
  }
};

}  // namespace

double sheetSize(const msg::Sheet& sheet) {
  Eigen::Array2d low = Eigen::Array2d::Constant(HUGE_VAL), high = -low;
  for (const auto& p : sheet.flat_positions) {
    low = low.min(Eigen::Array2d(p.x, p.y));
    high = high.max(Eigen::Array2d(p.x, p.y));
  }
  return (high - low).maxCoeff();
}

SheetMeasures::SheetMeasures(const msg::Sheet& sheet) {
  std::vector<Vector2> flat;
  for (const auto& p : sheet.flat_positions) flat.emplace_back(p.x, p.y);
  for (const auto& triangle : sheet.triangles) {
    const auto& v = triangle.vertex_indices;
    triangles_.push_back({v[0], v[1], v[2]});
    membranes_.emplace_back(std::array<Vector2, 3>{flat[v[0]], flat[v[1]], flat[v[2]]}, Material());
  }
  addBends(sheet, flat);
  fitBends();
}

void SheetMeasures::addBends(const msg::Sheet& sheet, const std::vector<Vector2>& flat) {
  struct Side {
    std::uint32_t from, to, apex, triangle;
  };
  std::map<EdgeEnds, std::vector<Side>> sides;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const auto& v = triangles_[i];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      sides[ends(a, b)].push_back({a, b, v[(k + 2) % 3], i});
    }
  }
  for (const EdgeEnds& edge : creaseEdges(sheet)) sides.erase(edge);
  for (const auto& [both, pair] : sides) {
    if (pair.size() != 2) continue;
    const Side &left = pair[0], &right = pair[1];
    const FlatEdge edge{flat[left.from], flat[left.to]};
    const Vector2 &above = flat[left.apex], &below = flat[right.apex];
    // As wide as the shell's own hinge: two thirds of the mean height.
    const double width = (edge.height(above) + edge.height(below)) / 3;
    bends_.push_back({{left.from, left.to, left.apex, right.apex},
                      {left.triangle, right.triangle},
                      (edge.rise(above) + edge.rise(below)) / width,
                      width});
  }
}

/// Least squares: a triangle's curvature is the one under which its edges would bend as they do.
/// Next to creases and the border there are fewer edges than the three that tell a curvature: the
/// neighbours say the rest, and what they do not know either is taken as small as it can be.
void SheetMeasures::fitBends() {
  constexpr double kSmall = 1e-3;
  std::vector<Eigen::Matrix3d> sums(triangles_.size(), Eigen::Matrix3d::Zero());
  for (const Bend& bend : bends_) {
    for (const std::uint32_t t : bend.triangles) {
      sums[t] += bend.direction * bend.direction.transpose();
    }
  }
  for (const Eigen::Matrix3d& sum : withNeighbours(sums)) {
    fits_.push_back((sum + kSmall * Eigen::Matrix3d::Identity()).inverse());
  }
}

/// Each triangle's entry and, for little, those of the triangles across its bends.
template <class Entry>
std::vector<Entry> SheetMeasures::withNeighbours(const std::vector<Entry>& own) const {
  constexpr double kWeight = 0.1;
  std::vector<Entry> result = own;
  for (const Bend& bend : bends_) {
    const auto [left, right] = bend.triangles;
    result[left] += kWeight * own[right];
    result[right] += kWeight * own[left];
  }
  return result;
}

std::vector<double> SheetMeasures::strains(const Positions& x) const {
  std::vector<double> result;
  result.reserve(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& v = triangles_[i];
    const MembraneStrain e = membranes_[i].strain({x.col(v[0]), x.col(v[1]), x.col(v[2])});
    result.push_back(largestPrincipal({e[0], std::sqrt(2.0) * e[2], e[1]}));
  }
  return result;
}

std::vector<double> SheetMeasures::curvatures(const Positions& x) const {
  std::vector<Vector3> sums(triangles_.size(), Vector3::Zero());
  for (const Bend& bend : bends_) {
    const auto& v = bend.vertices;
    const double angle = foldAngle({x.col(v[0]), x.col(v[1]), x.col(v[2]), x.col(v[3])}).radians;
    for (const std::uint32_t t : bend.triangles) sums[t] += angle / bend.width * bend.direction;
  }
  sums = withNeighbours(sums);
  std::vector<double> result;
  result.reserve(triangles_.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    result.push_back(largestPrincipal(fits_[i] * sums[i]));
  }
  return result;
}

std::vector<double> SheetMeasures::means(const std::vector<float>& of_vertices) const {
  std::vector<double> result;
  result.reserve(triangles_.size());
  for (const auto& v : triangles_) {
    const double sum = double{of_vertices[v[0]]} + of_vertices[v[1]] + of_vertices[v[2]];
    result.push_back(sum / 3);
  }
  return result;
}

}  // namespace shell_origami
