/// \file
/// Steps that hold: a step that fails is taken in smaller ones, or not at all.
#pragma once

#include <shell_origami/dynamics/implicit_solver.h>

#include <functional>
#include <memory>

namespace shell_origami {

/// What the world does to the paper within a step.
class Drive {
 public:
  virtual ~Drive() = default;
  /// Sets the shell's rest state, and in `held` where held vertices stand [m], for the end of a
  /// (sub)step that ends at fraction s in (0, 1] of the whole step.
  virtual void moveTo(double s, Shell& shell, Positions& held) = 0;
};

class Stepper {
 public:
  explicit Stepper(const SolverConfig& config);

  /// Says that topology or pins changed. `free[v]` is false for held vertices.
  void setTopology(std::vector<bool> free);

  /// What steps leave to the next one, for a stepper that goes on where another stood.
  const SolverState& memory() const { return solver_->memory(); }
  /// \pre setTopology() was called
  void restoreState(const SolverState& memory) { solver_->restoreState(memory); }

  /// Advances `motion` by one time step. `air_damping` [1/s] is mass-proportional. A step that
  /// fails is cut in two, again and again down to time_step / 1024; if that fails too, `motion` is
  /// left as it was and the report says why.
  StepReport step(Shell& shell, double air_damping, Drive& drive, Motion& motion);

  /// Moves `motion` to equilibrium in rounds without inertia, each downhill as far as a viscous
  /// step of growing length goes; held vertices stay and all speeds are zero afterwards. After
  /// each round `adapt` may change the shell. Where it finds no equilibrium, because the paper
  /// falls, say, `motion` is left as it was and the report says so.
  StepReport relax(Shell& shell, const std::function<void(Shell&, const Positions&)>& adapt,
                   Motion& motion);

 private:
  bool stepInParts(Shell& shell, double air_damping, Drive& drive, double from, double to,
                   int depth, Motion& motion, StepReport& report);

  SolverConfig config_;
  std::vector<bool> free_;
  std::unique_ptr<ImplicitSolver> solver_;
  std::unique_ptr<Integrator> integrator_;
  /// Takes the parts of a failed step: for implicit schemes backward Euler. Newmark's acceleration
  /// of a short step, multiplied by a long step's dt^2, threw paper about.
  std::unique_ptr<Integrator> retry_;
  Positions held_;
};

}  // namespace shell_origami
