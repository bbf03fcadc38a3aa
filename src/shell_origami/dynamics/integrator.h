/// \file
/// One step through time, by one of several schemes.
#pragma once

#include <shell_origami/dynamics/newton.h>
#include <shell_origami/dynamics/objective.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace shell_origami {

/// Motion of the sheet: one column a vertex.
struct Motion {
  Positions positions;      ///< [m]
  Positions velocities;     ///< [m/s]
  Positions accelerations;  ///< [m/s^2]
  double acceleration_persistence =
      1;               ///< part of its accelerations that the last step kept, 0 to 1
  bool rough = false;  ///< whether forces may jump in the next step, as where paper touches
};

/// Returns the kinetic energy [J] of velocities [m/s], one column a vertex; `masses` are lumped
/// [kg].
double kineticEnergy(const Positions& velocities, const Eigen::VectorXd& masses);

enum class IntegratorKind { kNewmark, kBackwardEuler, kSymplecticEuler };

/// The kinds by the names that people write.
const std::map<std::string, IntegratorKind>& integratorNames();

struct SolverConfig {
  IntegratorKind integrator = IntegratorKind::kNewmark;
  double time_step = 1.0 / 60;  ///< [s]
  double beta = 0;              ///< Newmark beta; 0: (gamma + 1/2)^2 / 4, which damps best
  double gamma = 0.6;           ///< Newmark gamma; above 1/2 damps, 1/2 conserves energy
  double tolerance = 1e-4;      ///< largest Newton step of a vertex over the time step [m/s]
  int max_iterations = 30;      ///< Newton iterations before a step is retried smaller
  int threads = 1;              ///< that share the work of a step; 0: one for each core
};

/// The cost of a step, and whether it converged.
struct StepReport {
  bool converged = true;
  int newton_iterations = 0;
  int factorizations = 0;
  int analyses = 0;             ///< of the matrix pattern
  int retries = 0;              ///< times a step was cut in two
  double newton_step_rate = 0;  ///< largest displacement of the last Newton step, over dt [m/s]
  double gradient_norm = 0;     ///< of the objective, where the last Newton step started [N]
  SolverTimes times;            ///< of implicit schemes
  std::string failure;          ///< why it did not converge
  int vertex = -1;              ///< where it did not; -1: everywhere
};

/// The forces of a step, and the vertices that are not free to follow them.
struct StepInput {
  const Potentials& potentials;
  const Eigen::VectorXd& masses;  ///< lumped, one a vertex [kg]
  double air_damping;             ///< mass-proportional [1/s]
  const std::vector<bool>& free;  ///< one a vertex; the others are prescribed
  const Positions& prescribed;    ///< where those are at the end of the step [m]
  bool constant;                  ///< no work is done on the paper: its energy cannot rise
};

class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Advances `motion` by dt [s]. False, with the failure in the report and `motion` as it was,
  /// when the scheme finds no step.
  virtual bool step(const StepInput& input, double dt, Motion& motion, StepReport& report) = 0;
};

class ImplicitSolver;

/// The integrator of the config's kind; the implicit ones solve with `solver`, which must live as
/// long.
std::unique_ptr<Integrator> makeIntegrator(const SolverConfig& config, ImplicitSolver& solver);

}  // namespace shell_origami
