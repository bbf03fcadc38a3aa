#include "verify/elastica.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shell_origami {
namespace {

constexpr int kSteps = 1000;

/// A place of a strip, by the distance u from its tip: its angle theta below the horizontal, the
/// derivative of theta by u, and x and y.
using Place = Eigen::Vector4d;

/// What is constant along a part of a strip: its weight per length, and the force on it of the part
/// beyond, but for the weight.
struct Load {
  double gamma;
  Vector2 force = Vector2::Zero();
};

/// The derivative of a place by u.
Place change(const Load& load, double u, const Place& at) {
  const double sine = std::sin(at[0]), cosine = std::cos(at[0]);
  return {at[1], load.force.x() * sine + (load.force.y() - load.gamma * u) * cosine, -cosine, sine};
}

/// The places from u on over a length, at even distances.
std::vector<Place> followed(const Load& load, double u, double length, const Place& from) {
  const double h = length / kSteps;
  std::vector<Place> places{from};
  for (int i = 0; i < kSteps; ++i, u += h) {
    const Place& at = places.back();
    const Place k1 = change(load, u, at), k2 = change(load, u + h / 2, at + h / 2 * k1);
    const Place k3 = change(load, u + h / 2, at + h / 2 * k2),
                k4 = change(load, u + h, at + h * k3);
    places.push_back(at + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
  }
  return places;
}

/// The points from the last place, the origin, to the first.
std::vector<Vector2> pointsFromEnd(const std::vector<Place>& places) {
  std::vector<Vector2> points;
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    points.emplace_back((*place - places.back()).tail<2>());
  }
  return points;
}

/// A strip over an edge, whatever its ends.
struct OverEdge {
  std::vector<Place> hanging, lifted;
  double over, lift;

  /// \param unknowns theta at the tip, the force at the edge over gamma, the arc lengths beyond and
  /// behind it
  OverEdge(double gamma, const Eigen::Vector4d& unknowns) : over(unknowns[2]), lift(unknowns[3]) {
    hanging = followed({gamma}, 0, over, {unknowns[0], 0, 0, 0});
    const double slope = hanging.back()[0];
    const Vector2 force = gamma * unknowns[1] * Vector2(std::sin(slope), std::cos(slope));
    lifted = followed({gamma, force}, over, lift, hanging.back());
  }

  /// Zero where it lies flat from the end of the lifted part on, and is as long as it was.
  Eigen::Vector4d errors() const {
    const Place behind = lifted.back() - hanging.back();
    return {lifted.back()[0], lifted.back()[1], behind[3], over + lift + behind[2] - 1};
  }
};

/// The unknowns of OverEdge, by Newton's method from others.
Eigen::Vector4d solveOverEdge(double gamma, Eigen::Vector4d unknowns) {
  constexpr int kMost = 50;
  constexpr double kClose = 1e-10, kDifference = 1e-6;
  for (int i = 0; i < kMost; ++i) {
    const Eigen::Vector4d errors = OverEdge(gamma, unknowns).errors();
    if (errors.cwiseAbs().maxCoeff() < kClose) return unknowns;
    Eigen::Matrix4d by;
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector4d to = kDifference * Eigen::Vector4d::Unit(k);
      by.col(k) = (OverEdge(gamma, unknowns + to).errors() - errors) / kDifference;
    }
    unknowns -= by.partialPivLu().solve(errors);
  }
  throw std::runtime_error("the elastica over an edge is not found");
}

}  // namespace

std::vector<Vector2> heavyElastica(double gamma) {
  const auto fromTip = [gamma](double theta) { return followed({gamma}, 0, 1, {theta, 0, 0, 0}); };
  double low = 0, high = M_PI / 2;
  for (int i = 0; i < 60; ++i) {
    const double tip = (low + high) / 2;
    (fromTip(tip).back()[0] > 0 ? high : low) = tip;
  }
  return pointsFromEnd(fromTip(low));
}

EdgeElastica elasticaOverEdge(double gamma) {
  // From the solution for small gamma on, in steps that Newton's method follows.
  constexpr double kSmall = 0.25, kStep = 1.2;
  const double lift = std::sqrt(2);
  double reached = std::min(gamma, kSmall);
  Eigen::Vector4d unknowns(reached * (1. / 6 + lift / 12), 1 + 0.75 * lift, 1, lift);
  unknowns = solveOverEdge(reached, unknowns);
  while (reached < gamma) {
    reached = std::min(gamma, kStep * reached);
    unknowns = solveOverEdge(reached, unknowns);
  }
  const OverEdge strip(gamma, unknowns);
  const Place& edge = strip.hanging.back();
  double highest = edge[3];
  for (const Place& place : strip.lifted) highest = std::max(highest, place[3]);
  return {pointsFromEnd(strip.hanging), strip.lift, edge[0], highest - edge[3]};
}

}  // namespace shell_origami
