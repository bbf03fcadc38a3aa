#include <shell_origami/origami/viewed_paper.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace shell_origami {
namespace {

/// A crease is shut or flat where its fold asks for that to this angle, and it is there to the
/// second one [rad].
constexpr double kAsked = 0.1, kThere = 0.5;
/// Panels are flat where all but a part of their area lies at less than this angle [rad] to the
/// stack of layers.
constexpr double kFlatEnough = 0.7, kNotFlat = 0.02;
/// Panels close where edges of paper folded exactly flat keep their lengths to this part of the
/// sheet's size.
constexpr double kCloses = 1e-4;

/// The direction across the stack of layers, to either side.
Vector3 stackAxis(const Sheet& sheet, const Positions& x) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Triangle& t : sheet.triangles()) {
    const Vector3 normal = areaNormal(t, x);
    sum += normal * normal.transpose() / normal.norm();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
}

Vector3 viewerOf(const Viewpoint& view, const Sheet& sheet, const Positions& x) {
  const Vector3 axis = stackAxis(sheet, x);
  const auto place = sheet.triangulation().locate(view.point, 1e-6 * sheet.size());
  if (!place) reject("the viewpoint (", view.point.x(), ", ", view.point.y(), ") is off the paper");
  const Vector3 normal = areaNormal(sheet.triangles()[place->triangle], x).normalized();
  const double facing = (view.front ? 1 : -1) * axis.dot(normal);
  if (std::abs(facing) < kOnEdge) {
    reject("the layer at (", view.point.x(), ", ", view.point.y(),
           ") of the flat sheet, at which the viewer looks, stands on edge");
  }
  return facing > 0 ? axis : Vector3(-axis);
}

/// The angle of a crease that is folded exactly flat; none where it stands open.
std::optional<double> flatAngle(const CreaseStatus& crease) {
  for (double flat : {-M_PI, 0.0, M_PI}) {
    if (std::abs(crease.target_angle - flat) < kAsked && std::abs(crease.angle - flat) < kThere) {
      return flat;
    }
  }
  return std::nullopt;
}

bool keepsLengths(const Sheet& sheet, const Positions& x) {
  const auto& flat = sheet.flatPositions();
  return std::all_of(sheet.edges().begin(), sheet.edges().end(), [&](const Edge& edge) {
    const auto [a, b] = edge.vertices;
    const double change = (x.col(a) - x.col(b)).norm() - (flat[a] - flat[b]).norm();
    return std::abs(change) < kCloses * sheet.size();
  });
}

bool liesFlat(const Sheet& sheet, const Positions& x, const Vector3& axis) {
  double whole = 0, bent = 0;
  for (const Triangle& t : sheet.triangles()) {
    const Vector3 normal = areaNormal(t, x);
    whole += normal.norm();
    if (std::abs(normal.dot(axis)) < std::cos(kFlatEnough) * normal.norm()) bent += normal.norm();
  }
  return bent < kNotFlat * whole;
}

std::optional<Positions> foldedFlat(const Simulation& simulation, const Vector3& axis) {
  if (!liesFlat(simulation.sheet(), simulation.positions(), axis)) return std::nullopt;
  std::vector<double> angles;
  for (const CreaseStatus& crease : simulation.creases()) {
    const std::optional<double> angle = flatAngle(crease);
    if (!angle) return std::nullopt;
    angles.push_back(*angle);
  }
  Positions folded = foldRigidly(simulation.sheet(), angles);
  if (!keepsLengths(simulation.sheet(), folded)) return std::nullopt;
  return folded;
}

}  // namespace

Viewpoint viewAt(const Vector2& point, const Sheet& sheet, const ViewedPaper& paper) {
  const auto place = sheet.triangulation().locate(point, 1e-6 * sheet.size());
  const Vector3 normal = areaNormal(sheet.triangles()[place->triangle], paper.positions);
  return {point, normal.dot(paper.viewer) > 0};
}

std::optional<Vector3> weightsSeen(const Vector3& point, const Triangle& t,
                                   const ViewedPaper& paper) {
  const Positions& x = paper.positions;
  const Vector3 a = x.col(t[0]), u = Vector3(x.col(t[1])) - a, v = Vector3(x.col(t[2])) - a;
  const double whole = u.cross(v).dot(paper.viewer);
  if (whole == 0) return std::nullopt;
  const double along_u = (point - a).cross(v).dot(paper.viewer) / whole;
  const double along_v = u.cross(point - a).dot(paper.viewer) / whole;
  return Vector3(1 - along_u - along_v, along_u, along_v);
}

Vector3 areaNormal(const Triangle& t, const Positions& x) {
  return Vector3(x.col(t[1]) - x.col(t[0])).cross(Vector3(x.col(t[2]) - x.col(t[0])));
}

Viewpoint frontOf(const Sheet& sheet) { return {sheet.triangulation().centroid(0), true}; }

ViewedPaper viewedPaper(const Viewpoint& view, const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  const Vector3 viewer = viewerOf(view, sheet, simulation.positions());
  const Eigen::VectorXd heights = simulation.positions().transpose() * viewer;
  if (std::optional<Positions> flat = foldedFlat(simulation, viewer)) {
    const Vector3 viewer_of_flat = viewerOf(view, sheet, *flat);
    return {std::move(*flat), viewer_of_flat, heights};
  }
  return {simulation.positions(), viewer, heights};
}

}  // namespace shell_origami
