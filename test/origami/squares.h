/// \file
/// A square sheet, its weight and its diagonal, for tests of Simulation.
#pragma once

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace shell_origami {

constexpr double kSide = 0.15;
constexpr double kDegree = M_PI / 180;
constexpr double kGravity = 9.81;  // [m/s^2]

inline SimulationConfig heavy() {
  SimulationConfig config;
  config.gravity = {0, 0, -kGravity};
  return config;
}

inline Simulation square(const SimulationConfig& config = {}, double max_edge = 0.02) {
  return Simulation(Sheet(triangulateRectangle(kSide, kSide, max_edge)), config);
}

inline double weightOf(const Simulation& simulation) {
  return kGravity * simulation.shell().shell().masses().sum();
}

/// Returns the message with which an edit is rejected; empty: it is made.
inline std::string rejection(Simulation& simulation, const Edit& edit) {
  try {
    simulation.apply(edit);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

inline FoldEdit diagonal(double angle, double duration = 0.5) {
  FoldEdit request;
  request.where = Segment{Vector2(0, 0), Vector2(kSide, kSide)};
  request.angle = angle;
  request.duration = duration;
  return request;
}

inline void settle(Simulation& simulation, double timeout = 10) {
  const double end = simulation.time() + timeout;
  do {
    const StepReport report = simulation.step();
    ASSERT_TRUE(report.converged) << report.failure;
  } while (simulation.time() < end && !simulation.settled());
}

}  // namespace shell_origami
