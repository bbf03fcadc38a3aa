/// Items 3 and 4: the free vibration of a clamped sheet, its frequency and its energy.
#include "verify/clamped_sheet.h"
#include "verify/free_motion.h"
#include "verify/topics.h"

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

constexpr double kLength = 0.1;  // [m]
constexpr double kAspect = 3;
constexpr double kAmplitude = 0.01;  // of the tip over the length
constexpr int kStepsPerPeriod = 100;
const std::string kFrequency = "4 First frequency of a cantilever";
const std::string kEnergy = "3 Energy of a free vibration";

/// Deflection of the first mode at the part s of the length, 1 at the tip (Euler-Bernoulli).
double firstMode(double s) {
  constexpr double k = 1.8751040687119611, ratio = 0.7340955137582304;
  const double u = k * s;
  return (std::cosh(u) - std::cos(u) - ratio * (std::sinh(u) - std::sin(u))) / 2;
}

struct Swing {
  std::vector<double> time, tip, energy;  ///< [s], [m], [J], after each step

  /// Returns the frequency from the first to the last zero crossing of the tip [1/s].
  double frequency() const {
    std::vector<double> crossings;
    for (std::size_t i = 1; i < tip.size(); ++i) {
      if ((tip[i - 1] < 0) == (tip[i] < 0)) continue;
      const double part = tip[i - 1] / (tip[i - 1] - tip[i]);
      crossings.push_back(time[i - 1] + part * (time[i] - time[i - 1]));
    }
    return (static_cast<double>(crossings.size()) - 1) / 2 / (crossings.back() - crossings.front());
  }
};

double largestDrift(const std::vector<double>& energy) {
  double drift = 0;
  for (double e : energy) drift = std::max(drift, std::abs(e / energy[0] - 1));
  return drift;
}

/// Simulates a sheet that starts flat with the velocities of the first mode.
Swing swing(const ClampedSheet& sheet, int steps) {
  const Material material = strip();
  const double frequency = firstFrequency(material, sheet.length);
  const double speed = 2 * M_PI * frequency * kAmplitude * sheet.length;
  SolverConfig solver;
  solver.gamma = 0.5;
  solver.time_step = 1 / (kStepsPerPeriod * frequency);
  solver.tolerance = 1e-6 * speed;
  const Positions flat = flatInSpace(sheet.sheet);
  Positions velocities = Positions::Zero(3, flat.cols());
  for (Eigen::Index v = 0; v < flat.cols(); ++v) {
    velocities(2, v) = speed * firstMode((flat(0, v) - sheet.clamp) / sheet.length);
  }
  FreeMotion motion(sheet.sheet, material, solver, flat, velocities, sheet.held);
  Swing result;
  for (int i = 0; i <= steps; ++i) {
    if (i > 0) motion.step();
    double tip = 0;
    for (int v : sheet.tip) tip += motion.motion().positions(2, v) / sheet.tip.size();
    result.time.push_back(i * solver.time_step);
    result.tip.push_back(tip);
    result.energy.push_back(motion.kineticEnergy() + motion.elasticEnergy());
  }
  return result;
}

}  // namespace

void verifyVibration(VerificationReport& report) {
  const int steps = report.fast() ? 400 : 1000;
  const ClampedSheet sheet = clampedSheet(kLength, kAspect, report.fast() ? 8 : 20);
  const Swing result = swing(sheet, steps);
  const double exact = firstFrequency(strip(), sheet.length);
  const double drift = largestDrift(result.energy);
  FigureData figure = report.figure("vibration", {"periods", "tip", "energy"});
  for (int i = 0; i <= steps; ++i) {
    figure.row({exact * result.time[i], result.tip[i] / sheet.length,
                result.energy[i] / result.energy[0]});
  }
  const double row = 2 * sheet.clamp / sheet.length, phase = 2 * M_PI / kStepsPerPeriod;
  report.add(
      {kFrequency, "frequency over .55959 sqrt(B / (rho t L^4))", 1, result.frequency() / exact,
       0.011 / kAspect + row * row / 2 + phase * phase / 24,
       "the free sides, which curl, lower it by 1.1 % of the length over the breadth, 0.37 %; "
       "the mesh by up to (row / length)^2 / 2; the time step by (omega dt)^2 / 24"});
  report.add({kEnergy, "largest drift of the energy over " + std::to_string(steps) + " steps", 0,
              drift, 1e-5,
              "the trapezoidal rule conserves the energy of a linear system. Newton's method stops "
              "at 1e-6 of the velocities, 2e-6 of the energy in a step; such errors add up like "
              "those of five steps"});
}

}  // namespace shell_origami
