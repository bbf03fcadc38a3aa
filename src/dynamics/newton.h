/// \file
/// The nonlinear solve of an implicit step.
#pragma once

#include "dynamics/cholesky.h"
#include "dynamics/system_matrix.h"
#include "shell/shell.h"

#include <string>
#include <vector>

namespace shell_origami {

/// What an implicit step minimizes beside the shell's energy:
/// stiffness / 2 |x - anchor|^2 weighted by the lumped masses.
struct Inertia {
  double stiffness;  ///< [1/s^2]
  Positions anchor;  ///< [m]
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0;
  int factorizations = 0;
  double last_step = 0;  ///< largest displacement of a vertex by the last full Newton step [m]
  std::string failure;
  int vertex = -1;  ///< that the last step moved most
};

/// Newton's method on the free vertices, with a line search that forgives one step uphill: a turn of
/// thin paper, taken along its tangent, stretches it, and the next step takes that back. Where the
/// second step does not end lower, the search goes back and shortens the first (a watchdog,
/// Chamberlain et al. 1982).
class Newton {
 public:
  /// Tells it that topology or pins changed. `free[v]` is false for held vertices.
  void setTopology(const Shell& shell, const std::vector<bool>& free);

  /// Moves x to the minimum, within `tolerance` [m]. No hinge is carried through 180 degrees and
  /// no triangle collapses on the way from x. Held vertices stay.
  NewtonResult minimize(const Shell& shell, const Inertia& inertia, double tolerance,
                        int max_iterations, Positions& x);

  bool isFree(int v) const { return unknown_[v] >= 0; }

 private:
  double objective(const Shell& shell, const Inertia& inertia, const Positions& x) const;
  bool direction(const Shell& shell, const Inertia& inertia, const Positions& x,
                 HessianKind kind);
  bool computeStep(const Shell& shell, const Inertia& inertia, const Positions& x,
                   NewtonResult& result);
  bool backtrack(const Shell& shell, const Inertia& inertia);

  /// Where a search begins.
  struct Base {
    Positions x, step;
    std::vector<double> angles;
    double value = 0;  ///< of the objective [J]
    double slope = 0;  ///< its first-order change along the step [J]
  };

  std::vector<int> unknown_;  ///< block row of each vertex, -1 where held
  int unknown_count_ = 0;
  SystemMatrix matrix_;
  Cholesky cholesky_;
  // Scratch, kept between iterations.
  Base base_;
  std::vector<double> angles_;
  Positions gradient_, step_, trial_;
  Eigen::VectorXd right_hand_side_;
};

}  // namespace shell_origami
