/// \file
/// Steps that hold: a step that fails is taken in smaller ones, or not at all.
#pragma once

#include <shell_origami/dynamics/implicit_solver.h>

#include <functional>
#include <memory>

namespace shell_origami {

/// What changes within a step while the paper follows.
class BoundaryConditions {
 public:
  virtual ~BoundaryConditions() = default;
  /// Puts the potentials (rest angles, say) and, in `prescribed`, the vertices that are not free
  /// [m] where they are at fraction s in (0, 1] of the whole step.
  virtual void applyAt(double s, Positions& prescribed) = 0;
  /// Whether nothing changes within the step, so that no work is done on the paper.
  virtual bool constant() const = 0;
};

class Stepper {
 public:
  explicit Stepper(const SolverConfig& config);

  /// Says that the mesh, the potentials or the held vertices changed. `free[v]` is false for held
  /// vertices.
  void setFree(std::vector<bool> free);

  /// What steps pass on to the next one, for a stepper that goes on where another stood.
  const SolverState& state() const { return solver_->state(); }
  /// \pre setFree() was called
  void restoreState(const SolverState& state) { solver_->restoreState(state); }

  /// Advances `motion` by one time step. `masses` [kg] are lumped, one a vertex; `air_damping`
  /// [1/s] is mass-proportional. A step that fails is cut in two, again and again down to time_step
  /// / 1024; if that fails too, `motion` is left as it was and the report says why.
  StepReport step(const Potentials& potentials, const Eigen::VectorXd& masses, double air_damping,
                  BoundaryConditions& conditions, Motion& motion);

  /// Moves `motion` to equilibrium in rounds without inertia, each downhill as far as a viscous
  /// step of growing length goes; held vertices stay and all speeds are zero afterwards. After
  /// each round `adapt` may change the potentials. Where it finds no equilibrium, because the paper
  /// falls, say, `motion` is left as it was and the report says so.
  StepReport relax(const Potentials& potentials, const Eigen::VectorXd& masses,
                   const std::function<void(const Positions&)>& adapt, Motion& motion);

 private:
  /// The arguments of a step.
  struct Whole {
    const Potentials& potentials;
    const Eigen::VectorXd& masses;
    double air_damping;
    BoundaryConditions& conditions;
  };
  bool take(Integrator& integrator, const Whole& whole, double from, double to, Motion& motion,
            StepReport& report);
  bool stepInParts(const Whole& whole, double from, double to, int depth, Motion& motion,
                   StepReport& report);

  SolverConfig config_;
  std::vector<bool> free_;
  std::unique_ptr<ImplicitSolver> solver_;
  std::unique_ptr<Integrator> integrator_;
  /// Takes the parts of a failed step: for implicit schemes backward Euler. Newmark's acceleration
  /// of a short step, multiplied by a long step's dt^2, threw paper about.
  std::unique_ptr<Integrator> retry_;
  Positions prescribed_;
};

}  // namespace shell_origami
