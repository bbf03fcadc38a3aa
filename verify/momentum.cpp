/// Item 2: rigid motions change no energy; floating paper keeps its momentum.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>
#include "verify/free_motion.h"
#include "verify/topics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kSide = 0.1;  // [m]
const std::string kItem = "2 Rigid motions and momentum";
/// 1.1e-16 of the coordinates, which are 20 times an edge, over a strain of 0.2, in a square.
constexpr double kEnergyRounding = 2.5e-14;
/// Each force is a sum of about 18 terms that are rounded to 1.1e-16.
constexpr double kForceRounding = 2.2e-16;
/// A velocity is a difference of positions, rounded to 2e-17 m, over dt = 1e-3 s: 6e-14 of the
/// paper's 0.6 m/s. 200 steps of random sign, averaged over some 40 vertices, are twice that.
constexpr double kDriftRounding = 2.5e-13;

Vector3 totalCross(const Eigen::VectorXd& weights, const Positions& a, const Positions& b) {
  Vector3 total = Vector3::Zero();
  for (Eigen::Index v = 0; v < a.cols(); ++v) {
    total += weights[v] * Vector3(a.col(v)).cross(Vector3(b.col(v)));
  }
  return total;
}

/// A bent sheet.
Positions bent(const Sheet& sheet) {
  Positions x = flatInSpace(sheet);
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const Vector2 p = x.col(v).head<2>() / kSide;
    x(2, v) = kSide * 0.2 * std::sin(3 * p.x() + p.y()) * p.y();
  }
  return x;
}

void verifyRigidMotions(VerificationReport& report, const Sheet& sheet) {
  const ShellPotential potential(sheet, Material(), Vector3::Zero());
  const Positions x = bent(sheet);
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.5, -0.1, 0.7, 0.4).normalized().toRotationMatrix();
  const Positions moved = (turn * x).colwise() + Vector3(0.1, -0.3, 0.2);
  const auto energy = [&potential](const Positions& at) {
    return potential.membraneEnergy(at) + potential.bendingEnergy(at);
  };
  Positions force = Positions::Zero(3, x.cols());
  potential.addGradient(x, force);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(x.cols());
  const double forces = force.colwise().norm().sum();
  report.add({kItem, "energy of a bent sheet, turned and shifted, over itself, less 1", 0,
              energy(moved) / energy(x) - 1, kEnergyRounding,
              "rounding of coordinates 20 times an edge, over a strain of 0.2"});
  report.add({kItem, "sum of the forces over the sum of their sizes", 0,
              force.rowwise().sum().norm() / forces, kForceRounding, "rounding"});
  report.add({kItem, "sum of their moments over that of forces times arms", 0,
              totalCross(ones, x, force).norm() / (forces * kSide), kForceRounding, "rounding"});
}

struct Drift {
  double linear = 0, angular = 0, invariant = 0;  ///< largest, over the sums of sizes
};

/// A thrown, spinning and vibrating sheet by Newmark's scheme at (1/4, 1/2). This is the
/// trapezoidal rule, whose states are half way between those of the implicit midpoint rule, which
/// conserves J = sum m x x v. The trapezoidal rule therefore conserves J half a step later, (x +
/// dt/2 v) x (v + dt/2 a), where sum m x x a = 0.
Drift momentumDrift(const Sheet& sheet, double time_step, int steps) {
  SolverConfig solver;
  solver.gamma = 0.5;
  solver.time_step = time_step;
  solver.tolerance = 1e-9;
  const Positions x = flatInSpace(sheet);
  const Vector3 throw_velocity(0.3, -0.2, 0.5), spin(2, 3, -1);
  Positions velocities(3, x.cols());
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const Vector2 p = x.col(v).head<2>() / kSide;
    velocities.col(v) = throw_velocity + spin.cross(Vector3(x.col(v)));
    velocities(2, v) += 0.1 * std::cos(4 * p.x()) * std::cos(3 * p.y());
  }
  FreeMotion motion(sheet, softBoard(), solver, x, velocities);
  const Eigen::VectorXd& masses = motion.shell().masses();
  const auto linear = [&] { return Vector3(motion.motion().velocities * masses); };
  const auto angular = [&] {
    return totalCross(masses, motion.motion().positions, motion.motion().velocities);
  };
  const auto invariant = [&] {
    return Vector3(angular() + time_step * time_step / 4 *
                                   totalCross(masses, motion.motion().velocities,
                                              motion.motion().accelerations));
  };
  const double scale = velocities.colwise().norm().dot(masses.transpose());
  const Vector3 linear_start = linear(), angular_start = angular(), invariant_start = invariant();
  Drift drift;
  for (int i = 0; i < steps; ++i) {
    motion.step();
    drift.linear = std::max(drift.linear, (linear() - linear_start).norm() / scale);
    drift.angular = std::max(drift.angular, (angular() - angular_start).norm() / (scale * kSide));
    drift.invariant =
        std::max(drift.invariant, (invariant() - invariant_start).norm() / (scale * kSide));
  }
  return drift;
}

}  // namespace

void verifyMomentum(VerificationReport& report) {
  const Sheet sheet(triangulateRectangle(kSide, kSide, 0.02));
  verifyRigidMotions(report, sheet);
  const Drift coarse = momentumDrift(sheet, 2e-3, 100), fine = momentumDrift(sheet, 1e-3, 200);
  report.add({kItem, "drift of the linear momentum over sum m |v|, 200 steps", 0, fine.linear,
              kDriftRounding, "rounding of positions, over dt, in 200 steps"});
  report.add(
      {kItem, "drift of J + dt^2/4 sum m v x a over sum m |v| times the side, 200 steps", 0,
       fine.invariant, kDriftRounding,
       "Newmark's scheme at (1/4, 1/2) conserves this instead of J = sum m x x v; rounding as "
       "above"});
  report.add(
      {kItem, "order in dt of the drift of J itself", 2, std::log2(coarse.angular / fine.angular),
       0.05,
       "J differs from the conserved sum by dt^2/4 sum m v x a; the two runs see its largest "
       "value at slightly different times"});
}

}  // namespace shell_origami
