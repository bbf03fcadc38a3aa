#include "verify/loose_leaves.h"

#include <shell_origami/mesh/triangulate.h>

#include <numeric>
#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

/// Between leaves of the flat sheet [m]: far enough for contact to have its full reach.
constexpr double kApart = 0.05;

/// Leaves side by side on one sheet, and where each begins.
struct Cut {
  std::vector<Vector2> points;
  std::vector<Triangle> triangles;
  std::vector<int> first = {0};
  Positions positions = Positions(3, 0), velocities = Positions(3, 0);
};

Cut cut(const std::vector<Leaf>& leaves, double max_edge) {
  Cut cut;
  double left = 0;
  for (const Leaf& leaf : leaves) {
    const Triangulation square = triangulateRectangle(leaf.side, leaf.side, max_edge);
    const int first = cut.first.back();
    const auto count = static_cast<Eigen::Index>(square.points().size());
    cut.positions.conservativeResize(3, first + count);
    cut.velocities.conservativeResize(3, first + count);
    cut.velocities.rightCols(count).colwise() = leaf.velocity;
    for (const Vector2& p : square.points()) {
      const Vector2 centered = p - Vector2::Constant(leaf.side / 2);
      cut.positions.col(static_cast<Eigen::Index>(cut.points.size())) =
          leaf.pose * Vector3(centered.x(), centered.y(), 0);
      cut.points.push_back(p + Vector2(left, 0));
    }
    for (const Triangle& t : square.triangles()) {
      cut.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    cut.first.push_back(first + static_cast<int>(count));
    left += leaf.side + kApart;
  }
  return cut;
}

Simulation thrown(const Cut& cut, const SimulationConfig& config) {
  const Simulation still(Sheet(Triangulation(cut.points, cut.triangles)), config, cut.positions,
                         {});
  Snapshot snapshot = still.snapshot();
  snapshot.motion.velocities = cut.velocities;
  return Simulation(snapshot);
}

}  // namespace

LooseLeaves::LooseLeaves(const std::vector<Leaf>& leaves, double max_edge,
                         const SimulationConfig& config)
    : first_(cut(leaves, max_edge).first), simulation_(thrown(cut(leaves, max_edge), config)) {}

std::vector<std::int64_t> LooseLeaves::vertices(int leaf) const {
  std::vector<std::int64_t> vertices(first(leaf + 1) - first(leaf));
  std::iota(vertices.begin(), vertices.end(), first(leaf));
  return vertices;
}

double LooseLeaves::mass(int leaf) const {
  const Eigen::VectorXd& masses = simulation_.shell().shell().masses();
  return masses.segment(first(leaf), first(leaf + 1) - first(leaf)).sum();
}

Vector3 LooseLeaves::mean(int leaf, const Positions& columns) const {
  const Eigen::Index count = first(leaf + 1) - first(leaf);
  const Eigen::VectorXd masses = simulation_.shell().shell().masses().segment(first(leaf), count);
  return columns.middleCols(first(leaf), count) * masses / masses.sum();
}

Vector3 LooseLeaves::force(int leaf, int by) const {
  const auto leafOf = [this](int v) {
    int leaf = 0;
    while (v >= first(leaf + 1)) ++leaf;
    return leaf;
  };
  Vector3 sum = Vector3::Zero();
  for (const ContactForce& force : simulation_.contactForces()) {
    // The last vertex is of the second primitive for either kind of pair.
    const int one = leafOf(force.vertices[0]), other = leafOf(force.vertices[3]);
    if (one == leaf && other == by) sum += force.force;
    if (one == by && other == leaf) sum -= force.force;
  }
  return sum;
}

void LooseLeaves::step() {
  const StepReport report = simulation_.step();
  if (!report.converged) throw std::runtime_error("loose leaves: " + report.failure);
}

}  // namespace shell_origami
