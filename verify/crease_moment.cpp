/// Item 6: a crease held by a weight, M = c (phi - phi_rest) sec^2(theta / 2) with phi_rest = 0.
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>
#include "verify/topics.h"

#include <Eigen/Geometry>

#include <cmath>
#include <stdexcept>

namespace shell_origami {
namespace {

constexpr double kSide = 0.1, kFold = 0.05;  // sheet, and where its crease lies across [m]
const std::string kItem = "6 Crease opened by a moment";
const std::string kWhy =
    "both sides are measured where the flap rests, the closed form at the angle of each hinge. The "
    "flap still swings: Newton's method stops at 1e-9 m/s, which is 2e-11 m in a step, 5e-9 of the "
    "deflection at 5 degrees";

/// Board that hardly bends with the crease of paper, so that only the crease deforms.
SimulationConfig board() {
  SimulationConfig config;
  config.material.thickness = 2e-3;
  config.solver.gamma = 1;
  config.solver.tolerance = 1e-9;
  return config;
}

double closedForm(double theta) {
  const double tangent = std::tan(theta / 2);
  return Material().crease_stiffness * 2 * tangent * (1 + tangent * tangent);
}

/// A flap that is held open by its weight. Moments are per length of the crease [N].
struct Flap {
  double angle;      ///< of the crease, mean [rad]
  double weight;     ///< moment of the weight about the crease
  double by_angles;  ///< mean of the closed form over the crease, at the angles of its hinges
};

/// Gravity is perpendicular to the flap at `theta`, where it balances the crease: the moment of a
/// flat flap's weight is rho t g l^2 / 2 per length.
Flap hangFlap(double theta, double max_edge) {
  SimulationConfig config = board();
  constexpr double kFlap = kSide - kFold;
  const double gravity = closedForm(theta) / (config.material.arealDensity() * kFlap * kFlap / 2);
  config.gravity = gravity * Vector3(-std::sin(theta), 0, std::cos(theta));
  // Critical damping of a moment of inertia rho t l^3 / 3 on the crease's stiffness there.
  const double stiffness = closedForm(theta) / std::tan(theta / 2);
  const double frequency =
      std::sqrt(stiffness / (config.material.arealDensity() * std::pow(kFlap, 3) / 3));  // [rad/s]
  config.material.air_damping = 2 * frequency;
  config.solver.time_step = 0.2 / frequency;
  Sheet sheet(triangulateRectangle(kSide, kSide, max_edge));
  makeFoldLine(sheet, {Vector2(kFold, 0), Vector2(kFold, kSide)});
  // It starts folded by nine tenths of the angle, from where gravity turns it the right way.
  Positions x = flatInSpace(sheet);
  std::vector<std::int64_t> held;
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const double out = x(0, v) - kFold;
    if (out < 1e-9) held.push_back(v);
    else x.col(v) << kFold + out * std::cos(0.9 * theta), x(1, v), out * std::sin(0.9 * theta);
  }
  Simulation simulation(sheet, config, x, {0.0});
  simulation.pin(held);
  for (int i = 0; i < 400; ++i) {
    if (!simulation.step().converged) throw std::runtime_error("the flap does not swing");
  }
  const Shell shell(sheet, config.material);
  Flap flap{simulation.creases()[0].angle, 0, 0};
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    if (sheet.flatPositions()[v].x() < kFold) continue;
    const Vector3 arm = simulation.positions().col(v) - Vector3(kFold, 0, 0);
    flap.weight -= shell.masses()[v] * arm.cross(config.gravity).y() / kSide;
  }
  for (int j : shell.creaseHinges()[0]) {
    flap.by_angles +=
        closedForm(shell.foldAngle(j, simulation.positions())) * shell.hinges()[j].length / kSide;
  }
  return flap;
}

/// Writes moment over stiffness of creases with several rest angles, for doc/figures.py: by
/// creaseBend(), and by phi alone.
void drawCreaseLaw(const VerificationReport& report) {
  FigureData figure = report.figure("crease_law", {"rest", "angle", "moment", "plain_moment"});
  for (const double rest : {0.0, 90.0, 170.0}) {
    for (double angle = -60; angle < 179; angle += 0.5) {
      const double theta = angle * M_PI / 180;
      const Bend bend = creaseBend(theta, rest * M_PI / 180);
      const Bend plain = hingeBend(theta, rest * M_PI / 180);
      const double slope = phi(rest * M_PI / 180).first;  // 1 per radian at rest, as the other
      figure.row(
          {rest, angle, bend.value * bend.first, plain.value * plain.first / (slope * slope)});
    }
  }
}

}  // namespace

void verifyCreaseMoment(VerificationReport& report) {
  drawCreaseLaw(report);
  const double max_edge = report.fast() ? 0.025 : 0.01;
  FigureData figure = report.figure("crease_moment", {"angle", "moment"});
  for (const double degrees : {5.0, 30.0, 60.0, 90.0, 120.0, 150.0, 170.0}) {
    const double theta = degrees * M_PI / 180;
    const Flap flap = hangFlap(theta, max_edge);
    figure.row({flap.angle * 180 / M_PI, flap.weight});
    report.add({kItem,
                "M / closed form at " + std::to_string(static_cast<int>(degrees)) + " degrees", 1,
                flap.weight / flap.by_angles, 5e-9, kWhy});
  }
}

}  // namespace shell_origami
