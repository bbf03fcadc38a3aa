#include <shell_origami/origami/layers.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// The mover is a corner or on an edge, where layers end, and often on a crease: layers are looked
/// for a little nearer to the plane and to one side, by these parts of its distance.
constexpr double kInwards = 0.05, kSidewards = 0.003;
/// Layers this close to each other in height are one [m].
constexpr double kSameHeight = 1e-9;
/// Boxes have a margin of this part of all lengths, which is far more than rounding amounts to. It
/// is not of triangles that the viewer sees as thinner than this: their boxes hold everything.
constexpr double kBoxMargin = 1e-6;

}  // namespace

LayersBesidePlane::LayersBesidePlane(const Sheet& sheet, const ViewedPaper& paper,
                                     const FoldPlane& plane, double near)
    : sheet_(sheet), paper_(paper), plane_(plane), near_(near), panels_(panelOfTriangle(sheet)) {
  findFlaps();
  findBoxes();
}

void LayersBesidePlane::findBoxes() {
  across_[0] = paper_.viewer.unitOrthogonal();
  across_[1] = paper_.viewer.cross(across_[0]);
  const Positions& x = paper_.positions;
  const double margin = kBoxMargin * (sheet_.size() + x.cwiseAbs().maxCoeff());
  for (const Triangle& t : sheet_.triangles()) {
    Eigen::AlignedBox2d box;
    for (int v : t) box.extend(seen(x.col(v)));
    const double lengths = (x.col(t[1]) - x.col(t[0])).norm() * (x.col(t[2]) - x.col(t[0])).norm();
    const bool thin = std::abs(areaNormal(t, x).dot(paper_.viewer)) < kBoxMargin * lengths;
    const Vector2 room = Vector2::Constant(thin ? HUGE_VAL : margin);
    boxes_.emplace_back(box.min() - room, box.max() + room);
  }
}

double LayersBesidePlane::cosine(int triangle) const {
  const Vector3 normal = areaNormal(sheet_.triangles()[triangle], paper_.positions);
  return normal.normalized().dot(paper_.viewer);
}

bool LayersBesidePlane::standsOnEdge(int triangle) const {
  return std::abs(cosine(triangle)) < kOnEdge;
}

double LayersBesidePlane::facing(int triangle) const {
  if (standsOnEdge(triangle)) {
    const Vector2 p = sheet_.triangulation().centroid(triangle);
    reject("the layer at (", p.x(), ", ", p.y(), ") of the flat sheet stands on edge");
  }
  return cosine(triangle);
}

double LayersBesidePlane::turn(int triangle, double angle, bool behind) const {
  return std::copysign(angle, (behind ? -1 : 1) * facing(triangle));
}

/// Triangles are of one flap where they share an edge that reaches beyond the plane.
void LayersBesidePlane::findFlaps() {
  const auto reaches = [&](int v) { return plane_.distance(paper_.positions.col(v)) > near_; };
  flaps_ = connectedTriangles(sheet_, [&](const Edge& edge) {
    return reaches(edge.vertices[0]) || reaches(edge.vertices[1]);
  });
  for (std::size_t i = 0; i < flaps_.size(); ++i) {
    const Triangle& t = sheet_.triangles()[i];
    if (std::none_of(t.begin(), t.end(), reaches)) flaps_[i] = -1;
  }
}

bool LayersBesidePlane::beyond(int triangle) const {
  const Triangle& t = sheet_.triangles()[triangle];
  const Positions& x = paper_.positions;
  return plane_.distance((x.col(t[0]) + x.col(t[1]) + x.col(t[2])) / 3) > 0;
}

/// The layers at a point as the viewer sees it, the nearest first.
std::vector<LayersBesidePlane::Hit> LayersBesidePlane::hitsAt(const Vector3& point) const {
  std::vector<Hit> hits;
  const Vector2 place = seen(point);
  for (std::size_t i = 0; i < flaps_.size(); ++i) {
    if (!boxes_[i].contains(place)) continue;
    const Triangle& t = sheet_.triangles()[i];
    const std::optional<Vector3> weights = weightsSeen(point, t, paper_);
    if (!weights || weights->minCoeff() < 0) continue;
    double height = 0;
    for (int k = 0; k < 3; ++k) height += (*weights)[k] * paper_.heights[t[k]];
    hits.push_back({height, static_cast<int>(i)});
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
  const Vector3 sidewards = kSidewards * far * plane_.normal.cross(paper_.viewer);
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
  const Positions& x = paper_.positions;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!moves[i] || !beyond(static_cast<int>(i))) continue;
    const Triangle& t = sheet_.triangles()[i];
    const Vector3 middle = (x.col(t[0]) + x.col(t[1]) + x.col(t[2])) / 3;
    const double own = (paper_.heights[t[0]] + paper_.heights[t[1]] + paper_.heights[t[2]]) / 3;
    for (const Hit& hit : hitsAt(middle)) {
      const double above = behind ? own - hit.height : hit.height - own;
      if (above < kSameHeight || moves[hit.triangle] || !beyond(hit.triangle)) continue;
      const Vector2 p = sheet_.triangulation().centroid(hit.triangle);
      reject("the layer at (", p.x(), ", ", p.y(), ") of the flat sheet stays, and is ",
             behind ? "behind" : "over", " one that moves");
    }
  }
}

/// The corners of the part of a triangle that is on the side that stays, on the flat sheet.
std::vector<Vector2> LayersBesidePlane::partThatStays(int triangle) const {
  const Triangle& t = sheet_.triangles()[triangle];
  const auto& flat = sheet_.flatPositions();
  std::vector<Vector2> corners;
  for (int k = 0; k < 3; ++k) {
    const int v = t[k], w = t[(k + 1) % 3];
    const double here = plane_.distance(paper_.positions.col(v));
    const double next = plane_.distance(paper_.positions.col(w));
    if (here <= 0) corners.push_back(flat[v]);
    if ((here <= 0) != (next <= 0)) {
      corners.push_back(flat[v] + here / (here - next) * (flat[w] - flat[v]));
    }
  }
  return corners;
}

/// Returns a point of what stays of the triangles that the fold cuts.
/// \throws std::invalid_argument where nothing does
Vector2 LayersBesidePlane::pointThatStays() const {
  const auto stays = [&](int v) { return plane_.distance(paper_.positions.col(v)) < -near_; };
  std::vector<Vector2> largest;
  double most = 0;
  for (std::size_t i = 0; i < flaps_.size(); ++i) {
    const Triangle& t = sheet_.triangles()[i];
    if (std::none_of(t.begin(), t.end(), stays) || standsOnEdge(static_cast<int>(i))) continue;
    std::vector<Vector2> part = partThatStays(static_cast<int>(i));
    double area = 0;
    for (std::size_t k = 2; k < part.size(); ++k) area += doubleArea(part[0], part[k - 1], part[k]);
    if (area <= most) continue;
    most = area;
    largest = std::move(part);
  }
  if (largest.empty()) reject("nothing stays: all of the paper is on the side that moves");
  Vector2 sum = Vector2::Zero();
  for (const Vector2& corner : largest) sum += corner;
  return sum / static_cast<double>(largest.size());
}

Viewpoint LayersBesidePlane::viewOfRest(const std::vector<bool>& moves) const {
  int largest = -1;
  double most = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const auto& [a, b, c] = sheet_.triangles()[i];
    const auto& flat = sheet_.flatPositions();
    const double area = doubleArea(flat[a], flat[b], flat[c]);
    // Of those that the fold cuts a part moves.
    if (moves[i] || area <= most || standsOnEdge(static_cast<int>(i))) continue;
    largest = static_cast<int>(i);
    most = area;
  }
  if (largest < 0) return viewAt(pointThatStays(), sheet_, paper_);
  return {sheet_.triangulation().centroid(largest), facing(largest) > 0};
}

}  // namespace shell_origami
