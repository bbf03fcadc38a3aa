#include <shell_origami/origami/rabbit_ear.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <cmath>
#include <vector>

namespace shell_origami {
namespace {

/// Part of the sheet's size by which a place beyond an edge of the paper is off it.
constexpr double kBeyond = 0.004;
/// Within which the paper may settle, as a part of the duration.
constexpr double kEarRest = 0.3;

/// The flap's corners on the flat sheet, counter-clockwise or not.
struct Ear {
  Vector2 tip, near, far;  ///< it lies down towards the far one

  /// Where the bisectors of its angles meet.
  Vector2 center() const {
    const double a = (far - near).norm(), b = (far - tip).norm(), c = (near - tip).norm();
    return (a * tip + b * near + c * far) / (a + b + c);
  }
  /// Where the ear's fold ends on the edge between the tip and the far corner.
  Vector2 foot() const {
    const Vector2 along = (far - tip).normalized();
    return tip + along.dot(center() - tip) * along;
  }
};

bool onPaper(const Vector2& point, const Sheet& sheet) {
  return sheet.triangulation().locate(point, 1e-6 * sheet.size()).has_value();
}

/// A place just beyond the middle of one of the flap's sides.
Vector2 beyond(const Vector2& a, const Vector2& b, const Ear& ear, const Sheet& sheet) {
  const Vector2 middle = (a + b) / 2, along = (b - a).normalized();
  Vector2 out(-along.y(), along.x());
  if (out.dot(ear.center() - middle) > 0) out = -out;
  return middle + kBeyond * sheet.size() * out;
}

void requireEdge(const Vector2& a, const Vector2& b, const Ear& ear, const Sheet& sheet) {
  if (!onPaper(beyond(a, b, ear, sheet), sheet)) return;
  reject("the flap's side from (", a.x(), ", ", a.y(), ") to (", b.x(), ", ", b.y(),
         ") is not an edge of the paper");
}

void requireOnePanel(const Ear& ear, const FoldedCreases& folded, const Sheet& sheet) {
  const std::vector<int> panels = connectedTriangles(
      sheet, [&](const Edge& edge) { return edge.crease < 0 || !folded.has(edge.crease); });
  const Vector2 center = ear.center();
  const auto panelAt = [&](const Vector2& p) {
    const auto place = sheet.triangulation().locate(p, 1e-6 * sheet.size());
    return place ? panels[place->triangle] : -1;
  };
  for (const Vector2& corner : {ear.tip, ear.near, ear.far}) {
    for (const double part : {0.1, 0.5, 0.9}) {
      const Vector2 p = center + part * (corner - center);
      if (panelAt(p) == panelAt(center)) continue;
      reject("the flap is folded between (", center.x(), ", ", center.y(), ") and (", p.x(), ", ",
             p.y(), ") of the flat sheet");
    }
  }
}

}  // namespace

ManoeuvrePlan planRabbitEar(const RabbitEar& ear, const ManoeuvreManner& manner,
                            const Viewpoint& view, const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  const auto& flat = sheet.flatPositions();
  const auto corner = [&](const Landmark& landmark, const char* what) {
    return flat[outlineVertexAt(landmark, what, sheet)];
  };
  const Ear flap{corner(ear.flap, "the flap's tip"), corner(ear.base[0], "the base's corner"),
                 corner(ear.base[1], "the base's corner")};
  if (std::abs(doubleArea(flap.tip, flap.near, flap.far)) < kBeyond * sheet.area()) {
    reject("the flap's tip and base are on one line");
  }
  requireEdge(flap.tip, flap.near, flap, sheet);
  requireEdge(flap.tip, flap.far, flap, sheet);
  const Vector2 stays = beyond(flap.near, flap.far, flap, sheet);
  if (!onPaper(stays, sheet)) reject("there is no paper beyond the flap's base");
  requireOnePanel(flap, foldedCreases(simulation), sheet);
  const Vector2 center = flap.center();
  const ViewedPaper paper = viewedPaper(view, simulation);
  const int triangle = sheet.triangulation().locate(center, 1e-6 * sheet.size())->triangle;
  const double facing = areaNormal(sheet.triangles()[triangle], paper.positions).dot(paper.viewer);
  const double valley = std::copysign(manner.angle, ear.behind ? -facing : facing);
  FoldPhase phase{{}, kEarRest * manner.duration};
  for (const Vector2& to : {flap.tip, flap.near, flap.far}) {
    phase.folds.push_back(lineFold({center, to}, valley, manner.duration));
  }
  phase.folds.push_back(lineFold({center, flap.foot()}, -valley, manner.duration));
  return {{phase}, phase.folds, viewAt(stays, sheet, paper)};
}

}  // namespace shell_origami
