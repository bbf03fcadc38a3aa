#include <shell_origami/origami/squash_fold.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shell_origami {
namespace {

/// Parts of the whole duration and stiffness, as a multiple of the material's, by phase: the flap
/// is raised, opened and shut again.
constexpr double kRaise = 0.25, kSquash = 0.5, kShutAgain = 0.25;
constexpr double kOpeningStiffness = 5;
/// Within which the paper may settle after a phase, as a part of the whole duration.
constexpr double kRestAfterSquash = 0.1;
/// A point this far beside a hinge, as an angle [rad] and a part of its length, is on its layer.
constexpr double kBesideHinge = 0.05;
/// Points that are closer together than this part of the sheet's size are taken for one.
constexpr double kSamePlace = 0.008;

/// A crease that leaves the flap's inner corner.
struct Ray {
  Segment line;      ///< from the corner on [m]
  double angle = 0;  ///< [rad]

  Vector2 direction() const { return (line[1] - line[0]).normalized(); }
};

double turnTo(const Ray& from, const Ray& to) {
  const Vector2 u = from.direction(), v = to.direction();
  return std::atan2(cross(u, v), u.dot(v));
}

/// One of the two ways to squash a flap: to the side of the one or of the other of its hinges.
struct Way {
  Ray opening;  ///< the hinge that becomes flat
  Ray staying;  ///< the hinge that is shut again
};

class SquashPlanner {
 public:
  SquashPlanner(const SquashFold& squash, const ManoeuvreManner& manner, const Viewpoint& view,
                const Simulation& simulation)
      : squash_(squash),
        manner_(manner),
        simulation_(simulation),
        sheet_(simulation.sheet()),
        folded_(foldedCreases(simulation)),
        paper_(viewedPaper(view, simulation)) {}

  ManoeuvrePlan plan() {
    findFlap();
    const Way way = chosenWay();
    const double half = std::abs(turnTo(ridge_, way.opening)) / 2;
    const Ray near_opening = creaseAt(way.opening, half),
              near_staying = creaseAt(way.staying, half);
    ManoeuvrePlan plan{{}, {}, viewAt(beside(way.staying), sheet_, paper_)};
    const double shut = manner_.angle;
    plan.result = {fold(ridge_, 0, kSquash), fold(way.opening, 0, kSquash),
                   fold(near_opening, std::copysign(shut, ridge_.angle), kSquash),
                   fold(near_staying, -std::copysign(shut, way.staying.angle), kSquash)};
    plan.phases.push_back({{fold(way.opening, way.opening.angle / 2, kRaise),
                            fold(way.staying, way.staying.angle / 2, kRaise)},
                           rest()});
    plan.phases.push_back({plan.result, rest()});
    plan.result.push_back(fold(way.staying, std::copysign(shut, way.staying.angle), kShutAgain));
    plan.phases.push_back({{plan.result.back()}, rest()});
    return plan;
  }

 private:
  /// A point of the layer beyond a hinge, which stays.
  Vector2 beside(const Ray& hinge) const {
    const double away = std::copysign(kBesideHinge, turnTo(ridge_, hinge));
    const Vector2 direction = Eigen::Rotation2Dd(away) * hinge.direction();
    const double length = (hinge.line[1] - hinge.line[0]).norm();
    return hinge.line[0] + kBesideHinge * length * direction;
  }

  double rest() const { return kRestAfterSquash * manner_.duration; }

  FoldEdit fold(const Ray& ray, double angle, double part) const {
    FoldEdit fold = lineFold(ray.line, angle, part * manner_.duration);
    if (part == kSquash)
      fold.stiffness = kOpeningStiffness * simulation_.config().material.crease_stiffness;
    return fold;
  }

  Ray rayTo(int next) const {
    const std::vector<int> path = folded_.along(corner_, next);
    return {{sheet_.flatPositions()[corner_], sheet_.flatPositions()[path.back()]},
            shutAngle(creaseBetween(sheet_, corner_, next), simulation_)};
  }

  /// The fold that joins the layers, the inner corner at which it ends, and the hinges there.
  void findFlap() {
    const Vector2 point = flatPoint(squash_.bring, sheet_);
    const Edge& edge = nearestCreaseEdge(point);
    requireBeside(edge);
    const auto [a, b] = edge.vertices;
    const std::vector<int> back = folded_.along(a, b), on = folded_.along(b, a);
    const bool outwards = sheet_.triangulation().onBorder(on.back());
    corner_ = outwards ? back.back() : on.back();
    if (sheet_.triangulation().onBorder(corner_) ||
        !sheet_.triangulation().onBorder(outwards ? on.back() : back.back())) {
      reject("the fold at (", point.x(), ", ", point.y(),
             ") does not lead from the edge of the paper to where creases meet");
    }
    const std::vector<int>& inwards = outwards ? back : on;
    const int next = inwards[inwards.size() - 2];
    ridge_ = rayTo(next);
    const std::vector<int> around = folded_.at(corner_);
    const auto count = static_cast<int>(around.size());
    if (count < 4) {
      reject("only ", count, " folds meet at the flap's inner corner (", ridge_.line[0].x(), ", ",
             ridge_.line[0].y(), ")");
    }
    const auto at =
        static_cast<int>(std::find(around.begin(), around.end(), next) - around.begin());
    hinges_ = {rayTo(around[(at + 1) % count]), rayTo(around[(at + count - 1) % count])};
    if (hinges_[0].angle * hinges_[1].angle > 0) {
      reject("the folds beside the flap at (", point.x(), ", ", point.y(),
             ") are both mountains or both valleys: it has no two layers that open");
    }
  }

  /// \throws std::invalid_argument where the flap's point is on neither layer
  void requireBeside(const Edge& edge) const {
    const Vector2 point = flatPoint(squash_.flap, sheet_);
    const std::vector<int> panels = panelOfTriangle(sheet_);
    const int own = panels[sheet_.triangulation().locate(point, 1e-6 * sheet_.size())->triangle];
    if (own == panels[edge.triangles[0]] || own == panels[edge.triangles[1]]) return;
    reject("the flap's point (", point.x(), ", ", point.y(),
           ") is on neither of the layers that the fold to be brought joins");
  }

  const Edge& nearestCreaseEdge(const Vector2& point) const {
    const Edge* nearest = nullptr;
    double least = kSamePlace * sheet_.size();
    for (const Edge& edge : sheet_.edges()) {
      if (edge.crease < 0 || !folded_.has(edge.crease)) continue;
      const Vector2& a = sheet_.flatPositions()[edge.vertices[0]];
      const Vector2 along = sheet_.flatPositions()[edge.vertices[1]] - a;
      const double part = std::clamp(along.dot(point - a) / along.squaredNorm(), 0.0, 1.0);
      const double distance = (a + part * along - point).norm();
      if (distance >= least) continue;
      nearest = &edge;
      least = distance;
    }
    if (!nearest) {
      reject("the point (", point.x(), ", ", point.y(), "), which is to be brought, is on no fold");
    }
    return *nearest;
  }

  /// The way that brings the ridge onto the line. Where both do, the layer opens that the flap's
  /// point is on.
  Way chosenWay() const {
    const Vector2 flap = flatPoint(squash_.flap, sheet_) - ridge_.line[0];
    const bool first = (cross(ridge_.direction(), flap) > 0) == (turnTo(ridge_, hinges_[0]) > 0);
    const int held = first ? 0 : 1;
    for (const int k : {held, 1 - held}) {
      const Way way{hinges_[k], hinges_[1 - k]};
      const double half = std::abs(turnTo(ridge_, way.opening)) / 2;
      if (half >= std::abs(turnTo(ridge_, way.staying))) continue;
      if (distanceFromLine(landing(way, half)) < kSamePlace * sheet_.size()) return way;
    }
    reject("the flap's fold does not come onto the line, to neither side");
  }

  /// Where the ridge's end comes to lie: its layer is folded along the new crease beside the hinge
  /// that stays.
  Vector3 landing(const Way& way, double half) const {
    const Vector2 direction = turned(way.staying, half);
    const Vector2& corner = ridge_.line[0];
    const Vector2 image = mirrored(ridge_.line[1], {corner, corner + direction});
    // The place in space of any point in the plane of the layer that stays.
    const double nudge = 0.01;
    const Vector2 inside = corner + nudge * (ridge_.line[1] - corner).norm() *
                                        (ridge_.direction() + way.staying.direction()).normalized();
    const auto place = sheet_.triangulation().locate(inside, 1e-6 * sheet_.size());
    if (!place) reject("the flap's inner corner is at the edge of the paper");
    const Triangle& t = sheet_.triangles()[place->triangle];
    const auto& flat = sheet_.flatPositions();
    Eigen::Matrix2d axes;
    axes << flat[t[1]] - flat[t[0]], flat[t[2]] - flat[t[0]];
    const Vector2 weights = axes.inverse() * (image - flat[t[0]]);
    const Positions& x = paper_.positions;
    return Vector3(x.col(t[0])) + weights[0] * Vector3(x.col(t[1]) - x.col(t[0])) +
           weights[1] * Vector3(x.col(t[2]) - x.col(t[0]));
  }

  double distanceFromLine(const Vector3& point) const {
    Vector3 ends[2];
    for (int k = 0; k < 2; ++k) {
      ends[k] = pointInSpace(flatPoint(squash_.onto[k], sheet_), sheet_, paper_.positions);
    }
    const Vector3 along =
        (ends[1] - ends[0]).cross(paper_.viewer).cross(paper_.viewer).normalized();
    const Vector3 way = point - ends[0];
    return std::abs(along.cross(way).dot(paper_.viewer));
  }

  /// The direction at an angle from the ridge, towards a hinge.
  Vector2 turned(const Ray& towards, double angle) const {
    return Eigen::Rotation2Dd(std::copysign(angle, turnTo(ridge_, towards))) * ridge_.direction();
  }

  /// The new crease beside a hinge, to the edge of the paper.
  Ray creaseAt(const Ray& hinge, double half) const {
    const Vector2 corner = ridge_.line[0], direction = turned(hinge, half);
    const Segment ray{corner, corner + direction};
    double least = std::numeric_limits<double>::infinity();
    const Edge* end = nullptr;
    for (const Edge& edge : sheet_.edges()) {
      if (!edge.onBorder() && (edge.crease < 0 || !folded_.has(edge.crease))) continue;
      const Vector2& a = sheet_.flatPositions()[edge.vertices[0]];
      const Vector2& b = sheet_.flatPositions()[edge.vertices[1]];
      const double from = cross(direction, a - corner), to = cross(direction, b - corner);
      if ((from > 0) == (to > 0)) continue;
      const double distance = direction.dot(meetingOf(ray, {a, b}) - corner);
      if (distance < 1e-6 * sheet_.size() || distance >= least) continue;
      least = distance;
      end = &edge;
    }
    const Vector2 place = corner + least * direction;
    if (!end || !end->onBorder()) {
      reject("the squash's crease from (", corner.x(), ", ", corner.y(),
             ") meets another fold at (", place.x(), ", ", place.y(), ")");
    }
    return {{corner, place}};
  }

  const SquashFold& squash_;
  const ManoeuvreManner& manner_;
  const Simulation& simulation_;
  const Sheet& sheet_;
  FoldedCreases folded_;
  ViewedPaper paper_;
  int corner_ = -1;  ///< the vertex at which the ridge and the hinges meet
  Ray ridge_;
  std::array<Ray, 2> hinges_;
};

}  // namespace

ManoeuvrePlan planSquashFold(const SquashFold& squash, const ManoeuvreManner& manner,
                             const Viewpoint& view, const Simulation& simulation) {
  return SquashPlanner(squash, manner, view, simulation).plan();
}

}  // namespace shell_origami
