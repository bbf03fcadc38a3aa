/// \file
/// Depth images of the paper and of bodies around it, rendered on the CPU.
#pragma once

#include <shell_origami/contact/collision_mesh.h>
#include <shell_origami/sheet/sheet.h>

#include <cstddef>
#include <vector>

namespace shell_origami {

/// A camera without distortion, in an optical frame (REP-103): x to the right, y down, z forward.
/// Centers of pixels are at whole columns and rows; the axis of view meets the middle of the image.
struct PinholeCamera {
  int width = 640, height = 480;  ///< [pixel]
  double focal_length = 525;      ///< [pixel]
  double near = 0.05, far = 10;   ///< the depths that it measures [m]

  double centerColumn() const { return (width - 1) / 2.0; }
  double centerRow() const { return (height - 1) / 2.0; }
};

/// Follows the ray through the center of each pixel to the nearest paper or body. Depths are exact
/// up to the rounding of float, for the triangles are intersected, not interpolated. Of a half
/// space the whole plane is seen.
class DepthRenderer {
 public:
  explicit DepthRenderer(const PinholeCamera& camera) : camera_(camera) {}

  /// \param points  where the vertices of the sheet and, after these, of the bodies are in the
  /// camera's frame, a column a vertex [m]
  void render(const Sheet& sheet, const std::vector<Body>& bodies, const Positions& points);

  /// The depth that each pixel of the last rendering sees, along z, row by row [m]: NaN where there
  /// is nothing, -infinity where it is nearer than the camera measures, infinity where it is
  /// farther (REP-117).
  const std::vector<float>& depths() const { return depths_; }
  /// Three numbers for each pixel: the flat x and y [m] of the paper that it sees, and the side of
  /// it, kFrontSide or kBackSide; of the n-th body NaN, NaN and kFirstObstacle + n; NaN where no
  /// depth is measured.
  /// \pre the arguments are those of the last rendering
  const std::vector<float>& labels(const Sheet& sheet, const Positions& points);

 private:
  /// Pixels, first to last.
  struct Box {
    int left, right, top, bottom;
  };
  Box boxOf(const Eigen::Matrix3d& corners) const;
  void draw(int face, const Eigen::Matrix3d& corners);
  void drawPlane(int face, const Eigen::Matrix3d& corners);
  void show(int row, int column, double depth, int face);
  /// The ray of a pixel at depth 1.
  double rayX(int column) const { return (column - camera_.centerColumn()) / camera_.focal_length; }
  double rayY(int row) const { return (row - camera_.centerRow()) / camera_.focal_length; }

  PinholeCamera camera_;
  std::vector<int> seen_;         ///< the face that each pixel sees, or -1
  std::vector<int> first_faces_;  ///< of each body, after the sheet's triangles
  std::vector<float> depths_, labels_;
};

}  // namespace shell_origami
