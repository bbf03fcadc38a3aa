/// \file
/// Item 12: the three integrators on one fold: the largest step, and the cost of a simulated
/// second.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>
#include "verify/topics.h"

#include <Eigen/Eigenvalues>

#include <chrono>
#include <cmath>
#include <map>

namespace shell_origami {
namespace {

constexpr char kItem[] = "12 Integrators on one fold";
constexpr double kSide = 0.15, kTarget = 170 * M_PI / 180, kDuration = 1;

Simulation folding(const SolverConfig& solver, double max_edge) {
  SimulationConfig config;
  config.solver = solver;
  Simulation simulation(Sheet(triangulateRectangle(kSide, kSide, max_edge)), config);
  FoldEdit fold;
  fold.where = Segment{Vector2(0, 0), Vector2(kSide, kSide)};
  fold.angle = kTarget;
  fold.duration = kDuration;
  simulation.fold(fold);
  return simulation;
}

SolverConfig solverOf(IntegratorKind kind, double time_step) {
  SolverConfig solver;
  solver.integrator = kind;
  solver.time_step = time_step;
  return solver;
}

/// 2 over the highest frequency of the flat sheet [s]: longer explicit steps grow without bound
/// (Courant, Friedrichs & Lewy 1928).
double stabilityLimit(double max_edge) {
  const Simulation simulation = folding({}, max_edge);
  const Shell& shell = simulation.shell().shell();
  const int triangles = static_cast<int>(shell.triangles().size());
  Eigen::MatrixXd stiffness =
      Eigen::MatrixXd::Zero(3 * shell.vertexCount(), 3 * shell.vertexCount());
  shell.forEachExactHessian(
      simulation.positions(), simulation.shell().rest, [&](int stencil, const auto& block) {
        const int* at = stencil < triangles ? shell.triangles()[stencil].data()
                                            : shell.hinges()[stencil - triangles].vertices.data();
        const int count = static_cast<int>(block.rows()) / 3;
        for (int i = 0; i < count; ++i) {
          for (int j = 0; j < count; ++j) {
            stiffness.block<3, 3>(3 * at[i], 3 * at[j]) +=
                block.template block<3, 3>(3 * i, 3 * j) /
                std::sqrt(shell.masses()[at[i]] * shell.masses()[at[j]]);
          }
        }
      });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, Eigen::EigenvaluesOnly);
  return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
}

/// Returns whether rounding errors stay small in the explicit scheme.
bool explicitHolds(double time_step, double max_edge) {
  Simulation simulation = folding(solverOf(IntegratorKind::kSymplecticEuler, time_step), max_edge);
  for (int i = 0; i < 1000; ++i) {
    const StepReport report = simulation.step();
    if (!report.converged || report.retries > 0) return false;
  }
  return simulation.maxStrain() < 1e-3;
}

double largestExplicitStep(double max_edge) {
  double holds = 1e-8, fails = 1e-3;
  while (fails / holds > 1.01) {
    const double middle = std::sqrt(holds * fails);
    (explicitHolds(middle, max_edge) ? holds : fails) = middle;
  }
  return holds;
}

/// Returns whether the fold ends within a degree of its target without a retried step.
bool implicitHolds(IntegratorKind kind, double time_step, double max_edge) {
  Simulation simulation = folding(solverOf(kind, time_step), max_edge);
  while (simulation.time() < 3 * kDuration) {
    const StepReport report = simulation.step();
    if (!report.converged || report.retries > 0) return false;
  }
  return std::abs(simulation.creases()[0].angle - kTarget) < M_PI / 180;
}

double largestImplicitStep(IntegratorKind kind, double max_edge) {
  double time_step = 1.0 / 60;
  while (time_step < kDuration && implicitHolds(kind, 2 * time_step, max_edge)) time_step *= 2;
  return time_step;
}

/// Elapsed over simulated time, through the first part of the fold.
double cost(IntegratorKind kind, double time_step, double max_edge) {
  Simulation simulation = folding(solverOf(kind, time_step), max_edge);
  const int steps = kind == IntegratorKind::kSymplecticEuler ? 3000 : 60;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) simulation.step();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / (steps * time_step);
}

}  // namespace

void verifyIntegrators(VerificationReport& report) {
  const double max_edge = report.fast() ? 0.03 : 0.0058;  // some 80 triangles; 2,000
  const double coarse = report.fast() ? 0.03 : 0.015;     // small enough for its eigenvalues
  report.add({kItem, "largest stable explicit step over 2 / the mesh's highest frequency", 1,
              largestExplicitStep(coarse) / stabilityLimit(coarse), 0.01,
              "found by bisection to 1 %; folding stiffens the crease, which is far from the "
              "stiffest mode"});
  if (report.fast()) return;
  FigureData table =
      report.figure("integrators", {"name", "largest_step", "step", "cost", "ratio"});
  const double newmark = cost(IntegratorKind::kNewmark, 1.0 / 60, max_edge);
  for (const auto& [name, kind] : integratorNames()) {
    const bool is_explicit = kind == IntegratorKind::kSymplecticEuler;
    const double largest =
        is_explicit ? largestExplicitStep(max_edge) : largestImplicitStep(kind, max_edge);
    const double step = is_explicit ? largest : 1.0 / 60;
    const double here = cost(kind, step, max_edge);
    table.row(name, {largest, step, here, here / newmark});
  }
}

}  // namespace shell_origami
