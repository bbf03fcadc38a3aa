/// Item 10: the apple's bowl, a cone of far-field slope near acos(1 - alpha / pi).
#include "verify/rigid_origami.h"
#include "verify/topics.h"

#include <cmath>
#include <cstdio>

namespace shell_origami {
namespace {

constexpr double kRadius = 0.06;  // [m]

double foldedSlope(double alpha) {
  Simulation simulation(coneSheet(alpha, kRadius, kRadius / 10), SimulationConfig());
  FoldRequest valley = foldCrease("rho0", 176 * kDegree, 2);
  FoldRequest mountain = foldCrease("rho1", -176 * kDegree, 2);
  valley.stiffness = mountain.stiffness = 0.5;
  simulation.fold(valley);
  simulation.fold(mountain);
  stepUntil(simulation, 5);
  return measuredConeSlope(simulation, alpha, kRadius);
}

}  // namespace

void verifyCone(VerificationReport& report) {
  FigureData figure = report.figure("cone", {"alpha", "slope", "exact"});
  for (double degrees = report.fast() ? 15 : 10; degrees <= (report.fast() ? 15 : 30);
       degrees += 5) {
    const double exact = coneSlope(degrees * kDegree) / kDegree;
    const double slope = foldedSlope(degrees * kDegree) / kDegree;
    figure.row({degrees, slope, exact});
    report.add(
        {"10 The apple's cone",
         "slope [degrees], alpha = " + std::to_string(static_cast<int>(degrees)), exact, slope, 2,
         "2 degrees: the closed form is that of creases folded shut, the creases rest at 176 "
         "degrees, and the ridge between them is no cone"});
  }
}

}  // namespace shell_origami
