#include "verify/elastica.h"

#include <cmath>

namespace shell_origami {
namespace {

constexpr int kSteps = 1000;

/// Slope and curvature at distance u from the tip: theta'' = -gamma u cos(theta).
struct Bending {
  double theta, curvature;
};

Bending slope(double gamma, double u, const Bending& at) {
  return {at.curvature, -gamma * u * std::cos(at.theta)};
}

Bending moved(const Bending& at, double h, const Bending& by) {
  return {at.theta + h * by.theta, at.curvature + h * by.curvature};
}

/// Slopes from the tip to the clamp of a cantilever whose tip hangs at this slope.
std::vector<double> slopesFromTip(double gamma, double tip) {
  constexpr double h = 1.0 / kSteps;
  Bending at{tip, 0};
  std::vector<double> slopes{tip};
  for (int i = 0; i < kSteps; ++i) {
    const double u = i * h;
    const Bending k1 = slope(gamma, u, at), k2 = slope(gamma, u + h / 2, moved(at, h / 2, k1));
    const Bending k3 = slope(gamma, u + h / 2, moved(at, h / 2, k2));
    const Bending k4 = slope(gamma, u + h, moved(at, h, k3));
    at = moved(moved(at, h / 6, k1), h / 3, k2);
    at = moved(moved(at, h / 3, k3), h / 6, k4);
    slopes.push_back(at.theta);
  }
  return slopes;
}

}  // namespace

std::vector<Vector2> heavyElastica(double gamma) {
  double low = 0, high = M_PI / 2;
  for (int i = 0; i < 60; ++i) {
    const double tip = (low + high) / 2;
    (slopesFromTip(gamma, tip).back() > 0 ? high : low) = tip;
  }
  const std::vector<double> slopes = slopesFromTip(gamma, low);
  // Simpson's rule over pairs of steps.
  std::vector<Vector2> points{Vector2::Zero()};
  const auto direction = [&slopes](int i) {
    const double theta = slopes[kSteps - i];
    return Vector2(std::cos(theta), -std::sin(theta));
  };
  for (int i = 0; i + 2 <= kSteps; i += 2) {
    points.push_back(points.back() +
                     (direction(i) + 4 * direction(i + 1) + direction(i + 2)) / (3 * kSteps));
  }
  return points;
}

}  // namespace shell_origami
