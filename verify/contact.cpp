/// Item 15: contact. Leaves rest, slide, collide and are pressed.
#include "verify/folding.h"
#include "verify/loose_leaves.h"
#include "verify/topics.h"

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

const std::string kItem = "15 Contact";
constexpr double kGravity = 9.81;  // [m/s^2]
constexpr double kSide = 0.06;     // [m]
/// Below this slip friction is less than its bound [m/s].
constexpr double kSlowest = 1e-4;
/// Of sums over some hundred vertices, relative to their terms.
constexpr double kRounding = 1e-14;
/// After so many moves of the press all leaves have met.
constexpr int kLoose = 8;

/// Paper without air around it, solved to 1e-8 m/s.
SimulationConfig paper(const Vector3& gravity = Vector3::Zero()) {
  SimulationConfig config;
  config.gravity = gravity;
  config.material.air_damping = 0;
  config.solver.tolerance = 1e-8;
  return config;
}

/// In the plane z = `height` with its center above (x, 0), turned about z, so that its edges are
/// parallel to none of a leaf that is not.
Eigen::Isometry3d lying(double height, double turn = 0, double x = 0) {
  return Eigen::Translation3d(x, 0, height) * Eigen::AngleAxisd(turn, Vector3::UnitZ());
}

Vector3 tilted(double slope) { return kGravity * Vector3(std::sin(slope), 0, -std::cos(slope)); }

void steps(LooseLeaves& leaves, int count) {
  for (int i = 0; i < count; ++i) leaves.step();
}

/// A leaf that rests on a larger one, which is held.
LooseLeaves resting(double max_edge) {
  LooseLeaves leaves({{3 * kSide, lying(0)}, {kSide, lying(6e-5, 0.3, -kSide / 2)}}, max_edge,
                     paper(tilted(0)));
  leaves.simulation().pin(leaves.vertices(0));
  steps(leaves, 120);
  return leaves;
}

void verifyWeight(VerificationReport& report, double max_edge) {
  const LooseLeaves leaves = resting(max_edge);
  const Simulation& simulation = leaves.simulation();
  const double weight = leaves.mass(1) * kGravity;
  report.add(
      {kItem, "force on a leaf that rests on another one, over its weight", 1,
       leaves.force(1, 0).z() / weight, 1e-8,
       "a step ends where speeds are known to 1e-8 m/s, weights therefore to 1e-8 / (g dt)"});
  const double reach = simulation.config().contact.distance;
  report.add({kItem, "smallest gap over the distance within which paper pushes", 0.5,
              smallestGap(simulation.contacts()) / reach, 0.5, "it lies between 0 and 1"});
}

/// The mean speed and acceleration of a leaf on a slope that is made steeper within half a second.
struct Slide {
  double speed, acceleration;  ///< [m/s], [m/s^2]
};

Slide slide(double slope, double max_edge) {
  LooseLeaves leaves = resting(max_edge);
  const auto place = [&] { return leaves.mean(1, leaves.simulation().positions()).x(); };
  const auto speed = [&] { return leaves.mean(1, leaves.simulation().velocities()).x(); };
  const int tilting = 30;
  for (int i = 1; i <= tilting; ++i) {
    leaves.simulation().configure({tilted(slope * i / tilting), 0, 1});
    leaves.step();
  }
  steps(leaves, 1);
  const double time = leaves.simulation().time(), from = place(), before = speed();
  steps(leaves, 14);
  const double passed = leaves.simulation().time() - time;
  return {(place() - from) / passed, (speed() - before) / passed};
}

void verifyFriction(VerificationReport& report, double max_edge) {
  const double friction = ContactConfig().friction;
  report.add({kItem, "speed [m/s] on a slope of 0.98 of the friction", 0,
              slide(std::atan(0.98 * friction), max_edge).speed, kSlowest,
              "friction is below its bound for slips slower than 1e-4 m/s"});
  for (const double part : {1.02, 1.1, 1.5}) {
    const double slope = std::atan(part * friction);
    const double expected = kGravity * (std::sin(slope) - friction * std::cos(slope));
    report.add({kItem,
                "acceleration [m/s^2] on a slope of " + std::to_string(part).substr(0, 4) +
                    " of the friction, g (sin - mu cos)",
                expected, slide(slope, max_edge).acceleration, 1e-4 * kGravity,
                "gaps under the leaf differ by 1e-6 m over 1e-2 m: its slope is known to 1e-4"});
  }
}

/// Two leaves that fly towards each other at a speed [m/s], turned and moved by `placing`, with a
/// common velocity.
std::vector<Leaf> colliding(double speed, const Eigen::Isometry3d& placing, const Vector3& common) {
  const Eigen::Isometry3d oblique(Eigen::Translation3d(0.01, 0.005, 0.03) *
                                  Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()));
  std::vector<Leaf> leaves = {{kSide, lying(0), {0, 0, speed / 2}},
                              {kSide, oblique, {0, 0.1, -speed / 2}}};
  for (Leaf& leaf : leaves) {
    leaf.pose = placing * leaf.pose;
    leaf.velocity = placing.linear() * leaf.velocity + common;
  }
  return leaves;
}

void verifyCollision(VerificationReport& report, double max_edge) {
  SimulationConfig config = paper();
  config.solver.integrator = IntegratorKind::kBackwardEuler;
  LooseLeaves leaves(colliding(1, Eigen::Isometry3d::Identity(), Vector3::Zero()), max_edge,
                     config);
  const Simulation& simulation = leaves.simulation();
  const Eigen::VectorXd& masses = simulation.shell().shell().masses();
  const auto momentum = [&] { return Vector3(simulation.velocities() * masses); };
  const auto energy = [&] {
    const Energies e = simulation.energies();
    return e.kinetic + e.strain() + e.contact;
  };
  const Vector3 start = momentum();
  const double scale = simulation.velocities().colwise().norm().dot(masses.transpose());
  const double first = energy();
  double drift = 0, growth = 0, last = first;
  std::size_t crossing = 0;
  for (int i = 0; i < 30; ++i) {
    leaves.step();
    drift = std::max(drift, (momentum() - start).norm() / scale);
    growth = std::max(growth, (energy() - last) / first);
    last = energy();
    crossing += simulation.crossings().size();
  }
  report.add({kItem, "two leaves collide: drift of their momentum over sum m |v|", 0, drift,
              kRounding, "contact and friction give no force to the whole: rounding"});
  report.add({kItem, "largest growth of their energy in a step, over all of it", 0, growth,
              kRounding, "a step of backward Euler lowers it: rounding"});
  report.add({kItem, "pairs of triangles that cross, in all states", 0,
              static_cast<double>(crossing), 0, "none, by exact predicates"});
}

/// Where the leaves are after they have collided, with their common motion taken back.
Positions collided(double max_edge, const Eigen::Isometry3d& placing, const Vector3& common,
                   bool swapped) {
  std::vector<Leaf> flying = colliding(0.1, placing, common);
  if (swapped) std::swap(flying[0], flying[1]);
  LooseLeaves leaves(flying, max_edge, paper());
  steps(leaves, 13);
  const Simulation& simulation = leaves.simulation();
  const Positions back =
      placing.inverse() * (simulation.positions().colwise() - Vector3(common * simulation.time()));
  if (!swapped) return back;
  Positions first_last(3, back.cols());
  first_last << back.rightCols(back.cols() - leaves.first(1)), back.leftCols(leaves.first(1));
  return first_last;
}

void verifySymmetries(VerificationReport& report, double max_edge) {
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d turned(Eigen::Translation3d(6, -8, 0) *
                                 Eigen::AngleAxisd(45 * kDegree, Vector3(1, -1, 0.5).normalized()));
  const Positions expected = collided(max_edge, still, Vector3::Zero(), false);
  const auto add = [&](const std::string& what, const Positions& x) {
    report.add({kItem, "two leaves collide, " + what + ": largest difference [m]", 0,
                (x - expected).cwiseAbs().maxCoeff(), 1e-8,
                "steps are solved to 1e-8 m/s, 2e-10 m each; a corner's impact magnifies that"});
  };
  add("turned by 45 degrees, 10 m away", collided(max_edge, turned, Vector3::Zero(), false));
  add("in a frame that moves at 1 m/s", collided(max_edge, still, Vector3::UnitX(), false));
  add("with their numbers swapped", collided(max_edge, still, Vector3::Zero(), true));
}

/// Loose leaves between one that is held and one that is carried down.
void verifyPress(VerificationReport& report, double max_edge) {
  const int count = 5, last = count - 1;
  std::vector<Leaf> stack;
  for (int i = 0; i < count; ++i) stack.push_back({kSide, lying(i * 6e-5, 0.3 * i)});
  SimulationConfig config = paper();
  config.material.air_damping = 100;  // until the leaves rest between two moves of the press
  LooseLeaves leaves(stack, max_edge, config);
  Simulation& simulation = leaves.simulation();
  simulation.pin(leaves.vertices(0));
  Pose press;
  simulation.pin(leaves.vertices(last), "press", press);
  // Close layers also push those beyond the next: all that pass a gap count.
  const auto forceThrough = [&](int gap) {
    Vector3 sum = Vector3::Zero();
    for (int lower = 0; lower <= gap; ++lower) {
      for (int upper = gap + 1; upper < count; ++upper) sum += leaves.force(upper, lower);
    }
    return sum.z();
  };
  double fall = 0, before = 0, uneven = 0;
  for (int i = 0; i < 20; ++i) {
    press.position.z() -= 8e-6;
    simulation.carry("press", press);
    steps(leaves, 10);
    if (i < kLoose) continue;
    const double force = forceThrough(last - 1);
    fall = std::max(fall, before - force);
    before = force;
    for (int gap = 0; gap < last - 1; ++gap) {
      uneven = std::max(uneven, std::abs(forceThrough(gap) / force - 1));
    }
  }
  report.add(
      {kItem, "force through each gap of a pressed stack over that on the press, less 1", 0, uneven,
       1e-4,
       "friction, which does not count here, has a part along the press where layers slope by "
       "1e-4"});
  report.add({kItem, "largest fall of the force as the press goes down [N]", 0, fall, 0,
              "the deeper, the more"});
}

}  // namespace

void verifyContact(VerificationReport& report) {
  const double max_edge = report.fast() ? 0.02 : 0.01;
  verifyWeight(report, max_edge);
  verifyFriction(report, max_edge);
  verifyCollision(report, max_edge);
  verifySymmetries(report, max_edge);
  verifyPress(report, max_edge);
}

}  // namespace shell_origami
