/// Item 10: the apple's bowl, a cone whose slope far from the apex is near acos(1 - alpha / pi).
#include "verify/rigid_origami.h"
#include "verify/topics.h"

#include <cmath>
#include <cstdio>

namespace shell_origami {
namespace {

constexpr double kRadius = 0.06;  // [m]

/// The pleat is folded to 176 degrees instead of 180. Its sides therefore stand alpha sin(4
/// degrees) apart, over the radius, across the cone, which changes the mean slope to second order:
/// by a small multiple of the square [rad].
double tolerance(double alpha) { return 4 * std::pow(alpha * std::sin(4 * kDegree), 2); }

}  // namespace

void verifyCone(VerificationReport& report) {
  FigureData figure = report.figure("cone", {"alpha", "slope", "exact"});
  for (double degrees = report.fast() ? 15 : 10; degrees <= (report.fast() ? 15 : 30);
       degrees += 5) {
    const double exact = coneSlope(degrees * kDegree) / kDegree;
    const double alpha = degrees * kDegree;
    const double slope = measuredConeSlope(foldedCone(alpha, kRadius), alpha, kRadius) / kDegree;
    figure.row({degrees, slope, exact});
    report.add(
        {"10 The apple's cone",
         "slope [degrees], alpha = " + std::to_string(static_cast<int>(degrees)), exact, slope,
         tolerance(alpha) / kDegree,
         "the closed form is for creases folded shut; these rest at 176 degrees, which leaves the "
         "sides of the pleat alpha sin(4 degrees) apart: 4 times the square of that"});
  }
}

}  // namespace shell_origami
