#include <shell_origami/rviz/snapping.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace shell_origami {
namespace {

constexpr int kDirections = 16;  ///< of 22.5 degrees
/// Beside the paper it is looked for in so many directions.
constexpr int kLooks = 8;

/// Finds the best place for one pointer.
class Snapping {
 public:
  Snapping(const Vector2& pixel, const RayHit& hit, const Camera& camera, const ShownPaper& paper)
      : pixel_(pixel),
        camera_(camera),
        paper_(paper),
        place_{hit.triangle, hit.weights},
        panel_(paper.panel(hit.triangle)),
        flat_(paper.flat(place_)) {}

  Spot find(const std::optional<Vector2>& from);

 private:
  void offer(Spot spot, double within);
  void offerVertices(const std::vector<int>& vertices, SnapKind kind);
  void offerMiddles();
  void offerPoints();
  void offerLines();
  void offerCrossings(const Vector2& from);
  void offerDirections(const Vector2& from);
  Spot onEdge(SnapKind kind, int edge, double part) const;
  SnapKind lineKind(int edge) const {
    return paper_.sheet().edges()[edge].crease >= 0 ? SnapKind::kCrease : SnapKind::kOutline;
  }
  Vector3 inSpace(const Vector2& flat) const;

  Vector2 pixel_;
  const Camera& camera_;
  const ShownPaper& paper_;
  PaperPlace place_;
  int panel_;
  Vector2 flat_;
  std::optional<Spot> best_;
  double best_distance_ = std::numeric_limits<double>::infinity();
};

/// Keeps the spot where it is near enough and better than the best so far: of a kind that is
/// preferred, or nearer.
void Snapping::offer(Spot spot, double within) {
  if (spot.place.triangle < 0) return;
  const double distance = (camera_.pixel(paper_.point(spot.place)) - pixel_).norm();
  if (!(distance <= within)) return;
  if (best_ &&
      (best_->kind < spot.kind || (best_->kind == spot.kind && best_distance_ <= distance))) {
    return;
  }
  best_distance_ = distance;
  best_ = spot;
}

void Snapping::offerVertices(const std::vector<int>& vertices, SnapKind kind) {
  for (int v : vertices) {
    if (!paper_.touches(v, panel_)) continue;
    Spot spot{kind, paper_.placeOf(v, panel_), paper_.sheet().flatPositions()[v], v};
    offer(spot, kSnapPixels);
  }
}

Spot Snapping::onEdge(SnapKind kind, int edge, double part) const {
  const Edge& on = paper_.sheet().edges()[edge];
  const auto& flat = paper_.sheet().flatPositions();
  Spot spot{kind, paper_.placeOn(edge, part, panel_)};
  spot.flat = (1 - part) * flat[on.vertices[0]] + part * flat[on.vertices[1]];
  spot.vertex = on.vertices[part < 0.5 ? 0 : 1];
  spot.crease = on.crease;
  return spot;
}

void Snapping::offerMiddles() {
  const auto& flat = paper_.sheet().flatPositions();
  for (const Middle& middle : paper_.middles()) {
    const auto& [a, b] = paper_.sheet().edges()[middle.edge].vertices;
    const double part = (middle.flat - flat[a]).norm() / (flat[b] - flat[a]).norm();
    Spot spot = onEdge(SnapKind::kMiddle, middle.edge, std::clamp(part, 0.0, 1.0));
    spot.flat = middle.flat;
    offer(spot, kSnapPixels);
  }
}

void Snapping::offerPoints() {
  for (int e : paper_.lines()) {
    for (double part : {0.0, 1.0}) offer(onEdge(SnapKind::kPoint, e, part), kPointPixels);
  }
}

/// The nearest point of each edge as it is seen. An edge is short: perspective does not count.
void Snapping::offerLines() {
  for (int e : paper_.lines()) {
    const auto& [a, b] = paper_.sheet().edges()[e].vertices;
    const Vector2 from = camera_.pixel(paper_.positions().col(a));
    const Vector2 along = camera_.pixel(paper_.positions().col(b)) - from;
    if (along.isZero()) continue;
    const double part = (pixel_ - from).dot(along) / along.squaredNorm();
    offer(onEdge(lineKind(e), e, std::clamp(part, 0.0, 1.0)), kSnapPixels);
  }
}

Vector2 directionOf(int step) {
  const double angle = step * 2 * M_PI / kDirections;
  return {std::cos(angle), std::sin(angle)};
}

double degreesOf(int step) { return step * 360.0 / kDirections; }

void Snapping::offerCrossings(const Vector2& from) {
  const auto& flat = paper_.sheet().flatPositions();
  for (int e : paper_.lines()) {
    const auto& [a, b] = paper_.sheet().edges()[e].vertices;
    const Vector2 along = flat[b] - flat[a];
    for (int step = 0; step < kDirections; ++step) {
      const Vector2 direction = directionOf(step);
      const double sine = cross(direction, along);
      if (std::abs(sine) < 1e-9 * along.norm()) continue;  // parallel
      const double part = cross(flat[a] - from, direction) / sine;
      if (!(part >= 0 && part <= 1)) continue;
      if (direction.dot(flat[a] + part * along - from) <= 1e-9)
        continue;  // behind, or at the start
      Spot spot = onEdge(SnapKind::kCrossing, e, part);
      spot.direction = degreesOf(step);
      offer(spot, kSnapPixels);
    }
  }
}

/// Returns where the pointer's triangle would have a point of the flat sheet if it were larger.
Vector3 Snapping::inSpace(const Vector2& flat) const {
  const Triangle& t = paper_.sheet().triangles()[place_.triangle];
  const auto& p = paper_.sheet().flatPositions();
  const double area = doubleArea(p[t[0]], p[t[1]], p[t[2]]);
  const double b = doubleArea(p[t[0]], flat, p[t[2]]) / area;
  const double c = doubleArea(p[t[0]], p[t[1]], flat) / area;
  return paper_.point({place_.triangle, {1 - b - c, b, c}});
}

void Snapping::offerDirections(const Vector2& from) {
  for (int step = 0; step < kDirections; ++step) {
    const Vector2 direction = directionOf(step);
    const double along = direction.dot(flat_ - from);
    if (along <= 0) continue;
    const Vector2 foot = from + along * direction;
    if ((camera_.pixel(inSpace(foot)) - pixel_).norm() > kSnapPixels) continue;
    Spot spot{SnapKind::kDirection, paper_.place(foot, place_.triangle), foot};
    if (spot.place.triangle < 0 || paper_.panel(spot.place.triangle) != panel_) continue;
    spot.vertex = paper_.nearestVertex(spot.place);
    spot.direction = degreesOf(step);
    offer(spot, kSnapPixels);
  }
}

Spot Snapping::find(const std::optional<Vector2>& from) {
  offerVertices(paper_.corners(), SnapKind::kCorner);
  offerVertices(paper_.features(), SnapKind::kVertex);
  offerMiddles();
  if (from) offerCrossings(*from);
  offerPoints();
  offerLines();
  // Directions across a crease would not be straight.
  if (from && !best_) offerDirections(*from);
  if (best_) return *best_;
  return {SnapKind::kFree, place_, flat_, paper_.nearestVertex(place_)};
}

/// Casts the ray of the pixel or, where it passes the paper, those of some pixels around it.
std::optional<RayHit> hitNear(const Vector2& pixel, const Camera& camera, const RayCaster& caster) {
  std::optional<RayHit> hit = caster.cast(camera.ray(pixel));
  for (double radius : {kSnapPixels / 2, kSnapPixels}) {
    for (int i = 0; i < kLooks && !hit; ++i) {
      const double angle = i * 2 * M_PI / kLooks;
      hit = caster.cast(camera.ray(pixel + radius * Vector2(std::cos(angle), std::sin(angle))));
    }
  }
  return hit;
}

std::string millimeters(const Vector2& flat) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "(%.1f, %.1f) mm", 1e3 * flat.x(), 1e3 * flat.y());
  return text.data();
}

std::string degrees(double angle) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g°", angle);
  return text.data();
}

}  // namespace

std::optional<Spot> spotAt(const Vector2& pixel, const Camera& camera, const ShownPaper& paper,
                           const RayCaster& caster, const std::optional<Vector2>& from) {
  const std::optional<RayHit> hit = hitNear(pixel, camera, caster);
  if (!hit) return std::nullopt;
  return Snapping(pixel, *hit, camera, paper).find(from);
}

std::string describe(const Spot& spot, const ShownPaper& paper) {
  const auto crease = [&] { return paper.sheet().creases()[spot.crease].name; };
  const std::string line = spot.crease >= 0 ? "crease " + crease() : "edge of the paper";
  const std::string at = " " + millimeters(spot.flat);
  switch (spot.kind) {
    case SnapKind::kCorner: return "corner" + at;
    case SnapKind::kVertex: return "end of creases" + at;
    case SnapKind::kMiddle: return "middle of " + line + at;
    case SnapKind::kCrossing: return "direction " + degrees(spot.direction) + " to " + line + at;
    case SnapKind::kPoint: return "vertex " + std::to_string(spot.vertex) + " on " + line + at;
    case SnapKind::kCrease:
    case SnapKind::kOutline: return line + at;
    case SnapKind::kDirection: return "direction " + degrees(spot.direction) + at;
    case SnapKind::kFree: break;
  }
  return "point" + at;
}

}  // namespace shell_origami
