#include <shell_origami/sheet/remap.h>

#include <cmath>

namespace shell_origami {
namespace {

/// Follows places of the sheet after an edit to the one before it.
class Trace {
 public:
  Trace(const Sheet& before, const Sheet& after, double tolerance)
      : before_(before), after_(after), tolerance_(tolerance), home_(after.vertexCount()) {}

  Remap remap() {
    Remap remap;
    remap.vertices_before = before_.vertexCount();
    traceVertices(remap);
    traceTriangles(remap);
    traceEdges(remap);
    return remap;
  }

 private:
  void traceVertices(Remap& remap) {
    std::vector<int> around(before_.vertexCount());
    for (int t = 0; t < static_cast<int>(before_.triangles().size()); ++t) {
      for (int v : before_.triangles()[t]) around[v] = t;
    }
    int last = 0;  // new vertices lie along a line: each is near the one before it
    moved_.assign(after_.vertexCount(), false);
    for (int v = 0; v < after_.vertexCount(); ++v) {
      const Vector2& p = after_.flatPositions()[v];
      const bool old = v < before_.vertexCount();
      if (old) home_[v] = around[v];
      if (old && p == before_.flatPositions()[v]) continue;
      const Triangulation& mesh = after_.triangulation();
      const auto place =
          mesh.onBorder(v) ? locateBeside(p, mesh.around(v)[0]) : locate(p, old ? around[v] : last);
      moved_[v] = true;
      home_[v] = last = place.triangle;
      remap.changed.push_back(v);
      remap.origins.push_back({before_.triangles()[place.triangle], place.weights});
    }
  }

  void traceTriangles(Remap& remap) {
    const auto& olds = before_.triangles();
    kept_.assign(after_.triangles().size(), false);
    for (int t = 0; t < static_cast<int>(after_.triangles().size()); ++t) {
      const Triangle& c = after_.triangles()[t];
      const bool moved = moved_[c[0]] || moved_[c[1]] || moved_[c[2]];
      kept_[t] = !moved && t < static_cast<int>(olds.size()) && c == olds[t];
      const Vector2 centroid = after_.triangulation().centroid(t);
      remap.triangles.push_back(kept_[t] ? t : locate(centroid, home_[c[0]]).triangle);
    }
  }

  void traceEdges(Remap& remap) {
    remap.edges.assign(after_.edges().size(), Remap::kNone);
    for (int t = 0; t < static_cast<int>(after_.triangles().size()); ++t) {
      for (int k = 0; k < 3; ++k) {
        int& edge = remap.edges[after_.edgeIndex({t, k})];
        if (edge != Remap::kNone) continue;
        edge = kept_[t] ? before_.edgeIndex({t, k}) : edgeUnder({t, k});
      }
    }
  }

  /// The edge before that an edge after lies on.
  int edgeUnder(Triangulation::Side side) const {
    const Triangulation& mesh = after_.triangulation();
    const auto ends = mesh.ends(side);
    const Vector2 &p = after_.flatPositions()[ends[0]], &q = after_.flatPositions()[ends[1]];
    const Vector2 middle = (p + q) / 2;
    const bool on_border = mesh.neighbour(side) == Triangulation::kNone;
    const int t = on_border ? locateBeside(middle, side.triangle).triangle
                            : locate(middle, home_[ends[0]]).triangle;
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = before_.triangulation().ends({t, k});
      const Vector2 &from = before_.flatPositions()[a], &to = before_.flatPositions()[b];
      const double length = (to - from).norm();
      const auto off = [&](const Vector2& r) { return std::abs(doubleArea(from, to, r)) / length; };
      if (distanceToSegment(middle, from, to) <= tolerance_ && off(p) <= tolerance_ &&
          off(q) <= tolerance_) {
        return before_.edgeIndex({t, k});
      }
    }
    return Remap::kNone;
  }

  /// The place of a point on the border, or on the side of a slit that a triangle after is on.
  Triangulation::Location locateBeside(const Vector2& p, int triangle) const {
    const Vector2 inside = after_.triangulation().centroid(triangle) - p;
    const auto place = before_.triangulation().locateAhead(p, inside, tolerance_);
    return place ? *place : locate(p, 0);
  }

  Triangulation::Location locate(const Vector2& p, int near) const {
    return *before_.triangulation().locateNear(p, tolerance_, near);
  }

  const Sheet &before_, &after_;
  double tolerance_;
  std::vector<int> home_;    ///< a triangle before, at or near each vertex after
  std::vector<bool> moved_;  ///< vertices that are new or shifted
  std::vector<bool> kept_;   ///< triangles that are what they were
};

}  // namespace

Eigen::Matrix3Xd Remap::apply(const Eigen::Matrix3Xd& before, int vertices_after) const {
  Eigen::Matrix3Xd after(3, vertices_after);
  after.leftCols(vertices_before) = before;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const Origin& origin = origins[i];
    Vector3 value = Vector3::Zero();
    for (int k = 0; k < 3; ++k) value += origin.weights[k] * before.col(origin.vertices[k]);
    after.col(changed[i]) = value;
  }
  return after;
}

Remap traceEdit(const Sheet& before, const Sheet& after, double tolerance) {
  return Trace(before, after, tolerance).remap();
}

}  // namespace shell_origami
