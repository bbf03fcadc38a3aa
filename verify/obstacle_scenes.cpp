#include "verify/obstacle_scenes.h"

#include "verify/hanging.h"

#include <shell_origami/mesh/triangulate.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shell_origami {
namespace {

constexpr double kGravity = 9.81;       // [m/s^2]
constexpr double kSide = 0.15;          // [m]
constexpr double kHangingLength = 0.1;  // [m]
/// By how much one of two boxes is pressed onto paper that lies on the other, over d^.
constexpr double kSqueeze = 0.5;
constexpr double kSame = 1e-9;                // [m], between vertices of a row along x
constexpr double kTall = 0.8660254037844386;  // height of an equilateral triangle over its edge

/// Without air, solved to 1e-8 m/s.
SimulationConfig exact() {
  SimulationConfig config;
  config.material.air_damping = 0;
  config.solver.tolerance = 1e-8;
  return config;
}

/// A flat square at a pose, in gravity.
Simulation squareAt(const Pose& pose, double max_edge) {
  SimulationConfig config = exact();
  config.gravity.z() = -kGravity;
  const Sheet sheet(triangulateRectangle(kSide, kSide, max_edge));
  Positions x = flatInSpace(sheet);
  for (Eigen::Index v = 0; v < x.cols(); ++v) x.col(v) = pose.toWorld(x.col(v));
  return Simulation(sheet, config, x, {});
}

/// A box from one x to another one, across all of a sheet and beyond it, above or below z = 0.
AddObstacleEdit slab(const std::string& id, double from, double to, double breadth, double side,
                     double friction) {
  const double height = 0.02;
  return obstacle(id, Box{{to - from, 2 * breadth, height}},
                  {{(from + to) / 2, breadth / 2, side * height / 2}}, friction);
}

/// Presses a slab down onto paper that lies on another one.
void press(Simulation& simulation, const std::string& id) {
  Pose pose = simulation.obstacles().all().at(id).base;
  pose.position.z() -= kSqueeze * simulation.config().contact.distance;
  simulation.apply(MoveObstacleEdit{id, pose, 0});
}

/// A sheet in rows of triangles across x, of which the last `rows` and a half are the length L that
/// hangs, or would if the strip lay flat. Wider than long, it hardly curls (ClampedSheet).
struct Strip {
  Sheet sheet;
  double row;      ///< height of the rows [m]
  double breadth;  ///< [m]
  int hanging;     ///< index of the first row of vertices that hangs
  int tip;         ///< of the last one

  /// \param behind about how many rows of triangles, and half a row, do not hang
  Strip(int rows, int behind)
      : sheet(wide(kHangingLength * (rows + behind + 1) / rows, kHangingLength / rows)) {
    row = sheet.size();
    breadth = 0;
    double whole = 0;
    for (const Vector2& p : sheet.flatPositions()) {
      if (p.x() > kSame) row = std::min(row, p.x());
      whole = std::max(whole, p.x());
      breadth = std::max(breadth, p.y());
    }
    tip = static_cast<int>(std::lround(whole / row));
    hanging = tip - rows;
  }

  static Sheet wide(double length, double row) {
    return Sheet(triangulateRectangle(length, 1.1 * length, 1.001 * row / kTall));
  }

  double edge() const { return (hanging - 0.5) * row; }          ///< x where it begins to hang
  double length() const { return (tip - hanging + 0.5) * row; }  ///< L

  /// Mean place of the vertices in the rows from one to another.
  Vector3 mean(const Positions& x, int first, int last) const {
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      const double at = sheet.flatPositions()[v].x();
      if (at < first * row - kSame || at > last * row + kSame) continue;
      sum += x.col(v);
      ++count;
    }
    return sum / count;
  }

  /// Where it hangs, with its vertices up to `last_flat` lying flat.
  HangingStrip measured(const Positions& x, int last_flat) const {
    const double flat = mean(x, 0, last_flat).z();
    const Vector3 end = mean(x, tip, tip);
    double highest = flat;
    for (int i = last_flat; i < hanging; ++i) highest = std::max(highest, mean(x, i, i).z());
    return {row / length(), (flat - end.z()) / length(), (end.x() - edge()) / length(),
            (highest - flat) / length()};
  }
};

}  // namespace

AddObstacleEdit obstacle(const std::string& id, const ObstacleShape& shape, const Pose& pose,
                         double friction) {
  return {id, shape, pose, friction, "", {}};
}

void advance(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    const StepReport report = simulation.step();
    if (!report.converged) throw std::runtime_error("among obstacles: " + report.failure);
    const std::string cut = simulation.cutObstacle();
    if (!cut.empty()) throw std::runtime_error("paper cuts obstacle '" + cut + "'");
    if (!simulation.crossings().empty()) throw std::runtime_error("paper crosses itself");
  }
}

Simulation droppedSheet(double max_edge) {
  Simulation simulation = squareAt({{0, 0, 0.02}}, max_edge);
  simulation.apply(obstacle("table", HalfSpace{}));
  advance(simulation, 60);
  return simulation;
}

Slide slideDown(double slope, double friction, double max_edge) {
  const Pose pose{Vector3::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(slope, Vector3::UnitY()))};
  Simulation simulation = squareAt(pose, max_edge);
  simulation.apply(obstacle("slope", HalfSpace{}, pose, friction));
  const Vector3 down = pose.orientation * Vector3::UnitX();
  const auto speed = [&] { return down.dot(simulation.velocities().rowwise().mean()); };
  // Before it meets the slope, in the first step, there is no friction.
  advance(simulation, 30);
  const double before = speed(), time = simulation.time();
  advance(simulation, 60);
  return {speed(), (speed() - before) / (simulation.time() - time)};
}

Pull pullOutOfJaws(double friction, double max_edge) {
  const double length = 0.15, breadth = 0.05, jaw = 0.035, speed = 2e-3;
  Simulation simulation(Sheet(triangulateRectangle(length, breadth, max_edge)), exact());
  simulation.apply(slab("lower", -0.02, jaw, breadth, -1, friction));
  simulation.apply(slab("upper", -0.02, jaw, breadth, 1, friction));
  press(simulation, "upper");
  const double end = length - 1e-3;
  simulation.pin(Region{{{end, 0}, {length, 0}, {length, breadth}, {end, breadth}}}, "hand", {});
  double pressed = 0;
  for (int i = 0; i < 60; ++i) {
    const auto jaws = simulation.obstacleWrenches();
    pressed = jaws.at("upper").force.z() - jaws.at("lower").force.z();
    simulation.carry("hand", {{speed * simulation.time(), 0, 0}});
    advance(simulation, 1);
  }
  return {simulation.holdingWrenches().at("hand").force.x(), pressed};
}

HangingStrip hangFromJaws(double gamma, int rows) {
  const Strip strip(rows, 3);
  Simulation simulation(strip.sheet, hangingConfig(gamma, strip.length(), strip.length()));
  simulation.apply(slab("lower", -kHangingLength, strip.edge(), strip.breadth, -1, 0.4));
  simulation.apply(slab("upper", -kHangingLength, strip.edge(), strip.breadth, 1, 0.4));
  press(simulation, "upper");
  comeToRest(simulation);
  return strip.measured(simulation.positions(), strip.hanging - 1);
}

HangingStrip hangOverEdge(double gamma, int rows) {
  constexpr int kHeld = 3;  // rows of triangles
  const Strip strip(rows, kHeld + 3 * rows / 2);
  Simulation simulation(strip.sheet, hangingConfig(gamma, strip.length(), 2 * strip.length()));
  simulation.apply(slab("table", -kHangingLength, strip.edge(), strip.breadth, -1, 0));
  simulation.apply(
      slab("weight", -kHangingLength, (kHeld + 0.5) * strip.row, strip.breadth, 1, 0.4));
  press(simulation, "weight");
  comeToRest(simulation);
  return strip.measured(simulation.positions(), kHeld);
}

}  // namespace shell_origami
