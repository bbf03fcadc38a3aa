/// \file
/// Time steps: one that fails is divided into smaller ones, or undone.
#pragma once

#include <shell_origami/dynamics/implicit_solver.h>

#include <functional>
#include <memory>
#include <utility>

namespace shell_origami {

/// Loads and prescribed positions that change within a step.
class BoundaryConditions {
 public:
  virtual ~BoundaryConditions() = default;
  /// Sets the potentials (such as rest angles) and, in `prescribed`, the positions [m] of vertices
  /// that are not free, at the fraction s in (0, 1] of the whole step.
  virtual void applyAt(double s, Positions& prescribed) = 0;
  /// Whether nothing changes within the step, so that no work is done on the paper.
  virtual bool constant() const = 0;
  /// How often a step that fails may be divided in two.
  virtual int mostDivisions() const { return kMostDivisions; }

  static constexpr int kMostDivisions = 10;
};

class Stepper {
 public:
  explicit Stepper(const SolverConfig& config);

  /// To be called when the mesh, the potentials or the held vertices have changed. `free[v]` is
  /// false for held vertices. The last `body_vertices` are of rigid bodies, which are not free
  /// either: where paper is in their way they push it ahead.
  void setFree(std::vector<bool> free, int body_vertices = 0);

  /// The state that a step passes on to the next, with which another stepper can continue.
  const SolverState& state() const { return solver_->state(); }
  /// \pre setFree() was called
  void restoreState(const SolverState& state) { solver_->restoreState(state); }
  /// The pattern of the matrix, which another stepper needs as well to continue to the bit. Returns
  /// false where it does not fit the free vertices. \pre setFree() was called
  const VertexGraph& pattern() const { return solver_->pattern(); }
  bool restorePattern(VertexGraph pattern) { return solver_->restorePattern(std::move(pattern)); }

  /// Advances `motion` by one time step. `masses` [kg] are lumped, one for each vertex;
  /// `air_damping` [1/s] is mass-proportional. A step that fails is divided in two down to
  /// time_step / 1024, or as far as the conditions say; if that fails as well, `motion` is
  /// unchanged and the report says why.
  StepReport step(const Potentials& potentials, const Eigen::VectorXd& masses, double air_damping,
                  BoundaryConditions& conditions, Motion& motion);

  /// Moves `motion` to equilibrium by viscous steps of growing length, without inertia. Held
  /// vertices do not move and all velocities are zero afterwards. After each viscous step `adapt`
  /// may change the potentials. If there is no equilibrium, for example because the paper falls,
  /// `motion` is unchanged and the report says so.
  StepReport relax(const Potentials& potentials, const Eigen::VectorXd& masses,
                   const std::function<void(const Positions&)>& adapt, Motion& motion);

  /// Returns what a potential keeps of the configuration that the last step or relaxation, by an
  /// implicit scheme, came to, such as its contacts and their friction. \pre it converged
  Potential::Iterate& reached(const Potential& potential) { return solver_->reached(potential); }

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
