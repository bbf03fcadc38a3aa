/// \file
/// Where a sheet comes from.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/fold_format/fold_file.h>

#include <string>

namespace shell_origami {

/// A rectangle from (0, 0), or the crease pattern of a file.
struct SheetSource {
  double width = 0.15;       ///< [m]
  double height = 0.15;      ///< [m]
  double max_edge = 0.01;    ///< longest edge wanted [m]
  std::string pattern;       ///< file of a crease pattern; empty: the rectangle
  double scale = 0;          ///< metres per unit of the pattern; 0: the unit the file states
  double pattern_width = 0;  ///< of the flat pattern [m], in the place of a scale; 0: by the scale
  FoldForm form = FoldForm::kFolded;   ///< of the pattern
  Vector3 position = Vector3::Zero();  ///< where the flat sheet's origin lies in the world [m]
  Vector3 roll_pitch_yaw = Vector3::Zero();  ///< how the flat sheet lies there [rad] (REP-103)
};

}  // namespace shell_origami
