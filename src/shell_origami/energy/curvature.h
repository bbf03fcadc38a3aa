/// \file
/// The curvature of the sheet's triangles, from the angles by which it bends along their edges.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/sheet/sheet.h>

#include <array>
#include <vector>

namespace shell_origami {

/// A curvature on the flat sheet [1/m]: a symmetric matrix as (xx, sqrt 2 xy, yy), so that its norm
/// is the matrix's; as of a valley, towards the front, is positive.
using Curvature = Vector3;

/// Returns the principal value of largest magnitude of a symmetric matrix, written as a Curvature.
double largestPrincipal(const Vector3& matrix);

/// An edge between two triangles along which the paper bends.
struct BentEdge {
  Vector2 a, b;                   ///< on the flat sheet [m]
  std::array<Vector2, 2> apexes;  ///< of the triangles
  std::array<int, 2> triangles;
};

/// Least squares: a triangle's curvature is the one under which its edges would bend as they do.
/// Next to creases and the border there are fewer edges than the three that tell a curvature: the
/// neighbors say the rest, and what they do not know either is taken as small as it can be. Exact
/// for surfaces of second order, whatever the direction in which they bend.
class CurvatureFit {
 public:
  CurvatureFit() = default;
  CurvatureFit(int triangle_count, const std::vector<BentEdge>& edges);
  /// For the edges that are no creases, in the order of the shell's ordinary hinges.
  explicit CurvatureFit(const Sheet& sheet);

  /// Returns the curvature of each triangle, by the angle of each edge [rad].
  std::vector<Curvature> curvatures(const std::vector<double>& angles) const;
  /// Returns the mean curvature of the two triangles at each edge.
  std::vector<Curvature> edgeCurvatures(const std::vector<double>& angles) const;

 private:
  struct Bend {
    std::array<int, 2> triangles;
    Vector3 direction;  ///< how much of each entry of a curvature goes into angle / width
    double width;       ///< over which it turns [m]
  };

  template <class Entry>
  std::vector<Entry> withNeighbors(const std::vector<Entry>& own) const;

  std::vector<Bend> bends_;
  std::vector<Eigen::Matrix3d> fits_;  ///< from the sum of a triangle's bends to its curvature
};

}  // namespace shell_origami
