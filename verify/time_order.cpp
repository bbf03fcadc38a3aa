/// Item 3: the order in dt of a free vibration, by refinement of the time step.
#include "verify/clamped_sheet.h"
#include "verify/free_motion.h"
#include "verify/topics.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace shell_origami {
namespace {

constexpr int kRows = 4;
/// Amplitude of the tip over the length, so small that stretching, of second order in it, is not
/// seen.
constexpr double kAmplitude = 1e-4;
constexpr double kPeriods = 1.25;
const std::string kItem = "3 Order in time";
const std::string kWhy =
    "from the differences between three time steps, each half of the one before; terms of the next "
    "order change the result by less than 0.02, on the coarser steps of a fast run by less than "
    "0.08";

/// A mode of vibration around the flat state.
struct Mode {
  Eigen::RowVectorXd deflection;  ///< of each vertex, at most 1
  double angular_frequency;       ///< [rad/s]
};

/// Returns the slowest mode of the discrete sheet, by inverse iteration. Any other initial state
/// would contain fast modes that only the finest time steps resolve.
Mode slowestMode(const ClampedSheet& sheet, const Material& material) {
  const Shell shell(sheet.sheet, material);
  const int n = shell.vertexCount(), triangles = static_cast<int>(shell.triangles().size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  shell.forEachExactHessian(
      flatInSpace(sheet.sheet), shell.restState(), [&](int stencil, const auto& block) {
        const int* at = stencil < triangles ? shell.triangles()[stencil].data()
                                            : shell.hinges()[stencil - triangles].vertices.data();
        const int count = static_cast<int>(block.rows()) / 3;
        for (int i = 0; i < count; ++i) {
          for (int j = 0; j < count; ++j) stiffness(at[i], at[j]) += block(3 * i + 2, 3 * j + 2);
        }
      });
  for (std::int64_t v : sheet.held) {
    stiffness.row(v).setZero();
    stiffness.col(v).setZero();
    stiffness(v, v) = stiffness.diagonal().maxCoeff();
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(stiffness);
  Eigen::VectorXd deflection = Eigen::VectorXd::Ones(n);
  double stretch = 1;
  for (int i = 0; i < 100; ++i) {
    for (std::int64_t v : sheet.held) deflection[v] = 0;
    deflection = factor.solve(shell.masses().cwiseProduct(deflection));
    stretch = deflection.cwiseAbs().maxCoeff();
    deflection /= stretch;
  }
  return {deflection.transpose(), 1 / std::sqrt(stretch)};
}

/// Returns positions, and velocities over the angular frequency, after kPeriods in `steps` steps.
Eigen::MatrixXd stateAfter(const ClampedSheet& sheet, const Mode& mode, SolverConfig solver,
                           int steps) {
  const double speed = kAmplitude * sheet.length * mode.angular_frequency;
  solver.time_step = kPeriods * 2 * M_PI / mode.angular_frequency / steps;
  solver.tolerance = 1e-8 * speed;
  const Positions flat = flatInSpace(sheet.sheet);
  Positions velocities = Positions::Zero(3, flat.cols());
  velocities.row(2) = speed * mode.deflection;
  FreeMotion motion(sheet.sheet, softBoard(), solver, flat, velocities, sheet.held);
  for (int i = 0; i < steps; ++i) motion.step();
  Eigen::MatrixXd state(6, flat.cols());
  state << motion.motion().positions - flat, motion.motion().velocities / mode.angular_frequency;
  return state / (kAmplitude * sheet.length);
}

}  // namespace

void verifyTimeOrder(VerificationReport& report) {
  struct Scheme {
    std::string name;
    IntegratorKind integrator;
    double gamma;
    int order, coarsest;
  };
  const ClampedSheet sheet = clampedSheet(0.1, 2, kRows);
  const Mode mode = slowestMode(sheet, softBoard());
  FigureData figure = report.figure("time_order", {"scheme", "steps_per_period", "difference"});
  // The explicit scheme is stable only in steps that follow the fastest wave.
  for (const Scheme& scheme :
       {Scheme{"Newmark, beta = 1/4, gamma = 1/2", IntegratorKind::kNewmark, 0.5, 2, 32},
        Scheme{"Newmark, gamma = 0.6", IntegratorKind::kNewmark, 0.6, 1, 64},
        Scheme{"backward Euler", IntegratorKind::kBackwardEuler, 0.5, 1, 128},
        Scheme{"symplectic Euler", IntegratorKind::kSymplecticEuler, 0.5, 1, 2048}}) {
    SolverConfig solver;
    solver.integrator = scheme.integrator;
    solver.gamma = scheme.gamma;
    std::vector<double> differences;
    const int finest = scheme.coarsest * (report.fast() ? 8 : 32);
    Eigen::MatrixXd coarse = stateAfter(sheet, mode, solver, scheme.coarsest);
    for (int steps = 2 * scheme.coarsest; steps <= finest; steps *= 2) {
      const Eigen::MatrixXd fine = stateAfter(sheet, mode, solver, steps);
      const double difference = (fine - coarse).norm() / std::sqrt(fine.cols());
      figure.row(scheme.name, {0.5 * steps / kPeriods, difference});
      differences.push_back(difference);
      coarse = fine;
    }
    const std::size_t n = differences.size();
    report.add({kItem, scheme.name, static_cast<double>(scheme.order),
                std::log2(differences[n - 2] / differences[n - 1]), report.fast() ? 0.08 : 0.02,
                kWhy});
  }
}

}  // namespace shell_origami
