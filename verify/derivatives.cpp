#include "verify/derivatives.h"

#include <shell_origami/energy/shell.h>
#include <shell_origami/energy/shell_potential.h>
#include "verify/dual.h"
#include "verify/topics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

using Dual12 = Dual<12>;
using Dual9 = Dual<9>;

template <int N, std::size_t Count>
std::array<DualVector<N>, Count> variables(const std::array<Eigen::Vector3d, Count>& points) {
  std::array<DualVector<N>, Count> x;
  for (int i = 0; i < N; ++i) x[i / 3][i % 3] = Dual<N>::variable(points[i / 3][i % 3], i);
  return x;
}

/// The deviation from flat of the angle between the two triangles' heights; valley > 0.
Dual12 foldAngle(const std::array<DualVector<12>, 4>& x) {
  const DualVector<12> edge = x[1] - x[0];
  const Dual12 length2 = dot(edge, edge);
  const auto wing = [&](const DualVector<12>& apex) {
    const DualVector<12> arm = apex - x[0];
    return arm - scaled(edge, dot(arm, edge) / length2);
  };
  const DualVector<12> left = wing(x[2]), right = wing(x[3]);
  return atan2(dot(edge, crossProduct(left, right)) / sqrt(length2), -dot(left, right));
}

Dual12 phiOf(const Dual12& theta) { return Dual12(2) * tan(theta / Dual12(2)); }
double phiOf(double theta) { return 2 * std::tan(theta / 2); }

/// Distance of a crease from its rest angle (creaseBend() in dihedral.h).
Dual12 creaseDistance(const Dual12& theta, double rest) {
  const double side = rest < 0 ? -1 : 1;
  const Dual12 turned = Dual12(side) * theta;
  const double at_rest = side * rest;
  if (turned.value <= 0) return phiOf(turned) - Dual12(at_rest);
  if (turned.value <= at_rest) return turned - Dual12(at_rest);
  const double slope = 1 / std::pow(std::cos(at_rest / 2), 2);
  return (phiOf(turned) - Dual12(phiOf(at_rest))) / Dual12(slope);
}

template <int N, class Gradient, class Hessian>
DerivativeError compare(const Dual<N>& exact, double value, const Gradient& gradient,
                        const Hessian& hessian) {
  return {std::abs(value / exact.value - 1),
          (gradient - exact.gradient).norm() / exact.gradient.norm(),
          (hessian - exact.hessian).norm() / exact.hessian.norm()};
}

/// Paper as thick as the hinge is long: the membrane, which is not stretched, is then no stiffer
/// than the hinge, and its rounding errors do not show.
Material thick() {
  Material material;
  material.youngs_modulus = 1;
  material.thickness = 1;
  return material;
}

/// St. Venant-Kirchhoff's energy from the Gram matrix of the triangle's sides.
Dual9 stVenantKirchhoff(const std::array<Vector2, 3>& flat, const std::array<DualVector<9>, 3>& x,
                        const Material& material) {
  Eigen::Matrix2d sides;
  sides << flat[1] - flat[0], flat[2] - flat[0];
  const Eigen::Matrix2d inverse = sides.inverse();
  const DualVector<9> u = x[1] - x[0], v = x[2] - x[0];
  const std::array<Dual9, 4> gram{dot(u, u), dot(u, v), dot(u, v), dot(v, v)};
  std::array<Dual9, 4> strain;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      Dual9& entry = strain[2 * i + j];
      entry = Dual9(i == j ? -0.5 : 0);
      for (int k = 0; k < 4; ++k) {
        entry = entry + Dual9(inverse(k / 2, i) * inverse(k % 2, j) / 2) * gram[k];
      }
    }
  }
  const Dual9 trace = strain[0] + strain[3];
  Dual9 square;
  for (const Dual9& e : strain) square = square + e * e;
  const double area = sides.determinant() / 2;
  return Dual9(area * material.membraneLambda() / 2) * trace * trace +
         Dual9(area * material.membraneMu()) * square;
}

/// Discrete Shells' energy of edge lengths and area (edge_area_membrane.h).
Dual9 edgeArea(const std::array<Vector2, 3>& flat, const std::array<DualVector<9>, 3>& x,
               const Material& material) {
  const double area = doubleArea(flat[0], flat[1], flat[2]) / 2;
  const double lambda = material.membraneLambda(), mu = material.membraneMu();
  const DualVector<9> normal = crossProduct(x[1] - x[0], x[2] - x[0]);
  const Dual9 shrunk = Dual9(1) - sqrt(dot(normal, normal)) / Dual9(2 * area);
  Dual9 energy = Dual9(area * std::max(0.0, lambda - mu) / 2) * shrunk * shrunk;
  for (int k = 0; k < 3; ++k) {
    const DualVector<9> side = x[(k + 1) % 3] - x[k];
    const Dual9 short_by =
        Dual9(1) - sqrt(dot(side, side)) / Dual9((flat[(k + 1) % 3] - flat[k]).norm());
    energy = energy + Dual9(area * 4 * mu / 3) * short_by * short_by;
  }
  return energy;
}

template <class Element>
DerivativeError compareElement(const std::array<Vector2, 3>& flat, const Material& material,
                               const TrianglePoints& points, const Dual9& exact) {
  const Element element(flat, material);
  const MembraneStrain rest = MembraneStrain::Zero();
  return compare(exact, element.energy(points, rest), element.gradient(points, rest),
                 element.hessian(points, element.strain(points), false));
}

}  // namespace

double DerivativeError::largest() const { return std::max({value, gradient, hessian}); }

HingePoints HingeShape::bent(double theta) const {
  HingePoints x{Vector3(0, 0, 0), Vector3(length, 0, 0), Vector3(foot2, height2, 0),
                Vector3(foot3, -height3 * std::cos(theta), height3 * std::sin(theta))};
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.5, -0.1, 0.7, 0.4).normalized().toRotationMatrix();
  for (auto& p : x) p = turn * p + Vector3(0.3, -0.2, 0.1);
  return x;
}

const std::vector<HingeShape>& hingeShapes() {
  static const std::vector<HingeShape> shapes{{1, 0.5, 0.87, 0.5, 0.87},
                                              {1, -0.3, 0.8, 1.6, 0.6},
                                              {1, 0.5, 0.01, 0.5, 0.8},
                                              {1, 0.01, 0.02, 0.99, 0.01}};
  return shapes;
}

std::vector<double> hingeAngles() {
  std::vector<double> angles;
  for (const double degrees : {1, 10, 30, 45, 60, 89, 90, 91, 120, 150, 170, 178, 179}) {
    angles.insert(angles.end(), {degrees * M_PI / 180, -degrees * M_PI / 180});
  }
  return angles;
}

DerivativeError foldAngleError(const HingePoints& points) {
  return compare(foldAngle(variables<12>(points)), shell_origami::foldAngle(points).radians,
                 foldAngleGradient(points), foldAngleHessian(points));
}

DerivativeError hingeEnergyError(const HingeShape& shape, double theta, double rest, bool crease) {
  const std::vector<Vector2> flat{
      {0, 0}, {shape.length, 0}, {shape.foot2, shape.height2}, {shape.foot3, -shape.height3}};
  std::vector<Crease> creases;
  if (crease) creases.push_back({0, "crease", {0, 1}});
  const Material material = thick();
  ShellPotential potential(Sheet(Triangulation(flat, {{0, 1, 2}, {1, 0, 3}}), creases), material,
                           Vector3::Zero());
  const Shell& shell = potential.shell();
  const double c = material.crease_stiffness;
  if (crease) shell.setCrease(0, rest, c, potential.rest);
  else Shell::setRestAngle(0, rest, potential.rest);

  const HingePoints points = shape.bent(theta);
  Positions x(3, 4);
  for (int k = 0; k < 4; ++k) x.col(k) = points[k];
  const std::array<int, 4>& at = shell.hinges()[0].vertices;
  const Dual12 angle = foldAngle(
      variables<12>(HingePoints{points[at[0]], points[at[1]], points[at[2]], points[at[3]]}));
  const Dual12 u = crease ? creaseDistance(angle, rest) : phiOf(angle) - Dual12(phiOf(rest));
  const double h = (shape.height2 + shape.height3) / 6;
  const double factor =
      crease ? c / 2 * shape.length : material.bendingStiffness() / 6 * shape.length / h;

  Positions force = Positions::Zero(3, 4);
  potential.addGradient(x, force);
  HingeGradient gradient;
  for (int k = 0; k < 4; ++k) gradient.segment<3>(3 * k) = force.col(at[k]);
  HingeHessian hessian;
  shell.forEachExactHessian(x, potential.rest, [&](int, const auto& block) {
    if constexpr (std::decay_t<decltype(block)>::RowsAtCompileTime == 12) hessian = block;
  });
  return compare(Dual12(factor) * u * u, potential.bendingEnergy(x), gradient, hessian);
}

DerivativeError membraneError(MembraneKind kind, double stretch) {
  const std::array<Vector2, 3> flat{Vector2(0.01, 0.02), Vector2(0.02, 0.021),
                                    Vector2(0.013, 0.03)};
  TrianglePoints points;
  for (int k = 0; k < 3; ++k) {
    points[k] = {stretch * flat[k].x() + 0.1 * flat[k].y(), flat[k].y() / stretch,
                 0.3 * flat[k].x()};
  }
  Material material;
  material.poisson_ratio = 0.4;  // both of Discrete Shells' terms
  const auto x = variables<9>(points);
  if (kind == MembraneKind::kStVenantKirchhoff) {
    return compareElement<MembraneElement>(flat, material, points,
                                           stVenantKirchhoff(flat, x, material));
  }
  return compareElement<EdgeAreaMembrane>(flat, material, points, edgeArea(flat, x, material));
}

void verifyDerivatives(VerificationReport& report) {
  const std::string item = "1 Derivatives";
  const std::string why_hinge =
      "rounding: 1.1e-16 times the aspect, 100, times theta / sin(theta), 180 for a hinge one "
      "degree from 180, twice for each of two derivatives";
  double angle = 0, hinge = 0, membrane = 0;
  for (const HingeShape& shape : hingeShapes()) {
    for (const double theta : hingeAngles()) {
      angle = std::max(angle, foldAngleError(shape.bent(theta)).largest());
      for (const double rest : {0.0, 0.7, -2.5}) {
        for (const bool crease : {false, true}) {
          hinge = std::max(hinge, hingeEnergyError(shape, theta, rest, crease).largest());
        }
      }
    }
  }
  for (const double stretch : {0.6, 0.9, 0.999, 1.05, 1.4}) {
    for (const MembraneKind kind :
         {MembraneKind::kStVenantKirchhoff, MembraneKind::kDiscreteShells}) {
      membrane = std::max(membrane, membraneError(kind, stretch).largest());
    }
  }
  const std::string what = ", largest relative difference";
  report.add({item, "fold angle, its gradient and Hessian" + what, 0, angle, kFoldAngleRounding,
              "rounding: 1.1e-16 times 40 operations, times the aspect, 100"});
  report.add({item, "energies of hinges and creases, gradients and Hessians" + what, 0, hinge,
              kHingeRounding, why_hinge});
  report.add({item, "membrane energies, gradients and Hessians" + what, 0, membrane,
              kMembraneRounding, "rounding: 1.1e-16 times 200 operations"});
}

}  // namespace shell_origami
