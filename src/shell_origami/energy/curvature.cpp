#include <shell_origami/energy/curvature.h>

#include <Eigen/LU>

#include <cmath>

namespace shell_origami {
namespace {

/// Where a surface of a curvature, level at the origin, is at p: by the three entries of its
/// curvature [m^2].
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

std::vector<BentEdge> edgesWithoutCrease(const Sheet& sheet) {
  const std::vector<Vector2>& flat = sheet.flatPositions();
  std::vector<BentEdge> edges;
  for (const Edge& edge : sheet.edges()) {
    if (edge.onBorder() || edge.crease >= 0) continue;
    edges.push_back({flat[edge.vertices[0]],
                     flat[edge.vertices[1]],
                     {flat[edge.opposite[0]], flat[edge.opposite[1]]},
                     edge.triangles});
  }
  return edges;
}

}  // namespace

double largestPrincipal(const Vector3& matrix) {
  const double mean = (matrix[0] + matrix[2]) / 2;
  const double radius = std::hypot((matrix[0] - matrix[2]) / 2, matrix[1] / std::sqrt(2.0));
  return mean < 0 ? mean - radius : mean + radius;
}

CurvatureFit::CurvatureFit(const Sheet& sheet)
    : CurvatureFit(static_cast<int>(sheet.triangles().size()), edgesWithoutCrease(sheet)) {}

CurvatureFit::CurvatureFit(int triangle_count, const std::vector<BentEdge>& edges) {
  constexpr double kSmall = 1e-3;
  std::vector<Eigen::Matrix3d> sums(triangle_count, Eigen::Matrix3d::Zero());
  for (const BentEdge& edge : edges) {
    const FlatEdge flat{edge.a, edge.b};
    const auto& [left, right] = edge.apexes;
    // As wide as the shell's own hinge: two thirds of the mean height.
    const double width = (flat.height(left) + flat.height(right)) / 3;
    const Vector3 direction = (flat.rise(left) + flat.rise(right)) / width;
    bends_.push_back({edge.triangles, direction, width});
    for (const int t : edge.triangles) sums[t] += direction * direction.transpose();
  }
  for (const Eigen::Matrix3d& sum : withNeighbors(sums)) {
    fits_.push_back((sum + kSmall * Eigen::Matrix3d::Identity()).inverse());
  }
}

/// Each triangle's entry and, for little, those of the triangles across its bends.
template <class Entry>
std::vector<Entry> CurvatureFit::withNeighbors(const std::vector<Entry>& own) const {
  constexpr double kWeight = 0.1;
  std::vector<Entry> result = own;
  for (const Bend& bend : bends_) {
    const auto [left, right] = bend.triangles;
    result[left] += kWeight * own[right];
    result[right] += kWeight * own[left];
  }
  return result;
}

std::vector<Curvature> CurvatureFit::curvatures(const std::vector<double>& angles) const {
  std::vector<Vector3> sums(fits_.size(), Vector3::Zero());
  for (std::size_t i = 0; i < bends_.size(); ++i) {
    const Bend& bend = bends_[i];
    for (const int t : bend.triangles) sums[t] += angles[i] / bend.width * bend.direction;
  }
  std::vector<Curvature> result = withNeighbors(sums);
  for (std::size_t t = 0; t < result.size(); ++t) result[t] = fits_[t] * result[t];
  return result;
}

std::vector<Curvature> CurvatureFit::edgeCurvatures(const std::vector<double>& angles) const {
  const std::vector<Curvature> of_triangles = curvatures(angles);
  std::vector<Curvature> result;
  for (const Bend& bend : bends_) {
    result.push_back((of_triangles[bend.triangles[0]] + of_triangles[bend.triangles[1]]) / 2);
  }
  return result;
}

}  // namespace shell_origami
