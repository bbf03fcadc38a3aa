/// \file
/// The nonlinear solve of an implicit step.
#pragma once

#include <shell_origami/dynamics/objective.h>
#include <shell_origami/linear/stencil_system.h>

#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

/// Wall time of the parts of solves [s].
struct SolverTimes {
  double symbolic = 0;  ///< order and pattern of the factor, after a change of topology
  double assembly = 0;  ///< forces and Hessians
  double numeric = 0;   ///< factorizations
  double solve = 0;     ///< with a factor
  double search = 0;    ///< energies along a step

  double total() const { return symbolic + assembly + numeric + solve + search; }
  SolverTimes& operator+=(const SolverTimes& other);
  SolverTimes& operator-=(const SolverTimes& other);
};

/// State of the solver that one step passes on to the next. It is reset after events across which
/// it predicts nothing: an edit, a divided step, a solve that renewed its factor.
struct SolverState {
  double contraction = 1;  ///< second step over first, in the solve that last took both
  int unchecked = 0;       ///< solves since that one
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  int factorizations = 0;
  int analyses = 0;          ///< of the matrix pattern, where stencils were not covered
  double gradient_norm = 0;  ///< of the objective, where the last step started [N]
  double last_step = 0;      ///< largest displacement of a vertex by the last full step [m]
  double error = 0;          ///< what the solve may still be off by after that step [m]
  std::string failure;
  int vertex = -1;  ///< where it failed
  SolverTimes times;
};

/// Newton's method on the free vertices, with peculiarities of thin paper, which hardly stretches:
/// - The stress in the geometric stiffness is not that of the iterate, which a turn along its
///   tangent has stretched, but what the last step predicted to first order, and at the start that
///   of the last equilibrium (the mixed integration points of Magisano, Leonetti and Garcea 2017;
///   Potential::predict). It saves half of the iterations, and makes the next peculiarity possible.
/// - A factor serves as long as the steps it gives shrink fast (simplified Newton). Stresses that
///   were not predicted pull along the tangents of the paper where the factor was made
///   (Potential::redirect), as where a mixed system of displacements and stresses is solved by an
///   old matrix. Along the present tangents they would have a part across the old paper, which is a
///   million times softer that way: the step would be a hundred times too long.
/// - The line search forgives one step uphill, which the next may take back; where it does not, the
///   search goes back and shortens the first (a watchdog, Chamberlain et al. 1982).
/// - A step that runs into something is computed again with a spring at each impact
///   (Potential::anticipate). Paper that meets paper in a hundred places would otherwise be stopped
///   at each of them in turn.
/// - Bodies whose way is blocked by paper move along with the steps and push the paper ahead: their
///   motion is on the right-hand side of the system. Until they have arrived there is no minimum to
///   fall to, and steps are taken as far as they are permitted.
class Newton {
 public:
  /// Says that the mesh, the potentials or the held vertices changed. `free[v]` is false for held
  /// vertices; those from `first_body` on are of bodies.
  void setFree(const std::vector<bool>& free, int first_body);

  const SolverState& state() const { return state_; }
  void restoreState(const SolverState& state) { state_ = state; }

  /// The pattern of the system's matrix, which is history, for solves that give the same bits.
  const VertexGraph& pattern() const { return system_.pattern(); }
  bool restorePattern(VertexGraph pattern) { return system_.restorePattern(std::move(pattern)); }

  /// Moves x from where it starts to the minimum of the potentials and the inertia, within
  /// `tolerance` [m]. Every step is one that all potentials permit, and so is the way to the start
  /// from `before`, where the paper was last in equilibrium. Held vertices stay where they start,
  /// and bodies arrive there.
  NewtonResult minimize(const Potentials& potentials, const Eigen::VectorXd& masses,
                        const Inertia& inertia, const Positions& before, double tolerance,
                        int max_iterations, Positions& x);

  /// Returns by how much the potentials at x, the minimum found last, are above those at `before`
  /// of that search [J].
  double potentialChange(const Positions& before, const Positions& x);
  /// Whether forces at that minimum may jump within a step.
  bool rough() const { return objective_.rough(); }
  /// Returns what a potential of that search keeps of the minimum.
  Potential::Iterate& reached(const Potential& potential) { return objective_.current(potential); }

 private:
  /// Where a search along a step begins.
  struct Base {
    Positions x, along, step;
    double value = 0;  ///< of the objective [J]
    double slope = 0;  ///< its first-order change along the step [J]
  };

  bool begin(const Positions& before, Positions& x);
  bool findArriving(const Positions& x);
  bool advanceBodies(Positions& x);
  bool assembleAndFactorize(const Positions& x, HessianKind kind, NewtonResult& result);
  bool factorize(const Positions& x, NewtonResult& result);
  bool solve(const Positions& gradient, NewtonResult& result);
  bool solveWithOldFactor(const Positions& x, double tolerance, NewtonResult& result);
  bool computeStep(const Positions& x, double tolerance, NewtonResult& result);
  double avoidImpacts(const Positions& x, double part, NewtonResult& result);
  void setHeldZero(Positions& gradient) const;
  bool isClose(const NewtonResult& result, double tolerance);
  bool backtrack(bool uphill);
  void remember(const Positions& x);

  std::vector<bool> free_;
  int first_body_ = 0;
  Objective objective_;
  StencilSystem system_;
  bool factorized_ = false;  ///< whether there is a factor of this solve
  Positions factor_x_;       ///< where it was made
  bool arriving_ = false;    ///< whether bodies are not yet where they are to be
  Positions bodies_;         ///< where that is
  PrescribedMotion motion_;  ///< their way from x to there
  SolverState state_;
  // Scratch, kept between iterations and steps.
  Base base_;
  Positions gradient_, redirected_, step_, trial_, blocked_, anticipated_;
};

}  // namespace shell_origami
