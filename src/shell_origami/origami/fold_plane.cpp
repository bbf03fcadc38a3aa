#include <shell_origami/origami/fold_plane.h>

#include <shell_origami/base/error.h>

#include <Eigen/Geometry>

#include <cmath>

namespace shell_origami {
namespace {

/// Lengths below this part of the sheet's size are none.
constexpr double kNoLength = 1e-3;

/// Makes planes of landmarks as they are seen: what lies behind each other is at one place.
struct MakePlane {
  const Sheet& sheet;
  const Positions& positions;
  const Vector3& viewer;

  FoldPlane operator()(const BringPoint& bring) const {
    const Vector3 from = seen(bring.from), to = seen(bring.to);
    return plane((from + to) / 2, direction(to, from), from);
  }

  FoldPlane operator()(const BringEdge& bring) const {
    const Vector3 a = seen(bring.edge[0]), b = seen(bring.edge[1]);
    const Vector3 c = seen(bring.to_edge[0]), d = seen(bring.to_edge[1]);
    const Vector3 mover = (a + b) / 2;
    const Vector3 u = direction(a, b), v = direction(c, d);
    const double turn = u.cross(v).dot(viewer);
    if (std::abs(turn) < kParallel) {
      return plane((mover + c) / 2, viewer.cross(v), mover);
    }
    const Vector3 meeting = a + (c - a).cross(v).dot(viewer) / turn * u;
    // From where they meet, towards the middle of each edge.
    const Vector3 away = outwards(u, mover - meeting), to = outwards(v, (c + d) / 2 - meeting);
    return plane(meeting, (away - to).normalized(), mover);
  }

  FoldPlane operator()(const FoldAcross& across) const {
    const Vector3 along = direction(seen(across.edge[0]), seen(across.edge[1]));
    return plane(seen(across.at), along, seen(across.move));
  }

  FoldPlane operator()(const FoldAlong& along) const {
    const Vector3 a = seen(along.points[0]), b = seen(along.points[1]);
    return plane(a, viewer.cross(direction(a, b)), seen(along.move));
  }

 private:
  /// Edges that turn by a smaller angle are parallel [rad].
  static constexpr double kParallel = 1e-3;

  /// The landmark in space, moved along the viewer's direction into one plane with all others.
  Vector3 seen(const Landmark& landmark) const {
    const Vector3 point = pointInSpace(flatPoint(landmark, sheet), sheet, positions);
    return point - viewer.dot(point) * viewer;
  }

  Vector3 direction(const Vector3& from, const Vector3& to) const {
    const Vector3 way = to - from;
    if (way.norm() < kNoLength * sheet.size()) {
      reject("two of the fold's points are at one place, as they are seen");
    }
    return way.normalized();
  }

  static Vector3 outwards(const Vector3& direction, const Vector3& way) {
    return direction.dot(way) < 0 ? Vector3(-direction) : direction;
  }

  FoldPlane plane(const Vector3& point, const Vector3& across, const Vector3& mover) const {
    FoldPlane plane{point, across, mover};
    if (plane.distance(mover) < 0) plane.normal = -plane.normal;
    if (!(plane.distance(mover) > kNoLength * sheet.size())) {
      reject("the point that is to move is on the fold");
    }
    return plane;
  }
};

}  // namespace

FoldPlane foldPlane(const FoldAxiom& axiom, const Sheet& sheet, const Positions& positions,
                    const Vector3& viewer) {
  return std::visit(MakePlane{sheet, positions, viewer}, axiom);
}

}  // namespace shell_origami
