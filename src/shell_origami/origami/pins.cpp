#include <shell_origami/origami/pins.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/vertex_grid.h>

#include <cmath>
#include <set>

namespace shell_origami {

void checkVertex(const Sheet& sheet, std::int64_t vertex) {
  if (vertex < 0 || vertex >= sheet.vertexCount()) {
    reject("vertex ", vertex, " does not exist: the sheet has ", sheet.vertexCount());
  }
}

std::vector<int> verticesAt(const PinWhere& where, const Sheet& sheet, const Positions& positions) {
  std::set<int> found;
  if (const auto* ids = std::get_if<std::vector<std::int64_t>>(&where)) {
    if (ids->empty()) reject("no vertices are given");
    for (std::int64_t v : *ids) {
      checkVertex(sheet, v);
      found.insert(static_cast<int>(v));
    }
  } else if (const auto* points = std::get_if<std::vector<Vector2>>(&where)) {
    if (points->empty()) reject("no points are given");
    const VertexGrid grid(sheet);
    const double tolerance = 1e-6 * sheet.size();
    for (const Vector2& p : *points) {
      if (!p.allFinite()) reject("the point (", p.x(), ", ", p.y(), ") is not finite");
      const int v = grid.nearest(p);
      const int near = sheet.triangulation().around(v)[0];
      if (!sheet.triangulation().locateNear(p, tolerance, near)) {
        reject("the point (", p.x(), ", ", p.y(), ") is off the paper");
      }
      found.insert(v);
    }
  } else if (const auto* region = std::get_if<Region>(&where)) {
    if (region->corners.size() < 3) {
      reject("a region needs at least three corners, not ", region->corners.size());
    }
    for (const Vector2& p : region->corners) {
      if (!p.allFinite()) reject("the corner (", p.x(), ", ", p.y(), ") is not finite");
    }
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      if (polygonContains(region->corners, sheet.flatPositions()[v], 1e-9 * sheet.size())) {
        found.insert(v);
      }
    }
    if (found.empty()) {
      const Vector2& corner = region->corners[0];
      reject("no vertex lies in the region that starts at (", corner.x(), ", ", corner.y(), ")");
    }
  } else {
    const Ball& ball = std::get<Ball>(where);
    if (!ball.center.allFinite()) reject("the center of the ball is not finite");
    if (!(ball.radius > 0 && std::isfinite(ball.radius))) {
      reject("radius ", ball.radius, " m is not positive and finite");
    }
    for (int v = 0; v < sheet.vertexCount(); ++v) {
      if ((positions.col(v) - ball.center).norm() <= ball.radius) found.insert(v);
    }
    if (found.empty()) {
      reject("no vertex is within ", ball.radius, " m of (", ball.center.x(), ", ", ball.center.y(),
             ", ", ball.center.z(), ")");
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace shell_origami
