#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/crease_pattern.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace shell_origami {
namespace {

/// Vertices may stand this part of the pattern's size off its plane.
constexpr double kFlatness = 1e-4;

double extent(const std::vector<Vector3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vector3& p : points) box.extend(p);
  return points.empty() ? 0 : box.sizes().maxCoeff();
}

/// Sum of the faces' area normals.
Vector3 normalOfFaces(const std::vector<Vector3>& points,
                      const std::vector<std::vector<int>>& faces) {
  Vector3 sum = Vector3::Zero();
  for (const auto& face : faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Vector3& o = points[face[0]];
      sum += (points[face[i - 1]] - o).cross(points[face[i]] - o);
    }
  }
  return sum;
}

/// Normal of the widest triangle over the first point, its largest component positive.
Vector3 normalOfPoints(const std::vector<Vector3>& points) {
  const auto farthest = *std::max_element(
      points.begin(), points.end(), [&points](const Vector3& a, const Vector3& b) {
        return (a - points[0]).squaredNorm() < (b - points[0]).squaredNorm();
      });
  Vector3 normal = Vector3::Zero();
  for (const Vector3& p : points) {
    const Vector3 candidate = (farthest - points[0]).cross(p - points[0]);
    if (candidate.squaredNorm() > normal.squaredNorm()) normal = candidate;
  }
  Eigen::Index largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  return normal[largest] < 0 ? Vector3(-normal) : normal;
}

PatternPlane planeThrough(const Vector3& point, Vector3 normal) {
  // Along an axis of the file, coordinates are kept to the bit.
  for (int k = 0; k < 3; ++k) {
    if (std::abs(normal[k]) > 1 - 1e-6) normal = std::copysign(1.0, normal[k]) * Vector3::Unit(k);
  }
  PatternPlane plane;
  plane.origin = normal * normal.dot(point);
  // In the xy plane the coordinates say which side is up, whatever the faces' order.
  if (std::abs(normal.z()) == 1) return plane;
  const Vector3 along = Vector3::Unit(std::abs(normal.x()) < 0.9 ? 0 : 1);
  const Vector3 x = (along - along.dot(normal) * normal).normalized();
  plane.axes.row(0) = x;
  plane.axes.row(1) = normal.cross(x);
  plane.axes.row(2) = normal;
  return plane;
}

std::optional<PatternPlane> planeOf(const std::vector<Vector3>& points,
                                    const std::vector<std::vector<int>>& faces) {
  const double size = extent(points);
  Vector3 normal = normalOfFaces(points, faces);
  if (!(normal.norm() > 1e-6 * size * size)) normal = normalOfPoints(points);
  if (!(normal.norm() > 0)) return std::nullopt;
  const PatternPlane plane = planeThrough(points[0], normal.normalized());
  for (const Vector3& p : points) {
    if (!(std::abs(plane.apply(p).z()) <= kFlatness * size)) return std::nullopt;
  }
  return plane;
}

/// Whether a frame in a plane is a form that is folded flat: some faces have turned over.
bool isFoldedFlat(const FoldDocument& document, int frame, const std::vector<Vector3>& points,
                  const PatternPlane& plane) {
  if (!document.hasClass(frame, "foldedForm") || document.hasClass(frame, "creasePattern")) {
    return false;
  }
  double up = 0, down = 0;
  for (const auto& face : document.faces(frame, static_cast<int>(points.size()))) {
    const double area = (plane.axes * normalOfFaces(points, {face})).z();
    (area > 0 ? up : down) += std::abs(area);
  }
  return std::min(up, down) > kFlatness * std::max(up, down);
}

}  // namespace

void findFlatFrame(const FoldDocument& document, CreasePattern& pattern) {
  bool has_vertices = false, has_folded_flat = false;
  for (const bool wants_class : {true, false}) {
    for (int frame = 0; frame < document.frameCount(); ++frame) {
      if (wants_class && !document.hasClass(frame, "creasePattern")) continue;
      const std::vector<Vector3> points = document.points(frame);
      if (points.empty()) continue;
      has_vertices = true;
      const auto plane = planeOf(points, document.faces(frame, static_cast<int>(points.size())));
      if (wants_class && !plane) {
        reject(FoldDocument::frameName(frame),
               " is called a crease pattern, but its vertices do not span one plane");
      }
      if (!plane) continue;
      if (isFoldedFlat(document, frame, points, *plane)) {
        has_folded_flat = true;
        continue;
      }
      pattern.frame = frame;
      pattern.plane = *plane;
      for (const Vector3& p : points) pattern.points.push_back(plane->apply(p).head<2>());
      return;
    }
  }
  if (has_folded_flat) {
    reject("holds only a form that is folded flat, and no crease pattern to fold it from");
  }
  if (has_vertices) {
    reject("holds only a folded form in space, and no flat crease pattern to fold it from");
  }
  reject("holds no vertices_coords");
}

}  // namespace shell_origami
