/// \file
/// One step through time: implicit Newmark (Discrete Shells Origami, figure 4).
#pragma once

#include "shell/shell.h"

#include <memory>
#include <string>
#include <vector>

namespace shell_origami {

/// Motion of the sheet: one column a vertex.
struct Motion {
  Positions positions;      ///< [m]
  Positions velocities;     ///< [m/s]
  Positions accelerations;  ///< [m/s^2]
};

struct SolverConfig {
  double time_step = 1.0 / 60;  ///< [s]
  double beta = 0;              ///< Newmark beta; 0: (gamma + 1/2)^2 / 4, which damps best
  double gamma = 0.6;           ///< Newmark gamma; above 1/2 damps, 1/2 conserves energy
  double tolerance = 1e-4;      ///< largest Newton step of a vertex over the time step [m/s]
  int max_iterations = 30;      ///< Newton iterations before a step is retried smaller
};

/// What a step cost and whether it held.
struct StepReport {
  bool converged = true;
  int newton_iterations = 0;
  int factorizations = 0;
  int retries = 0;          ///< times a step was cut in two
  double residual = 0;      ///< last Newton step over the time step [m/s]
  std::string failure;      ///< why it did not converge, and where
};

/// Sets the shell's rest state for the end of a (sub)step that ends at fraction s in (0, 1] of
/// the whole step.
class Drive {
 public:
  virtual ~Drive() = default;
  virtual void moveTo(double s, Shell& shell) = 0;
};

class Newmark {
 public:
  explicit Newmark(const SolverConfig& config);
  ~Newmark();
  Newmark(Newmark&&) noexcept;
  Newmark& operator=(Newmark&&) noexcept;

  /// Tells the solver that topology or pins changed. `free[v]` is false for held vertices.
  void setTopology(const Shell& shell, const std::vector<bool>& free);

  /// Advances `motion` by one time step. `air_damping` [1/s] is mass-proportional. Held vertices
  /// stay. When Newton does not converge the step is cut in two, again and again down to
  /// time_step / 1024, and taken by backward Euler; if that fails too, `motion` is left as it was
  /// and the report says why.
  StepReport step(Shell& shell, double air_damping, Drive& drive, Motion& motion);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace shell_origami
