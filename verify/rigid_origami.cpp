#include "verify/rigid_origami.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>

namespace shell_origami {

double Degree4Vertex::ratio() const {
  return twisted ? std::sin((a + b) / 2) / std::sin((a - b) / 2)
                 : -std::cos((a + b) / 2) / std::cos((a - b) / 2);
}

std::array<double, 4> Degree4Vertex::angles(double rho0) const {
  const double rho1 = 2 * std::atan(ratio() * std::tan(rho0 / 2));
  return {rho0, rho1, twisted ? -rho0 : rho0, twisted ? rho1 : -rho1};
}

Sheet Degree4Vertex::sheet() const {
  const auto signs = angles(1);
  return vertexSheet({0, a, a + b, M_PI + b}, {signs.begin(), signs.end()}, 0.03, 0.012);
}

double Degree4Vertex::error(const std::vector<CreaseStatus>& creases) const {
  const auto exact = angles(creases[0].angle);
  double error = 0;
  for (int k = 1; k < 4; ++k) error = std::max(error, std::abs(creases[k].angle - exact[k]));
  return error;
}

std::vector<Degree4Vertex> randomDegree4Vertices(int count) {
  std::mt19937 random(4);  // its numbers are the same everywhere, a distribution's are not
  const auto sector = [&random] { return (35 + 110 * (random() / 4294967296.0)) * kDegree; };
  std::vector<Degree4Vertex> vertices;
  while (static_cast<int>(vertices.size()) < count) {
    const double a = sector(), b = sector();
    if (std::abs(a - b) < 20 * kDegree || std::abs(a + b - M_PI) < 20 * kDegree) continue;
    vertices.push_back({a, b, vertices.size() % 2 == 1});
  }
  return vertices;
}

double Miura::otherAngle() const { return 2 * std::atan(std::cos(q) * std::tan(g)); }
double Miura::height() const { return a * std::sin(q) * std::sin(g); }
double Miura::length() const { return a * std::sqrt(1 - std::pow(std::sin(g) * std::sin(q), 2)); }
double Miura::width() const {
  const double across = std::cos(g) * std::tan(q);
  return b * across / std::sqrt(1 + across * across);
}
double Miura::poissonRatio() const { return -std::pow(std::cos(g) * std::tan(q), 2); }

double waterbombMountain(double valley) {
  return -2 * std::atan(std::tan(valley / 2) / std::sqrt(2.0));
}

double coneSlope(double alpha) { return std::acos(1 - alpha / M_PI); }

Simulation foldedCone(double alpha, double radius) {
  Simulation simulation(
      vertexSheet({M_PI / 2 - alpha / 2, M_PI / 2 + alpha / 2}, {1, -1}, radius, radius / 10),
      SimulationConfig());
  FoldEdit valley = foldCrease("rho0", 176 * kDegree, 2);
  FoldEdit mountain = foldCrease("rho1", -176 * kDegree, 2);
  valley.stiffness = mountain.stiffness = 0.5;
  simulation.fold(valley);
  simulation.fold(mountain);
  stepUntil(simulation, 5);
  return simulation;
}

double measuredConeSlope(const Simulation& simulation, double alpha, double radius) {
  std::vector<Vector3> rulings;
  const Vector3 apex = simulation.positions().col(0);
  for (int v = 1; v < simulation.sheet().vertexCount(); ++v) {
    const Vector2& flat = simulation.sheet().flatPositions()[v];
    const double off = std::abs(std::atan2(flat.y(), flat.x()) - M_PI / 2);
    if (flat.norm() < 0.99 * radius || off < 1.5 * alpha) continue;
    rulings.push_back((Vector3(simulation.positions().col(v)) - apex).normalized());
  }
  // n . axis = sin(slope) for every ruling n: least squares for axis / sin(slope).
  Eigen::MatrixXd rows(rulings.size(), 3);
  for (std::size_t i = 0; i < rulings.size(); ++i) rows.row(i) = rulings[i];
  const Vector3 scaled = rows.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(rows.rows()));
  return std::asin(1 / scaled.norm());
}

}  // namespace shell_origami
