#include "verify/pressed_bend.h"

#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

constexpr double kLength = 0.07, kWidth = 0.008;  // of the strip [m]
constexpr double kBend = 0.045;                   // where it is bent over, along it [m]
constexpr double kLoop = 0.03;                    // length of paper that is bent, at first [m]
constexpr double kHeld = 0.004;                   // at its end [m]
constexpr double kOpen = 0.02;                    // gap before the plates close [m]
constexpr char kFingers[] = "fingers", kPlate[] = "plate";

/// Where the fingers hold the end of a strip that is bent by phi, evenly over its loop.
Pose fingersAt(double phi) {
  const double radius = kLoop / phi, flat = kLength - kBend - kLoop / 2;
  const Vector3 place(kBend - kLoop / 2 + radius * std::sin(phi) + flat * std::cos(phi), 0,
                      radius * (1 - std::cos(phi)) + flat * std::sin(phi));
  return {place, Eigen::Quaterniond(Eigen::AngleAxisd(-phi, Vector3::UnitY()))};
}

/// A box whose lower side is at some height [m], over all of the bend.
constexpr double kThickness = 0.004;
Box plate() { return {Vector3(0.034, 2 * kWidth, kThickness)}; }
Pose plateAt(double height) {
  return {Vector3(kBend, kWidth / 2, height + kThickness / 2), Eigen::Quaterniond::Identity()};
}

double smooth(double s) { return s * s * (3 - 2 * s); }

/// Half of the pressed elastica, from its apex on: psi, and u = s / H with
/// du = d psi / (I sqrt(sin psi)). By w = sqrt(psi), which takes away the root's pole at 0.
struct HalfBend {
  static constexpr int kSteps = 20000;

  HalfBend() {
    const double top = std::sqrt(M_PI / 2), dw = top / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double w = (i + 0.5) * dw;
      integral += 2 * std::sqrt(std::sin(w * w)) * 2 * w * dw;
    }
    // From the apex outwards until g + u g' = 0, where g = sqrt(sin psi), g' = -I cos(psi) / 2.
    for (int i = kSteps; i > 0; --i) {
      const double w = (i - 0.5) * dw;
      u += 2 * w / std::sqrt(std::sin(w * w)) * dw / integral;
      psi = std::pow((i - 1) * dw, 2);
      if (std::sqrt(std::sin(psi)) <= u * integral * std::cos(psi) / 2) break;
    }
  }

  double integral = 0;       ///< I
  double u = 0, psi = M_PI;  ///< u* and psi*
};

class Strip {
 public:
  Strip(const Material& material, double max_edge)
      : simulation_(Sheet(triangulateRectangle(kLength, kWidth, max_edge)), configOf(material)) {
    simulation_.apply(AddObstacleEdit{"table", HalfSpace{}, {}, {}, "", {}});
    simulation_.pin(verticesBetween(0, kHeld));
    simulation_.pin(end(), kFingers, fingersAt(kFlat));
  }

  void bendOver(double gap) {
    move(kFingers, 1.5, [](double s) { return fingersAt(std::max(kFlat, M_PI * smooth(s))); });
    const Pose over = fingersAt(M_PI);
    move(kFingers, 0.5, [&](double s) {
      Pose pose = over;
      pose.position.z() += (gap - over.position.z()) * smooth(s);
      return pose;
    });
  }

  void press(double gap) {
    simulation_.apply(AddObstacleEdit{kPlate, plate(), {}, {}, kPlate, plateAt(kOpen)});
    move(kPlate, 2, [&](double s) { return plateAt(kOpen * std::pow(gap / kOpen, s)); });
    move(kPlate, 0.5, [&](double s) { return plateAt(gap + (kOpen - gap) * s); });
    simulation_.apply(RemoveObstacleEdit{{kPlate}});
  }

  void letGo() {
    simulation_.unpin(PinWhere(end()));
    for (int steps_left = 1200; !simulation_.settled(); --steps_left) {
      if (steps_left == 0) throw std::runtime_error("the pressed strip does not settle");
      step();
    }
  }

  /// The angle between the flaps on either side of the bend.
  double angle() const {
    return std::fmod(slope(kBend + kAside) - slope(kBend - kAside) + 2 * M_PI, 2 * M_PI);
  }

 private:
  static constexpr double kFlat = 1e-9;    // [rad]
  static constexpr double kAside = 0.018;  // [m]

  static SimulationConfig configOf(const Material& material) {
    SimulationConfig config;
    config.material = material;
    return config;
  }

  std::vector<std::int64_t> verticesBetween(double low, double high) const {
    const auto& flat = simulation_.sheet().flatPositions();
    std::vector<std::int64_t> result;
    for (std::size_t v = 0; v < flat.size(); ++v) {
      if (flat[v].x() >= low && flat[v].x() <= high) result.push_back(static_cast<int>(v));
    }
    return result;
  }
  std::vector<std::int64_t> end() const { return verticesBetween(kLength - kHeld, kLength); }

  /// Of the strip within 2 mm of a place along it, from the table.
  double slope(double along) const {
    const std::vector<std::int64_t> near = verticesBetween(along - 0.002, along + 0.002);
    const auto& flat = simulation_.sheet().flatPositions();
    const double count = static_cast<double>(near.size());
    double middle = 0;
    for (const auto v : near) middle += flat[v].x() / count;
    Vector3 direction = Vector3::Zero();  // of the line of least squares
    for (const auto v : near) direction += (flat[v].x() - middle) * simulation_.positions().col(v);
    return std::atan2(direction.z(), direction.x());
  }

  void move(const std::string& frame, double duration, const std::function<Pose(double)>& path) {
    const int steps =
        static_cast<int>(std::lround(duration / simulation_.config().solver.time_step));
    for (int i = 1; i <= steps; ++i) {
      simulation_.carry(frame, path(static_cast<double>(i) / steps));
      step();
    }
  }

  void step() {
    const StepReport report = simulation_.step();
    if (!report.converged) throw std::runtime_error("the pressed strip: " + report.failure);
  }

  Simulation simulation_;
};

}  // namespace

double keptOfPressedBend(double gap, const Material& material) {
  static const HalfBend bend;
  const double turn = M_PI / 2 - bend.psi;
  const double most = bend.integral * bend.u * std::sqrt(std::sin(bend.psi));  // C
  const double far = std::log(most / (bend.u * material.yield_curvature * gap));
  return 2 / (1 + material.hardening) * (turn - most + most * far);
}

double simulatedPressedBend(double gap, const Material& material, double max_edge) {
  Strip strip(material, max_edge);
  strip.bendOver(gap);
  strip.press(gap);
  strip.letGo();
  return strip.angle();
}

}  // namespace shell_origami
