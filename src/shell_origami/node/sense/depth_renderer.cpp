#include <shell_origami/node/sense/depth_renderer.h>

#include <shell_origami/node/sense/material_points.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace shell_origami {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// A triangle as rays (x, y, 1) from the camera meet it. Nothing is divided by the depth of a
/// corner: triangles that reach behind the camera need no clipping. Along an edge that two
/// triangles share their functions are each other's negatives, to the bit: no ray passes between.
struct SeenTriangle {
  Eigen::Matrix3d edges;  ///< a column for each corner: linear in the ray, zero along the far edge
  double volume;          ///< of the parallelepiped of the corners: 0 where it is seen edge-on
  bool back;              ///< which side is seen

  /// \param corners  a column each
  explicit SeenTriangle(const Eigen::Matrix3d& corners) {
    for (int k = 0; k < 3; ++k) {
      edges.col(k) = corners.col((k + 1) % 3).cross(corners.col((k + 2) % 3));
    }
    volume = corners.col(0).dot(edges.col(0));
    back = volume > 0;
    if (back) return;
    volume = -volume;
    edges = -edges;
  }

  /// A corner's share in the point that the ray meets, but for a factor that all three have; not
  /// negative where it meets the triangle.
  double share(int corner, double x, double y) const {
    const auto edge = edges.col(corner);
    return edge.x() * x + (edge.y() * y + edge.z());
  }
};

/// \param first  the column of the triangle's vertex 0
Eigen::Matrix3d cornersOf(const Triangle& triangle, const Positions& points,
                          Eigen::Index first = 0) {
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k) corners.col(k) = points.col(first + triangle[k]);
  return corners;
}

}  // namespace

void DepthRenderer::render(const Sheet& sheet, const std::vector<Body>& bodies,
                           const Positions& points) {
  const std::size_t pixels = static_cast<std::size_t>(camera_.width) * camera_.height;
  depths_.assign(pixels, kInfinite);
  seen_.assign(pixels, -1);
  int face = 0;
  for (const Triangle& triangle : sheet.triangles()) draw(face++, cornersOf(triangle, points));
  first_faces_.clear();
  Eigen::Index column = sheet.vertexCount();
  for (const Body& body : bodies) {
    const Surface& surface = *body.surface;
    first_faces_.push_back(face);
    if (surface.half_space) {
      drawPlane(face++, cornersOf(surface.faces.front(), points, column));
    } else {
      for (const Triangle& t : surface.faces) draw(face++, cornersOf(t, points, column));
    }
    column += surface.vertices.cols();
  }
  for (std::size_t i = 0; i < pixels; ++i) {
    if (seen_[i] < 0) depths_[i] = kNone;
    else if (depths_[i] < camera_.near) depths_[i] = -kInfinite;
    else if (depths_[i] > camera_.far) depths_[i] = kInfinite;
  }
}

/// Of the pixels that may see the triangle.
DepthRenderer::Box DepthRenderer::boxOf(const Eigen::Matrix3d& corners) const {
  constexpr Box kNothing{0, -1, 0, -1};
  constexpr double kSlack = 1e-6;  // [pixel] for what rounding shifts
  const Box all{0, camera_.width - 1, 0, camera_.height - 1};
  const auto x = corners.row(0).array(), y = corners.row(1).array(), z = corners.row(2).array();
  if ((z <= 0).all()) return kNothing;
  // Corners beside or behind the camera have no pixel, but may be beyond a side of the view.
  const double right = rayX(all.right), bottom = rayY(all.bottom);
  const bool outside = (x > right * z).all() || (x < -right * z).all() || (y > bottom * z).all() ||
                       (y < -bottom * z).all();
  if (outside) return kNothing;
  if ((z <= 0).any()) return all;
  const Eigen::Array<double, 1, 3> column =
      (x / z * camera_.focal_length + camera_.centerColumn()).eval();
  const Eigen::Array<double, 1, 3> row =
      (y / z * camera_.focal_length + camera_.centerRow()).eval();
  const auto first = [=](double low) {
    return static_cast<int>(std::ceil(std::max(low - kSlack, 0.0)));
  };
  const auto last = [=](double high, int end) {
    return static_cast<int>(std::floor(std::min<double>(high + kSlack, end)));
  };
  return {first(column.minCoeff()), last(column.maxCoeff(), all.right), first(row.minCoeff()),
          last(row.maxCoeff(), all.bottom)};
}

void DepthRenderer::draw(int face, const Eigen::Matrix3d& corners) {
  const Box box = boxOf(corners);
  if (box.right < box.left || box.bottom < box.top) return;
  const SeenTriangle seen(corners);
  if (!(seen.volume > 0)) return;
  const double lowest = corners.row(2).minCoeff(), highest = corners.row(2).maxCoeff();
  for (int row = box.top; row <= box.bottom; ++row) {
    const double y = rayY(row);
    for (int column = box.left; column <= box.right; ++column) {
      const double x = rayX(column);
      const double a = seen.share(0, x, y), b = seen.share(1, x, y), c = seen.share(2, x, y);
      if (a < 0 || b < 0 || c < 0) continue;
      // Seen almost edge-on a triangle's depth is mostly rounding.
      show(row, column, std::clamp(seen.volume / (a + b + c), lowest, highest), face);
    }
  }
}

/// Draws the plane through the corners.
void DepthRenderer::drawPlane(int face, const Eigen::Matrix3d& corners) {
  const SeenTriangle seen(corners);
  if (!(seen.volume > 0)) return;
  for (int row = 0; row < camera_.height; ++row) {
    const double y = rayY(row);
    for (int column = 0; column < camera_.width; ++column) {
      const double x = rayX(column);
      const double sum = seen.share(0, x, y) + seen.share(1, x, y) + seen.share(2, x, y);
      if (sum > 0) show(row, column, seen.volume / sum, face);
    }
  }
}

/// Of what is at the same depth, to the rounding of float, the first that was drawn is seen: paper
/// in front of the body that it is pressed onto.
void DepthRenderer::show(int row, int column, double depth, int face) {
  const std::size_t pixel = static_cast<std::size_t>(row) * camera_.width + column;
  const auto rounded = static_cast<float>(depth);
  if (!(rounded < depths_[pixel])) return;
  depths_[pixel] = rounded;
  seen_[pixel] = face;
}

const std::vector<float>& DepthRenderer::labels(const Sheet& sheet, const Positions& points) {
  labels_.assign(3 * seen_.size(), kNone);
  std::optional<SeenTriangle> seen;
  int triangle = -1;  // that `seen` is, often the one that the pixel before saw
  for (std::size_t pixel = 0; pixel < seen_.size(); ++pixel) {
    if (!std::isfinite(depths_[pixel])) continue;
    if (seen_[pixel] >= static_cast<int>(sheet.triangles().size())) {
      const auto after = std::upper_bound(first_faces_.begin(), first_faces_.end(), seen_[pixel]);
      labels_[3 * pixel + 2] = kFirstObstacle + (after - first_faces_.begin() - 1);
      continue;
    }
    if (triangle != seen_[pixel]) {
      triangle = seen_[pixel];
      seen.emplace(cornersOf(sheet.triangles()[triangle], points));
    }
    const double x = rayX(static_cast<int>(pixel % camera_.width));
    const double y = rayY(static_cast<int>(pixel / camera_.width));
    Vector2 flat = Vector2::Zero();
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double share = seen->share(k, x, y);
      flat += share * sheet.flatPositions()[sheet.triangles()[triangle][k]];
      sum += share;
    }
    labels_[3 * pixel] = static_cast<float>(flat.x() / sum);
    labels_[3 * pixel + 1] = static_cast<float>(flat.y() / sum);
    labels_[3 * pixel + 2] = seen->back ? kBackSide : kFrontSide;
  }
  return labels_;
}

}  // namespace shell_origami
