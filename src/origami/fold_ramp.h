/// \file
/// Rest-angle ramps (Discrete Shells Origami, section 2.3).
#pragma once

#include <cstdint>

namespace shell_origami {

/// How one crease's rest angle goes from the angle recorded at the start of a fold to its target.
/// The angle, not its tangent, follows a smooth step of time.
struct FoldRamp {

  bool driven = false;     ///< false: a free crease, soft, that no fold has named
  double from = 0;         ///< [rad] recorded at the start
  double target = 0;       ///< [rad]
  double start = 0;        ///< [s] simulation time
  double duration = 0;     ///< [s]; 0: at once
  double stiffness = 0;    ///< [N*m/rad per m]

  /// Rest angle at simulation time t [rad].
  double angleAt(double t) const;
  bool runningAt(double t) const { return driven && t < start + duration; }
};

}  // namespace shell_origami
