/// \file
/// How the creases of a sheet move: driven by folds, or freely.
#pragma once

#include <shell_origami/energy/rest_shape.h>
#include <shell_origami/origami/fold_ramp.h>
#include <shell_origami/sheet/remap.h>

#include <utility>
#include <vector>

namespace shell_origami {

/// One ramp for each crease of the sheet. Folds that begin at the same time and take equally long
/// run together; creases that no fold has named are free: soft, they follow what the others ask of
/// them, to the side that Crease::pattern_angle asks for.
class CreaseActuation {
 public:
  CreaseActuation() = default;
  /// Creases at rest at `rest_angles` [rad]; NaN: a free crease, that rests at its angle now.
  /// `stiffness` [N*m/rad per m] is that of creases whose fold states none.
  CreaseActuation(const std::vector<double>& rest_angles, double stiffness, const Shell& shell,
                  const Positions& positions);

  /// Creases that move by these ramps.
  CreaseActuation(std::vector<FoldRamp> ramps, double stiffness)
      : ramps_(std::move(ramps)), stiffness_(stiffness) {}

  const std::vector<FoldRamp>& ramps() const { return ramps_; }
  double stiffness() const { return stiffness_; }
  bool runningAt(double time) const;

  /// Starts a fold from where the crease rests, so that no moment jumps; a free one from the angle
  /// it has.
  void start(int crease, double target, double time, double duration, double stiffness,
             const Shell& shell, const Positions& positions);
  /// Lets the ramps that begin now run together.
  void synchronize(double time);
  /// Ends every fold under way: its crease rests from now on at the angle it has reached.
  void stop(double time);
  /// Lets free creases lean, and give way for this long [s] to where the paper is.
  void creep(double time, double duration, const Sheet& sheet, const Shell& shell,
             const Positions& positions);
  /// Where a crease at the end of its fold is pulled harder than the paper beside it can bear, its
  /// rest angle gives way (RestShape::yield).
  void yield(double time, const Material& material, const Shell& shell, const Positions& positions);
  /// Carries the ramps over an edit: a crease that was cut off another moves as that one did.
  void follow(const Remap& remap, const std::vector<Crease>& before,
              const std::vector<Crease>& after);
  /// Gives the shell's creases their rest angles and stiffness at this time.
  void apply(double time, const Shell& shell, RestState& rest) const;

 private:
  std::vector<FoldRamp> ramps_;
  double stiffness_ = 0;
};

/// Mean fold angle of a crease [rad], weighted by length.
double meanAngle(int crease, const Shell& shell, const Positions& positions);

}  // namespace shell_origami
