/// \file
/// The motion of a sheet's creases: driven by folds, or free.
#pragma once

#include <shell_origami/energy/rest_shape.h>
#include <shell_origami/origami/fold_ramp.h>
#include <shell_origami/sheet/remap.h>

#include <utility>
#include <vector>

namespace shell_origami {

/// One ramp for each crease of the sheet. Folds that begin at the same time and take equally long
/// run together. Creases that no fold has named are free: they are soft and follow the others, to
/// the side of Crease::pattern_angle.
class CreaseActuation {
 public:
  CreaseActuation() = default;
  /// Creases at rest at `rest_angles` [rad]; NaN: a free crease, which rests at its present angle.
  /// `stiffness` [N*m/rad per m] is that of creases whose fold states none.
  CreaseActuation(const std::vector<double>& rest_angles, double stiffness, const Shell& shell,
                  const Positions& positions);

  /// Creases that move by these ramps.
  CreaseActuation(std::vector<FoldRamp> ramps, double stiffness)
      : ramps_(std::move(ramps)), stiffness_(stiffness) {}

  const std::vector<FoldRamp>& ramps() const { return ramps_; }
  double stiffness() const { return stiffness_; }
  bool runningAt(double time) const;

  /// Starts a fold with the moment that the crease has: from where it rests, or, where the
  /// stiffness changes, from where it would rest with the new one; a free crease from the angle it
  /// has.
  void start(int crease, double target, double time, double duration, double stiffness,
             bool of_pattern, const Shell& shell, const Positions& positions);
  /// Makes the ramps that begin at this time run together.
  void synchronize(double time);
  /// Ends every running fold: its crease keeps the rest angle that the ramp has reached.
  void stop(double time);
  /// Moves the rest angles of free creases: those that are biased to the side of the pattern's
  /// fold, the others relax for `duration` [s] towards their present angles.
  void relaxFreeCreases(double time, double duration, const Sheet& sheet, const Shell& shell,
                        const Positions& positions);
  /// Moves the rest angle of a crease whose fold is done and whose moment exceeds the yield moment
  /// of the paper beside it (RestShape::yield).
  void yield(double time, const Material& material, const Shell& shell, const Positions& positions);
  /// Carries the ramps over an edit: a crease that was cut off another one takes over its ramp.
  void follow(const Remap& remap, const std::vector<Crease>& before,
              const std::vector<Crease>& after);
  /// Gives the shell's creases their rest angles at this time and their stiffness, times `factor`.
  void apply(double time, double factor, const Shell& shell, RestState& rest) const;

 private:
  std::vector<FoldRamp> ramps_;
  double stiffness_ = 0;
};

/// Mean fold angle of a crease [rad], weighted by length.
double meanAngle(int crease, const Shell& shell, const Positions& positions);

}  // namespace shell_origami
