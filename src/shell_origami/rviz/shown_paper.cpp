#include <shell_origami/rviz/shown_paper.h>

#include <shell_origami/base/error.h>
#include <shell_origami/origami/landmark.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace shell_origami {
namespace {

/// A point this far off the paper is taken to be on it, relative to the sheet's size.
constexpr double kBesidePaper = 1e-6;

/// The edges of a polyline, as indices into Sheet::edges(), and the vertices that they lead to.
struct Way {
  std::vector<int> edges, vertices;
};

/// The edges at each vertex.
using EdgesAt = std::map<int, std::vector<int>>;

int farEnd(const Edge& edge, int vertex) {
  return edge.vertices[0] == vertex ? edge.vertices[1] : edge.vertices[0];
}

/// Goes along an edge from a feature, and on to the next feature. Empty where there is none.
Way wayFrom(int start, int edge, const EdgesAt& edges_at, const std::set<int>& features,
            const std::vector<Edge>& edges) {
  Way way{{edge}, {farEnd(edges[edge], start)}};
  while (features.count(way.vertices.back()) == 0) {
    const std::vector<int>& here = edges_at.at(way.vertices.back());
    if (here.size() != 2) return {};
    way.edges.push_back(here[here[0] == way.edges.back() ? 1 : 0]);
    way.vertices.push_back(farEnd(edges[way.edges.back()], way.vertices.back()));
  }
  return way;
}

}  // namespace

ShownPaper::ShownPaper(Sheet sheet)
    : sheet_(std::move(sheet)),
      positions_(Positions::Zero(3, sheet_.vertexCount())),
      crease_angles_(sheet_.creases().size(), 0),
      corners_(cornersOf(sheet_)),
      features_(featuresOf(sheet_)),
      panels_(panelOfTriangle(sheet_)),
      panels_at_(sheet_.vertexCount()) {
  for (int v = 0; v < sheet_.vertexCount(); ++v) {
    positions_.col(v).head<2>() = sheet_.flatPositions()[v];
  }
  for (std::size_t e = 0; e < sheet_.edges().size(); ++e) {
    const Edge& edge = sheet_.edges()[e];
    if (edge.crease >= 0 || edge.onBorder()) lines_.push_back(static_cast<int>(e));
  }
  for (std::size_t t = 0; t < panels_.size(); ++t) {
    for (int v : sheet_.triangles()[t]) panels_at_[v].push_back(panels_[t]);
  }
  for (std::vector<int>& panels : panels_at_) {
    std::sort(panels.begin(), panels.end());
    panels.erase(std::unique(panels.begin(), panels.end()), panels.end());
  }
  findMiddles();
}

void ShownPaper::findMiddles() {
  const std::vector<Edge>& edges = sheet_.edges();
  const auto& flat = sheet_.flatPositions();
  const std::set<int> features(features_.begin(), features_.end());
  EdgesAt edges_at;
  for (int e : lines_) {
    for (int v : edges[e].vertices) edges_at[v].push_back(e);
  }
  for (int start : features_) {
    for (int first : edges_at[start]) {
      const Way way = wayFrom(start, first, edges_at, features, edges);
      // Each way is found from both of its ends.
      if (way.edges.empty() || start > way.vertices.back()) continue;
      const Vector2 from = flat[start], middle = (from + flat[way.vertices.back()]) / 2;
      const double half = (middle - from).norm();
      const auto beyond = std::find_if(way.vertices.begin(), way.vertices.end(),
                                       [&](int v) { return (flat[v] - from).norm() >= half; });
      middles_.push_back({middle, way.edges[beyond - way.vertices.begin()]});
    }
  }
}

void ShownPaper::move(Positions positions, std::vector<double> crease_angles) {
  if (positions.cols() != positions_.cols() || crease_angles.size() != crease_angles_.size()) {
    reject("the state has ", positions.cols(), " vertices and ", crease_angles.size(),
           " creases, but the sheet has ", positions_.cols(), " and ", crease_angles_.size());
  }
  positions_ = std::move(positions);
  crease_angles_ = std::move(crease_angles);
}

bool ShownPaper::touches(int vertex, int panel) const {
  const std::vector<int>& panels = panels_at_[vertex];
  return std::binary_search(panels.begin(), panels.end(), panel);
}

PaperPlace ShownPaper::placeOf(int vertex, int panel) const {
  for (int t : sheet_.triangulation().around(vertex)) {
    if (panels_[t] != panel) continue;
    PaperPlace place{t, Vector3::Zero()};
    place.weights[sheet_.triangulation().cornerOf(t, vertex)] = 1;
    return place;
  }
  return {};
}

PaperPlace ShownPaper::placeOn(int edge, double part, int panel) const {
  const Edge& on = sheet_.edges()[edge];
  for (int t : on.triangles) {
    if (t < 0 || panels_[t] != panel) continue;
    PaperPlace place{t, Vector3::Zero()};
    place.weights[sheet_.triangulation().cornerOf(t, on.vertices[0])] = 1 - part;
    place.weights[sheet_.triangulation().cornerOf(t, on.vertices[1])] = part;
    return place;
  }
  return {};
}

Vector2 ShownPaper::flat(const PaperPlace& place) const {
  Vector2 sum = Vector2::Zero();
  for (int k = 0; k < 3; ++k) {
    sum += place.weights[k] * sheet_.flatPositions()[sheet_.triangles()[place.triangle][k]];
  }
  return sum;
}

Vector3 ShownPaper::point(const PaperPlace& place) const {
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k) {
    sum += place.weights[k] * positions_.col(sheet_.triangles()[place.triangle][k]);
  }
  return sum;
}

PaperPlace ShownPaper::place(const Vector2& flat, int near) const {
  const auto found =
      sheet_.triangulation().locateNear(flat, kBesidePaper * sheet_.size(), std::max(near, 0));
  if (!found) return {};
  return {found->triangle, found->weights};
}

int ShownPaper::nearestVertex(const PaperPlace& place) const {
  const Triangle& corners = sheet_.triangles()[place.triangle];
  const Vector2 p = flat(place);
  return *std::min_element(corners.begin(), corners.end(), [&](int v, int w) {
    const auto& flat = sheet_.flatPositions();
    return (flat[v] - p).squaredNorm() < (flat[w] - p).squaredNorm();
  });
}

Vector3 ShownPaper::normal(int triangle) const {
  const auto& [a, b, c] = sheet_.triangles()[triangle];
  const Vector3 ab = positions_.col(b) - positions_.col(a);
  const Vector3 ac = positions_.col(c) - positions_.col(a);
  return ab.cross(ac).stableNormalized();
}

}  // namespace shell_origami
