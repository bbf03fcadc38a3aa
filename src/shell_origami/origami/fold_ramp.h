/// \file
/// Rest-angle ramps (Discrete Shells Origami, section 2.3).
#pragma once

namespace shell_origami {

/// The motion of a crease's rest angle from the angle at the start of a fold to its target. Of
/// folds that run together the one that goes farthest leads: its angle follows a smooth step of
/// time, and tan(angle/2) of each other one covers the same part of its way as that of the leading
/// fold. The creases of a flat-foldable vertex of four move like this, so that folds with
/// compatible targets stay compatible on the way.
struct FoldRamp {
  bool driven = false;      ///< false: a free crease, soft, that no fold has named
  double from = 0;          ///< [rad] recorded at the start
  double target = 0;        ///< [rad]; of a free crease, where it rests now
  double lead_from = 0;     ///< [rad] of the lead, `from` and `target` where the fold is alone
  double lead_target = 0;   ///< [rad]
  double start = 0;         ///< [s] simulation time
  double duration = 0;      ///< [s]; 0: at once
  double stiffness = 0;     ///< [N*m/rad per m]
  double set = 0;           ///< what yielding added to the rest angle [rad]
  bool of_pattern = false;  ///< whether the fold named a crease of a loaded pattern

  /// Rest angle at simulation time t [rad].
  double angleAt(double t) const;
  bool runningAt(double t) const { return driven && t < start + duration; }
  /// Returns the difference of tan(angle/2) between start and target.
  double way() const;
  /// Whether it goes away from flat, or keeps its angle; otherwise it unfolds.
  bool folds() const;
};

}  // namespace shell_origami
