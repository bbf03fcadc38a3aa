#include <shell_origami/origami/layers.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shell_origami {
namespace {

/// The mover is a corner or on an edge, where layers end, and often on a crease: layers are looked
/// for a little nearer to the plane and to one side, by these parts of its distance.
constexpr double kInwards = 0.05, kSidewards = 0.003;
/// Cosine of the angle between a layer's normal and the stack's beyond which it stands on edge.
constexpr double kOnEdge = 0.5;
/// Layers this close to each other in height are one [m].
constexpr double kSameHeight = 1e-9;

/// The normal of a triangle in space, twice its area long.
Vector3 areaNormal(const Triangle& t, const Positions& x) {
  return Vector3(x.col(t[1]) - x.col(t[0])).cross(Vector3(x.col(t[2]) - x.col(t[0])));
}

}  // namespace

Viewpoint frontOf(const Sheet& sheet) { return {sheet.triangulation().centroid(0), true}; }

Vector3 viewerOf(const Viewpoint& view, const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Triangle& t : sheet.triangles()) {
    const Vector3 normal = areaNormal(t, simulation.positions());
    sum += normal * normal.transpose() / normal.norm();
  }
  const Vector3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
  const auto place = sheet.triangulation().locate(view.point, 1e-6 * sheet.size());
  if (!place) reject("the viewpoint (", view.point.x(), ", ", view.point.y(), ") is off the paper");
  const Vector3 normal =
      areaNormal(sheet.triangles()[place->triangle], simulation.positions()).normalized();
  const double facing = (view.front ? 1 : -1) * axis.dot(normal);
  if (std::abs(facing) < kOnEdge) {
    reject("the layer at (", view.point.x(), ", ", view.point.y(),
           ") of the flat sheet, at which the viewer looks, stands on edge");
  }
  return facing > 0 ? axis : Vector3(-axis);
}

LayersBesidePlane::LayersBesidePlane(const Simulation& simulation, const FoldPlane& plane,
                                     const Vector3& viewer, double near)
    : simulation_(simulation),
      sheet_(simulation.sheet()),
      plane_(plane),
      viewer_(viewer),
      panels_(panelOfTriangle(sheet_)) {
  findFlaps(near);
}

double LayersBesidePlane::facing(int triangle) const {
  const Vector3 normal = areaNormal(sheet_.triangles()[triangle], simulation_.positions());
  const double cosine = normal.normalized().dot(viewer_);
  if (std::abs(cosine) < kOnEdge) {
    const Vector2 p = sheet_.triangulation().centroid(triangle);
    reject("the layer at (", p.x(), ", ", p.y(), ") of the flat sheet stands on edge");
  }
  return cosine;
}

/// Triangles are of one flap where they share an edge that reaches beyond the plane.
void LayersBesidePlane::findFlaps(double near) {
  const auto reaches = [&](int v) {
    return plane_.distance(simulation_.positions().col(v)) > near;
  };
  flaps_ = connectedTriangles(sheet_, [&](const Edge& edge) {
    return reaches(edge.vertices[0]) || reaches(edge.vertices[1]);
  });
  for (std::size_t i = 0; i < flaps_.size(); ++i) {
    const Triangle& t = sheet_.triangles()[i];
    if (std::none_of(t.begin(), t.end(), reaches)) flaps_[i] = -1;
  }
}

/// Whether its middle is.
bool LayersBesidePlane::beyond(int triangle) const {
  const Triangle& t = sheet_.triangles()[triangle];
  const Positions& x = simulation_.positions();
  return plane_.distance((x.col(t[0]) + x.col(t[1]) + x.col(t[2])) / 3) > 0;
}

/// The layers at a point as the viewer sees it, the nearest first.
std::vector<LayersBesidePlane::Hit> LayersBesidePlane::hitsAt(const Vector3& point) const {
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < flaps_.size(); ++i) {
    const Triangle& t = sheet_.triangles()[i];
    const Positions& x = simulation_.positions();
    const Vector3 a = x.col(t[0]), u = Vector3(x.col(t[1])) - a, v = Vector3(x.col(t[2])) - a;
    const double whole = u.cross(v).dot(viewer_);
    if (whole == 0) continue;
    const double along_u = (point - a).cross(v).dot(viewer_) / whole;
    const double along_v = u.cross(point - a).dot(viewer_) / whole;
    if (along_u < 0 || along_v < 0 || along_u + along_v > 1) continue;
    hits.push_back({viewer_.dot(a + along_u * u + along_v * v), static_cast<int>(i)});
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return a.height != b.height ? a.height > b.height : a.triangle < b.triangle;
  });
  return hits;
}

/// The layers that lie where the mover is.
std::vector<LayersBesidePlane::Hit> LayersBesidePlane::hitsAtMover() const {
  const double far = plane_.distance(plane_.mover);
  const Vector3 inwards = plane_.mover - kInwards * far * plane_.normal;
  const Vector3 sidewards = kSidewards * far * plane_.normal.cross(viewer_);
  std::vector<Hit> left = hitsAt(inwards + sidewards), right = hitsAt(inwards - sidewards);
  return left.size() < right.size() ? right : left;
}

std::vector<bool> LayersBesidePlane::chosen(FoldLayers layers, int count,
                                            const std::optional<Vector2>& flap) const {
  std::vector<bool> wanted(flaps_.size() + 1, layers == FoldLayers::kAll);  // by flap
  std::vector<Hit> hits;
  if (layers == FoldLayers::kTop) {
    hits = hitsAtMover();
    if (static_cast<int>(hits.size()) < count) {
      reject("top is ", count, ", but there are ", hits.size(), " layers where the fold moves");
    }
    for (int i = 0; i < count; ++i) {
      const int hit = flaps_[hits[i].triangle];
      if (hit >= 0) wanted[hit] = true;
    }
  } else if (layers == FoldLayers::kFlap) {
    const auto place = sheet_.triangulation().locate(*flap, 1e-6 * sheet_.size());
    const int there = flaps_[place->triangle];
    if (there < 0) {
      reject("the flap's point (", flap->x(), ", ", flap->y(), ") is not on the side that moves");
    }
    wanted[there] = true;
  }
  std::vector<bool> moves;
  for (int own : flaps_) moves.push_back(own >= 0 && wanted[own]);
  if (std::none_of(moves.begin(), moves.end(), [](bool one) { return one; })) {
    reject("nothing is on the side that moves");
  }
  if (layers == FoldLayers::kTop) requireOnly(moves, hits, static_cast<std::size_t>(count));
  return moves;
}

void LayersBesidePlane::requireOnly(const std::vector<bool>& chosen, const std::vector<Hit>& hits,
                                    std::size_t count) const {
  for (std::size_t i = count; i < hits.size(); ++i) {
    if (!chosen[hits[i].triangle]) continue;
    const Vector2 p = sheet_.triangulation().centroid(hits[i].triangle);
    reject("the top ", count, " layers are joined, beyond the fold, to layer ", i + 1,
           ", which should stay: that at (", p.x(), ", ", p.y(), ") of the flat sheet");
  }
}

void LayersBesidePlane::requireFree(const std::vector<bool>& moves, bool behind) const {
  const Positions& x = simulation_.positions();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!moves[i] || !beyond(static_cast<int>(i))) continue;
    const Triangle& t = sheet_.triangles()[i];
    const Vector3 middle = (x.col(t[0]) + x.col(t[1]) + x.col(t[2])) / 3;
    const double own = viewer_.dot(middle);
    for (const Hit& hit : hitsAt(middle)) {
      const double above = behind ? own - hit.height : hit.height - own;
      if (above < kSameHeight || moves[hit.triangle] || !beyond(hit.triangle)) continue;
      const Vector2 p = sheet_.triangulation().centroid(hit.triangle);
      reject("the layer at (", p.x(), ", ", p.y(), ") of the flat sheet stays, and is ",
             behind ? "behind" : "over", " one that moves");
    }
  }
}

Viewpoint LayersBesidePlane::viewOfRest(const std::vector<bool>& moves) const {
  int largest = -1;
  double most = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const auto& [a, b, c] = sheet_.triangles()[i];
    const auto& flat = sheet_.flatPositions();
    const double area = doubleArea(flat[a], flat[b], flat[c]);
    // Of those that the fold cuts a part moves.
    if (moves[i] || area <= most) continue;
    largest = static_cast<int>(i);
    most = area;
  }
  if (largest < 0) reject("nothing stays: all of the paper is on the side that moves");
  return {sheet_.triangulation().centroid(largest), facing(largest) > 0};
}

}  // namespace shell_origami
