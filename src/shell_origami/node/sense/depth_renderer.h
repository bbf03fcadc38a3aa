/// \file
/// Depth images of the paper, rendered on the CPU.
#pragma once

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

/// Follows the ray through the center of each pixel to the nearest paper. Depths are exact up to
/// the rounding of float, for the triangles are intersected, not interpolated.
class DepthRenderer {
 public:
  explicit DepthRenderer(const PinholeCamera& camera) : camera_(camera) {}

  /// \param points  where the sheet's vertices are in the camera's frame, a column a vertex [m]
  void render(const Sheet& sheet, const Positions& points);

  /// The depth that each pixel of the last rendering sees, along z, row by row [m]: NaN without
  /// paper, -infinity where paper is nearer than the camera measures, infinity where it is farther
  /// (REP-117).
  const std::vector<float>& depths() const { return depths_; }
  /// Three numbers for each pixel: the flat x and y [m] of the paper that it sees, and the side of
  /// it, kFrontSide or kBackSide; NaN where no depth is measured.
  /// \pre the arguments are those of the last rendering
  const std::vector<float>& labels(const Sheet& sheet, const Positions& points);

 private:
  /// Pixels, first to last.
  struct Box {
    int left, right, top, bottom;
  };
  Box boxOf(const Eigen::Matrix3d& corners) const;
  void draw(int triangle, const Eigen::Matrix3d& corners);
  /// The ray of a pixel at depth 1.
  double rayX(int column) const { return (column - camera_.centerColumn()) / camera_.focal_length; }
  double rayY(int row) const { return (row - camera_.centerRow()) / camera_.focal_length; }

  PinholeCamera camera_;
  std::vector<int> seen_;  ///< the triangle that each pixel sees, or -1
  std::vector<float> depths_, labels_;
};

}  // namespace shell_origami
