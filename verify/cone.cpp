/// Item 10: the apple's bowl, a cone of far-field slope near acos(1 - alpha / pi).
#include "verify/rigid_origami.h"
#include "verify/topics.h"

#include <cmath>
#include <cstdio>

namespace shell_origami {
namespace {

constexpr double kRadius = 0.06;  // [m]

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
         "slope [degrees], alpha = " + std::to_string(static_cast<int>(degrees)), exact, slope, 2,
         "2 degrees: the closed form is that of creases folded shut, the creases rest at 176 "
         "degrees, and the ridge between them is no cone"});
  }
}

}  // namespace shell_origami
