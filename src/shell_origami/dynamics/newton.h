/// \file
/// The nonlinear solve of an implicit step.
#pragma once

#include <shell_origami/energy/shell.h>
#include <shell_origami/linear/block_matrix.h>
#include <shell_origami/linear/cholesky.h>

#include <string>
#include <vector>

namespace shell_origami {

/// What an implicit step minimizes beside the shell's energy:
/// stiffness / 2 |x - anchor|^2 weighted by the lumped masses.
struct Inertia {
  double stiffness;  ///< [1/s^2]
  Positions anchor;  ///< [m]
};

/// Where the time of solves went [s].
struct SolverTimes {
  double symbolic = 0;  ///< order and pattern of the factor, after a change of topology
  double assembly = 0;  ///< forces and Hessians
  double numeric = 0;   ///< factorizations
  double solve = 0;     ///< with a factor
  double search = 0;    ///< energies along a step

  double total() const { return symbolic + assembly + numeric + solve + search; }
  SolverTimes& operator+=(const SolverTimes& other);
};

/// What one solve leaves to the next.
struct SolverState {
  double contraction = 1;  ///< second step over first, in the solve that last took both
  int unchecked = 0;       ///< solves since that one
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  int factorizations = 0;
  double last_step = 0;  ///< largest displacement of a vertex by the last full step [m]
  std::string failure;
  int vertex = -1;  ///< where it failed
  SolverTimes times;
};

/// Newton's method on the free vertices, with three peculiarities of thin paper, which hardly
/// stretches:
/// - The stress in the geometric stiffness is not that of the iterate, which a turn along its
///   tangent has stretched, but what the last step predicted to first order, and at the start that
///   of the last equilibrium (the mixed integration points of Magisano, Leonetti and Garcea 2017).
///   It saves half of the iterations, and makes the next peculiarity possible.
/// - A factor serves as long as the steps it gives shrink fast (simplified Newton).
/// - The line search forgives one step uphill, which the next may take back; where it does not, the
///   search goes back and shortens the first (a watchdog, Chamberlain et al. 1982).
class Newton {
 public:
  /// Tells it that topology or pins changed. `free[v]` is false for held vertices.
  void setTopology(const Shell& shell, const std::vector<bool>& free);

  const SolverState& memory() const { return memory_; }
  void restoreState(const SolverState& memory) { memory_ = memory; }

  /// Moves x from where it starts to the minimum, within `tolerance` [m]. No hinge is carried
  /// through 180 degrees and no triangle collapses on the way from `before`, where the paper was
  /// last in equilibrium. Held vertices stay.
  NewtonResult minimize(const Shell& shell, const Inertia& inertia, const Positions& before,
                        double tolerance, int max_iterations, Positions& x);

 private:
  /// Where a search begins.
  struct Base {
    Positions x, step;
    std::vector<FoldAngle> angles;
    double value = 0;  ///< of the objective [J]
    double slope = 0;  ///< its first-order change along the step [J]
  };

  bool start(const Shell& shell, const Inertia& inertia, const Positions& before,
             const Positions& x, NewtonResult& result);
  double objective(const Shell& shell, const Inertia& inertia, const Positions& x,
                   const std::vector<FoldAngle>& before, std::vector<FoldAngle>& angles) const;
  bool assembleAndFactorize(const Shell& shell, const Inertia& inertia, const Positions& x,
                            HessianKind kind, NewtonResult& result);
  bool factorize(const Shell& shell, const Inertia& inertia, const Positions& x,
                 NewtonResult& result);
  double solve(NewtonResult& result);
  bool computeStep(const Shell& shell, const Inertia& inertia, const Positions& x,
                   NewtonResult& result);
  bool isClose(const NewtonResult& result, double tolerance);
  bool backtrack(const Shell& shell, const Inertia& inertia);
  void remember(const Positions& x);
  void advance(Positions& x);

  std::vector<int> unknown_;  ///< block row of each vertex, -1 where held
  int unknown_count_ = 0;
  BlockMatrix matrix_;
  Cholesky cholesky_;
  bool factorized_ = false;  ///< whether there is a factor of this solve
  SolverState memory_;
  // Scratch, kept between iterations and steps.
  Base base_;
  double value_ = 0, trial_value_ = 0;
  std::vector<FoldAngle> angles_before_, angles_, trial_angles_;
  std::vector<HingeGradient> angle_gradients_;
  std::vector<MembraneStrain> strains_;
  Positions gradient_, step_, trial_;
  Eigen::VectorXd right_hand_side_;
};

}  // namespace shell_origami
