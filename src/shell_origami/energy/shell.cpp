#include <shell_origami/energy/shell.h>

#include <shell_origami/base/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace shell_origami {
namespace {

/// Creases rest on this side of 180 degrees; what swings further is stopped by the energy, which
/// grows without bound, before it comes to the last angle.
constexpr double kLastAngle = 179.99 * M_PI / 180;
/// A step of the search takes at most this part of the way to the last angle.
constexpr double kPartOfRoom = 0.9;
/// No hinge may turn by more than this in one step of the search.
constexpr double kLargestTurn = 1;
/// A hinge this close to rest has a Gauss-Newton Hessian that is right to as many parts [rad].
constexpr double kNearRest = 1e-3;
/// A triangle squeezed below this part of its flat area has collapsed.
constexpr double kCollapsed = 0.05;

/// Triangles or hinges that one thread computes in one go.
constexpr std::size_t kElementsPerChunk = 256;

/// Vertices whose forces another thread is worth waking for.
constexpr std::size_t kSmallestPart = 1500;

/// Adds a gradient by some vertices to the columns of those that are in the part.
template <class Vertices, class Gradient>
void addTo(const Chunk& part, const Vertices& vertices, const Gradient& own, Positions& gradient) {
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (part.contains(vertices[k])) gradient.col(vertices[k]) += own.template segment<3>(3 * k);
  }
}

template <class Vertices>
bool reach(const Vertices& vertices, const Chunk& part) {
  return std::any_of(vertices.begin(), vertices.end(), [&](int v) { return part.contains(v); });
}

double heightOn(const Vector2& a, const Vector2& b, const Vector2& apex) {
  return std::abs(doubleArea(a, b, apex)) / (b - a).norm();
}

/// The rest angle [rad], held short of 180 degrees.
FoldAngle restAngle(double asked) {
  return std::clamp(asked, -kLargestRestAngle, kLargestRestAngle);
}

bool passedShut(const FoldAngle& theta, const FoldAngle& before) {
  return std::abs(theta.radians) > kLastAngle && std::abs(theta.radians) > std::abs(before.radians);
}

bool jumped(const FoldAngle& theta, const FoldAngle& before) {
  return std::abs(theta.radians - before.radians) > 2 * kLargestTurn;
}

}  // namespace

Shell::Shell(const Sheet& sheet, const Material& material)
    : triangles_(sheet.triangles()),
      crease_hinges_(sheet.creases().size()),
      masses_(Eigen::VectorXd::Zero(sheet.vertexCount())) {
  const auto& flat = sheet.flatPositions();
  if (material.membrane == MembraneKind::kDiscreteShells) {
    membranes_.emplace<std::vector<EdgeAreaMembrane>>();
  }
  for (const Triangle& t : triangles_) {
    const std::array<Vector2, 3> corners{flat[t[0]], flat[t[1]], flat[t[2]]};
    std::visit([&](auto& membranes) { membranes.emplace_back(corners, material); }, membranes_);
    const double area = doubleArea(flat[t[0]], flat[t[1]], flat[t[2]]) / 2;
    for (int v : t) masses_[v] += material.arealDensity() * area / 3;
  }
  for (std::size_t i = 0; i < sheet.edges().size(); ++i) {
    const Edge& edge = sheet.edges()[i];
    if (edge.onBorder()) continue;
    const auto [a, b] = edge.vertices;
    Hinge hinge;
    hinge.vertices = {a, b, edge.opposite[0], edge.opposite[1]};
    hinge.length = (flat[b] - flat[a]).norm();
    hinge.width = (heightOn(flat[a], flat[b], flat[edge.opposite[0]]) +
                   heightOn(flat[a], flat[b], flat[edge.opposite[1]])) /
                  3;
    hinge.edge = static_cast<int>(i);
    hinge.crease = edge.crease;
    double stiffness = 0;
    if (edge.crease >= 0) {
      crease_hinges_[edge.crease].push_back(static_cast<int>(hinges_.size()));
    } else {
      // W = k (phi - rest)^2 |e| / h_e with k = B / 6 and h_e a third of the mean height: the
      // plate's bending energy, in every direction on an equilateral mesh. h_e is half the width.
      stiffness = 2 * material.bendingStiffness() / 6 * hinge.length / (hinge.width / 2);
    }
    hinges_.push_back(hinge);
    stiffness_.push_back(stiffness);
  }
  stencils_.restart(1);
  for (const Triangle& t : triangles_) stencils_.add(t.data(), 3);
  for (const Hinge& hinge : hinges_) stencils_.add(hinge.vertices.data(), 4);
  if (!material.crease_height_term) return;
  for (const Hinge& hinge : hinges_) {
    crease_width_ += hinge.width / static_cast<double>(hinges_.size());
  }
}

void Shell::setRestAngle(int hinge, double rest_angle, RestState& rest) {
  rest.angles[hinge] = restAngle(rest_angle);
}

void Shell::setCrease(int crease, double rest_angle, double stiffness, RestState& rest) const {
  const FoldAngle angle = restAngle(rest_angle);
  for (int j : crease_hinges_[crease]) {
    rest.angles[j] = angle;
    const double part = crease_width_ > 0 ? crease_width_ / hinges_[j].width : 1;
    rest.stiffness[j] = stiffness * part * hinges_[j].length;
  }
}

void Shell::setRestStrain(int triangle, const GreenStrain& green, RestState& rest) const {
  std::visit(
      [&](const auto& membranes) { rest.strains[triangle] = membranes[triangle].strainOf(green); },
      membranes_);
}

TrianglePoints Shell::pointsOf(const Triangle& t, const Positions& x) const {
  return {x.col(t[0]), x.col(t[1]), x.col(t[2])};
}

HingePoints Shell::pointsOf(const Hinge& h, const Positions& x) const {
  return {x.col(h.vertices[0]), x.col(h.vertices[1]), x.col(h.vertices[2]), x.col(h.vertices[3])};
}

double Shell::membraneEnergy(const Positions& x, const RestState& rest) const {
  double energy = 0;
  std::visit(
      [&](const auto& membranes) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
          energy +=
              rest.membrane[i] * membranes[i].energy(pointsOf(triangles_[i], x), rest.strains[i]);
        }
      },
      membranes_);
  return energy;
}

double Shell::bendingEnergy(const Positions& x, const RestState& rest) const {
  double energy = 0;
  for (std::size_t j = 0; j < hinges_.size(); ++j) {
    const FoldAngle theta = shell_origami::foldAngle(pointsOf(hinges_[j], x));
    const double bend = hinges_[j].bend(theta, rest.angles[j]).value;
    energy += rest.stiffness[j] / 2 * bend * bend;
  }
  return energy;
}

double Shell::gravityEnergy(const Positions& x, const Vector3& gravity) const {
  return 0 - gravity.dot(x.leftCols(masses_.size()) * masses_);
}

double Shell::foldAngle(int hinge, const Positions& x) const {
  return shell_origami::foldAngle(pointsOf(hinges_[hinge], x)).radians;
}

double Shell::moment(int hinge, double theta, const RestState& rest) const {
  const Bend bend = hinges_[hinge].bend(theta, rest.angles[hinge]);
  return -rest.stiffness[hinge] / hinges_[hinge].length * bend.value * bend.first;
}

void Shell::foldAngles(const Positions& x, std::vector<FoldAngle>& angles) const {
  angles.resize(hinges_.size());
  forEachChunk(hinges_.size(), kElementsPerChunk, [&](const Chunk& chunk) {
    for (std::size_t j = chunk.begin; j < chunk.end; ++j) {
      angles[j] = shell_origami::foldAngle(pointsOf(hinges_[j], x));
    }
  });
}

bool Shell::addEnergy(const Positions& x, const RestState& rest,
                      const std::vector<FoldAngle>& before, std::vector<FoldAngle>& angles,
                      std::vector<double>& energies, double& energy) const {
  std::atomic<bool> feasible{true};
  energies.resize(triangles_.size() + hinges_.size());
  const auto sum = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) energy += energies[i];
  };
  std::visit(
      [&](const auto& membranes) {
        forEachChunk(triangles_.size(), kElementsPerChunk, [&](const Chunk& chunk) {
          for (std::size_t i = chunk.begin; i < chunk.end && feasible; ++i) {
            const TrianglePoints points = pointsOf(triangles_[i], x);
            if (!(membranes[i].areaRatio(points) > kCollapsed)) feasible = false;
            energies[i] = rest.membrane[i] * membranes[i].energy(points, rest.strains[i]);
          }
        });
      },
      membranes_);
  if (!feasible) return false;
  sum(0, triangles_.size());
  if (!std::isfinite(energy)) return false;
  angles.resize(hinges_.size());
  forEachChunk(hinges_.size(), kElementsPerChunk, [&](const Chunk& chunk) {
    for (std::size_t j = chunk.begin; j < chunk.end && feasible; ++j) {
      angles[j] = shell_origami::foldAngle(pointsOf(hinges_[j], x));
      if (passedShut(angles[j], before[j]) || jumped(angles[j], before[j])) feasible = false;
      const double bend = hinges_[j].bend(angles[j], rest.angles[j]).value;
      energies[triangles_.size() + j] = rest.stiffness[j] / 2 * bend * bend;
    }
  });
  if (!feasible) return false;
  sum(triangles_.size(), energies.size());
  return true;
}

std::optional<Infeasibility> Shell::findInfeasibility(const Positions& x,
                                                      const std::vector<FoldAngle>& before) const {
  for (int v = 0; v < vertexCount(); ++v) {
    if (!x.col(v).allFinite()) return Infeasibility{"a position is not finite", v};
  }
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const TrianglePoints points = pointsOf(triangles_[i], x);
    const bool collapsed = std::visit(
        [&](const auto& membranes) { return !(membranes[i].areaRatio(points) > kCollapsed); },
        membranes_);
    if (collapsed) return Infeasibility{"a triangle would collapse", triangles_[i][0]};
  }
  for (std::size_t j = 0; j < hinges_.size(); ++j) {
    const FoldAngle theta = shell_origami::foldAngle(pointsOf(hinges_[j], x));
    const int v = hinges_[j].vertices[0];
    if (passedShut(theta, before[j])) return Infeasibility{"a hinge would pass 180 degrees", v};
    if (jumped(theta, before[j])) return Infeasibility{"a hinge would jump", v};
  }
  return std::nullopt;
}

std::optional<Infeasibility> Shell::findJump(const std::vector<FoldAngle>& before,
                                             const std::vector<FoldAngle>& angles) const {
  for (std::size_t j = 0; j < hinges_.size(); ++j) {
    if (jumped(angles[j], before[j]))
      return Infeasibility{"a hinge would jump", hinges_[j].vertices[0]};
  }
  return std::nullopt;
}

void Shell::angleGradients(const Positions& x, std::vector<HingeGradient>& angle_gradients) const {
  angle_gradients.resize(hinges_.size());
  forEachChunk(hinges_.size(), kElementsPerChunk, [&](const Chunk& chunk) {
    for (std::size_t j = chunk.begin; j < chunk.end; ++j) {
      angle_gradients[j] = foldAngleGradient(pointsOf(hinges_[j], x));
    }
  });
}

void Shell::strains(const Positions& x, std::vector<MembraneStrain>& strains) const {
  strains.resize(triangles_.size());
  std::visit(
      [&](const auto& membranes) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
          strains[i] = membranes[i].strain(pointsOf(triangles_[i], x));
        }
      },
      membranes_);
}

void Shell::strainsAfter(const Positions& x, const Positions& along, const Positions& displacement,
                         std::vector<MembraneStrain>& strains) const {
  strains.resize(triangles_.size());
  std::visit(
      [&](const auto& membranes) {
        forEachChunk(triangles_.size(), kElementsPerChunk, [&](const Chunk& chunk) {
          for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
            strains[i] =
                membranes[i].strainAfter(pointsOf(triangles_[i], x), pointsOf(triangles_[i], along),
                                         pointsOf(triangles_[i], displacement));
          }
        });
      },
      membranes_);
}

void Shell::redirect(const Positions& x, const Positions& along, const RestState& rest,
                     const std::vector<MembraneStrain>& predicted, Positions& gradient) const {
  std::visit(
      [&](const auto& membranes) {
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
          const TrianglePoints here = pointsOf(triangles_[i], x),
                               there = pointsOf(triangles_[i], along);
          const MembraneStrain surprise = membranes[i].strain(here) - predicted[i];
          const auto force = [&](const TrianglePoints& points) {
            return membranes[i].gradient(points, membranes[i].strain(points) - surprise);
          };
          const MembraneGradient moved = rest.membrane[i] * (force(there) - force(here));
          for (int k = 0; k < 3; ++k) gradient.col(triangles_[i][k]) += moved.segment<3>(3 * k);
        }
      },
      membranes_);
}

void Shell::addGradient(const Positions& x, const RestState& rest,
                        const std::vector<FoldAngle>& angles,
                        const std::vector<HingeGradient>& angle_gradients,
                        Positions& gradient) const {
  forEachPart(vertexCount(), kSmallestPart, [&](const Chunk& part) {
    std::visit(
        [&](const auto& membranes) {
          for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (!reach(triangles_[i], part)) continue;
            const MembraneGradient own =
                rest.membrane[i] *
                membranes[i].gradient(pointsOf(triangles_[i], x), rest.strains[i]);
            addTo(part, triangles_[i], own, gradient);
          }
        },
        membranes_);
    for (std::size_t j = 0; j < hinges_.size(); ++j) {
      if (!reach(hinges_[j].vertices, part)) continue;
      const Bend bend = hinges_[j].bend(angles[j], rest.angles[j]);
      const double torque = rest.stiffness[j] * bend.value * bend.first;
      addTo(part, hinges_[j].vertices, torque * angle_gradients[j], gradient);
    }
  });
}

void Shell::addHessian(const Positions& x, const RestState& rest,
                       const std::vector<FoldAngle>& angles,
                       const std::vector<HingeGradient>& angle_gradients,
                       const std::vector<MembraneStrain>& strains, HessianKind kind,
                       HessianBlocks& blocks) const {
  blocks.inParts([&](HessianBlocks& part) {
    addMembraneHessian(x, rest, strains, kind, part);
    addHingeHessian(x, rest, angles, angle_gradients, kind, part);
  });
}

void Shell::addMembraneHessian(const Positions& x, const RestState& rest,
                               const std::vector<MembraneStrain>& strains, HessianKind kind,
                               HessianBlocks& blocks) const {
  std::visit(
      [&](const auto& membranes) {
        for (int i = 0; i < static_cast<int>(triangles_.size()); ++i) {
          if (!blocks.reach(i)) continue;
          const MembraneStrain strain = strains[i] - rest.strains[i];
          blocks.add(i, MembraneHessian(rest.membrane[i] *
                                        membranes[i].hessian(pointsOf(triangles_[i], x), strain,
                                                             kind == HessianKind::kConvex)));
        }
      },
      membranes_);
}

void Shell::addHingeHessian(const Positions& x, const RestState& rest,
                            const std::vector<FoldAngle>& angles,
                            const std::vector<HingeGradient>& angle_gradients, HessianKind kind,
                            HessianBlocks& blocks) const {
  int stencil = static_cast<int>(triangles_.size()) - 1;
  for (int j = 0; j < static_cast<int>(hinges_.size()); ++j) {
    if (!blocks.reach(++stencil)) continue;
    const bool near_rest = std::abs(angles[j].radians - rest.angles[j].radians) < kNearRest;
    if (kind == HessianKind::kConvex || near_rest) {
      blocks.addRankOne(stencil, gaussNewtonFactor(j, rest, angles[j]), angle_gradients[j]);
    } else {
      blocks.add(stencil,
                 exactHessian(j, rest, angles[j], angle_gradients[j], pointsOf(hinges_[j], x)));
    }
  }
}

/// Returns psi''; where it is small or negative, its convex part.
double Shell::gaussNewtonFactor(int hinge, const RestState& rest, const FoldAngle& theta) const {
  const Bend bend = hinges_[hinge].bend(theta, rest.angles[hinge]);
  const double convex = bend.first * bend.first;
  return rest.stiffness[hinge] * std::max(convex, convex + bend.value * bend.second);
}

HingeHessian Shell::exactHessian(int hinge, const RestState& rest, const FoldAngle& theta,
                                 const HingeGradient& angle_gradient,
                                 const HingePoints& points) const {
  const Bend bend = hinges_[hinge].bend(theta, rest.angles[hinge]);
  const double stiffness = rest.stiffness[hinge];
  const double first = stiffness * bend.value * bend.first;
  const double second = stiffness * (bend.first * bend.first + bend.value * bend.second);
  return first * foldAngleHessian(points) + second * angle_gradient * angle_gradient.transpose();
}

double Shell::maxFeasibleStep(const std::vector<FoldAngle>& angles,
                              const std::vector<HingeGradient>& angle_gradients,
                              const Positions& step) const {
  double fraction = 1;
  for (std::size_t j = 0; j < hinges_.size(); ++j) {
    double turn = 0;
    for (int k = 0; k < 4; ++k) {
      turn += angle_gradients[j].segment<3>(3 * k).dot(step.col(hinges_[j].vertices[k]));
    }
    if (std::abs(turn) * fraction > kLargestTurn) fraction = kLargestTurn / std::abs(turn);
    const double room = kPartOfRoom * (kLastAngle - std::copysign(1.0, turn) * angles[j].radians);
    if (room > 0 && std::abs(turn) * fraction > room) fraction = room / std::abs(turn);
  }
  return fraction;
}

}  // namespace shell_origami
