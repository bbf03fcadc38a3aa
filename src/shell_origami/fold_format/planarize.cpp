#include <shell_origami/fold_format/planarize.h>

#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/planar_faces.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace shell_origami {
namespace {

/// Of edges and of crossings: the pairs are looked at one by one.
constexpr std::size_t kMostEdges = 100000, kMostCrossings = 1000000;
/// Creases that fold differently may lie on each other over so many times kDrawnPrecision, where
/// one of them ends a little beyond the other.
constexpr double kShortOverlap = 5;
/// Least sine of the angle between edges at whose crossing a point is put that both pass.
constexpr double kCrossing = 0.5;
/// Edges that pass a point closely take it with them, whose other edges may then pass another one.
constexpr int kMostPasses = 20;

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

bool isOutline(const PatternEdge& edge) { return edge.isBorder() || edge.isCut(); }

/// Which of two edges on each other stays: the one of higher rank.
int rank(const PatternEdge& edge) { return edge.isFlat() ? 0 : edge.isCrease() ? 1 : 2; }

/// Divides the edges of a pattern until they meet only at their ends.
class Planarizer {
 public:
  explicit Planarizer(CreasePattern& pattern)
      : pattern_(pattern),
        tolerance_(kDrawnPrecision * extentOf(pattern.points)),
        exact_(coincidence(pattern.points)),
        corner_(lowerLeft(pattern.points)) {}

  void run() {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      mergePoints();
      dropDoubles();
      if (!divide()) {
        note();
        return;
      }
    }
    reject("its edges lie so close to each other that they cannot be divided where they cross");
  }

 private:
  const Vector2& point(int v) const { return pattern_.points[v]; }

  /// Returns for each point the nearest of those that stand for others within the tolerance: the
  /// first ones, none of which are closer to each other.
  std::vector<int> standIns() const {
    const std::vector<Vector2>& points = pattern_.points;
    std::vector<int> stand_in(points.size());
    if (tolerance_ == 0) return stand_in;  // all are in one place
    std::iota(stand_in.begin(), stand_in.end(), 0);
    std::set<int> used;
    for (const PatternEdge& edge : pattern_.edges)
      used.insert(edge.vertices.begin(), edge.vertices.end());
    std::map<std::pair<int, int>, std::vector<int>> cells;  // as wide as the tolerance
    for (int v : used) {
      const Eigen::Vector2i cell = ((points[v] - corner_) / tolerance_).array().floor().cast<int>();
      double nearest = tolerance_;
      for (int x = cell.x() - 1; x <= cell.x() + 1; ++x) {
        for (int y = cell.y() - 1; y <= cell.y() + 1; ++y) {
          const auto near = cells.find({x, y});
          if (near == cells.end()) continue;
          for (int other : near->second) {
            const double distance = (points[v] - points[other]).norm();
            if (distance > nearest) continue;
            nearest = distance;
            stand_in[v] = other;
          }
        }
      }
      if (stand_in[v] == v) cells[{cell.x(), cell.y()}].push_back(v);
    }
    return stand_in;
  }

  void mergePoints() {
    const std::vector<int> stand_in = standIns();
    for (PatternEdge& edge : pattern_.edges) {
      for (int& v : edge.vertices) {
        const int other = stand_in[v];
        if (other == v) continue;
        if (v < file_points_ && (point(v) - point(other)).norm() > exact_) merged_.insert(v);
        v = other;
      }
    }
    for (NotedCrease& crease : pattern_.noted) {
      for (int& v : crease.vertices) v = stand_in[v];
    }
  }

  /// Drops edges that have lost their length, and all but one of those that lie on each other.
  void dropDoubles() {
    std::map<std::pair<int, int>, std::size_t> places;
    std::vector<PatternEdge> edges;
    for (const PatternEdge& edge : pattern_.edges) {
      const auto [a, b] = edge.vertices;
      if (a == b) continue;
      const auto [at, is_new] = places.emplace(std::minmax(a, b), edges.size());
      if (is_new) {
        edges.push_back(edge);
        continue;
      }
      doubles_.insert(edge.number);
      edges[at->second] = oneOf(edges[at->second], edge);
    }
    pattern_.edges = std::move(edges);
  }

  PatternEdge oneOf(PatternEdge edge, const PatternEdge& other) const {
    if (rank(edge) != rank(other)) return rank(edge) > rank(other) ? edge : other;
    if (rank(edge) == 2) edge.kind = 'C';
    const auto [a, b] = edge.vertices;
    const bool is_long = (point(a) - point(b)).norm() > kShortOverlap * tolerance_;
    if (rank(edge) == 1 && is_long && !edge.foldsLike(other)) {
      reject(pattern_.edgeName(edge), " and ", pattern_.edgeName(other),
             " lie on each other, but fold differently");
    }
    return edge;
  }

  /// Divides each edge at the points that it passes and where it crosses others. Returns whether
  /// there were any.
  bool divide() {
    auto& edges = pattern_.edges;
    if (edges.size() > kMostEdges) {
      reject("has ", edges.size(), " edges, more than the ", kMostEdges, " allowed");
    }
    inner_points_.assign(edges.size(), {});
    passed_.clear();
    meetAll();
    for (const auto& [v, passing] : passed_) pattern_.points[v] = placeOn(passing, point(v));
    std::vector<PatternEdge> parts;
    for (std::size_t i = 0; i < edges.size(); ++i) addParts(edges[i], inner_points_[i], parts);
    const bool any = parts.size() > edges.size();
    edges = std::move(parts);
    return any;
  }

  /// A sweep from left to right: only edges whose ranges of x overlap are compared.
  void meetAll() {
    const auto& edges = pattern_.edges;
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const PatternEdge& edge : edges) {
      Eigen::AlignedBox2d box(point(edge.vertices[0]));
      box.extend(point(edge.vertices[1]));
      boxes.push_back(box);
    }
    std::vector<std::size_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&boxes](std::size_t i, std::size_t j) {
      return boxes[i].min().x() < boxes[j].min().x();
    });
    for (std::size_t n = 0; n < order.size(); ++n) {
      const Eigen::AlignedBox2d& box = boxes[order[n]];
      for (std::size_t m = n + 1; m < order.size(); ++m) {
        const Eigen::AlignedBox2d& other = boxes[order[m]];
        if (other.min().x() > box.max().x() + tolerance_) break;
        if (other.min().y() > box.max().y() + tolerance_ ||
            box.min().y() > other.max().y() + tolerance_) {
          continue;
        }
        meet(std::min(order[n], order[m]), std::max(order[n], order[m]));
      }
    }
  }

  /// Finds where two edges divide each other.
  void meet(std::size_t i, std::size_t j) {
    const auto [a, b] = pattern_.edges[i].vertices;
    const auto [c, d] = pattern_.edges[j].vertices;
    const bool share_an_end = a == c || a == d || b == c || b == d;
    bool touch = false;
    for (int v : {c, d}) touch |= passes(i, v);
    for (int v : {a, b}) touch |= passes(j, v);
    if (touch || share_an_end) return;
    const Vector2 &p = point(a), &q = point(b), &r = point(c), &s = point(d);
    const double at_p = doubleArea(r, s, p), at_q = doubleArea(r, s, q);
    if ((at_p > 0) == (at_q > 0) || (doubleArea(p, q, r) > 0) == (doubleArea(p, q, s) > 0)) return;
    if (++crossings_ > kMostCrossings) {
      reject("its edges cross more than ", kMostCrossings, " times");
    }
    const int crossing = static_cast<int>(pattern_.points.size());
    const Vector2 place = p + at_p / (at_p - at_q) * (q - p);
    pattern_.points.push_back(place);
    pattern_.file_vertices.push_back(-1);
    inner_points_[i].push_back(crossing);
    inner_points_[j].push_back(crossing);
  }

  /// Whether an edge passes a point that is none of its ends, which then divides it.
  bool passes(std::size_t i, int v) {
    const auto [a, b] = pattern_.edges[i].vertices;
    if (v == a || v == b) return false;
    const double distance = distanceToSegment(point(v), point(a), point(b));
    if (distance > tolerance_) return false;
    inner_points_[i].push_back(v);
    if (distance > exact_) {
      auto& passing = passed_[v];
      passing.insert(isOutline(pattern_.edges[i]) ? passing.begin() : passing.end(),
                     {point(a), point(b)});
    }
    return true;
  }

  /// The place of a point on edges that pass it: where two of them cross or else on the first, so
  /// that they stay straight.
  static Vector2 placeOn(const std::vector<Segment>& edges, const Vector2& p) {
    const Vector2 from = edges[0][0], along = (edges[0][1] - from).normalized();
    for (const Segment& other : edges) {
      const Vector2 across = (other[1] - other[0]).normalized();
      if (std::abs(cross(along, across)) < kCrossing) continue;
      return from + cross(other[0] - from, across) / cross(along, across) * along;
    }
    return from + along.dot(p - from) * along;
  }

  void addParts(PatternEdge edge, std::vector<int>& inner, std::vector<PatternEdge>& parts) {
    const auto [a, b] = edge.vertices;
    const Vector2 along = point(b) - point(a);
    std::sort(inner.begin(), inner.end());
    inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
    std::stable_sort(inner.begin(), inner.end(),
                     [&](int v, int w) { return along.dot(point(v) - point(w)) < 0; });
    if (!inner.empty()) divided_.insert(edge.number);
    inner.push_back(b);
    int from = a;
    for (int to : inner) {
      edge.vertices = {from, to};
      parts.push_back(edge);
      from = to;
    }
  }

  void note() {
    if (!merged_.empty()) {
      pattern_.notes.push_back(
          counted(merged_.size(), "point was", "points were") +
          " merged with others closer than a thousandth of the pattern's size");
    }
    if (!divided_.empty()) {
      pattern_.notes.push_back(counted(divided_.size(), "edge was", "edges were") +
                               " divided at crossings and at points of others");
    }
    if (!doubles_.empty()) {
      pattern_.notes.push_back(counted(doubles_.size(), "edge lies", "edges lie") +
                               " on others at least in part, where one of them stands for both");
    }
  }

  CreasePattern& pattern_;
  const double tolerance_, exact_;
  const Vector2 corner_;
  const int file_points_ = static_cast<int>(pattern_.points.size());
  std::vector<std::vector<int>> inner_points_;  ///< of each edge
  std::map<int, std::vector<Segment>> passed_;  ///< edges that pass each point, border first
  std::size_t crossings_ = 0;
  std::set<int> merged_;             ///< points of the file
  std::set<int> divided_, doubles_;  ///< numbers of edges
};

/// Drops what sticks out of the paper of edges that are on it as well.
void trimAtBorder(CreasePattern& pattern) {
  auto& edges = pattern.edges;
  const Outline outline = traceOutline(pattern);
  std::set<int> numbers_on_paper;
  std::vector<bool> sticks_out;
  for (const PatternEdge& edge : edges) {
    const auto [a, b] = edge.vertices;
    const bool on_paper =
        edge.isBorder() || outline.contains((pattern.points[a] + pattern.points[b]) / 2);
    if (on_paper) numbers_on_paper.insert(edge.number);
    sticks_out.push_back(!on_paper);
  }
  std::set<int> trimmed;
  std::vector<PatternEdge> kept;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_trimmed = sticks_out[i] && numbers_on_paper.count(edges[i].number) > 0;
    if (is_trimmed) trimmed.insert(edges[i].number);
    else kept.push_back(edges[i]);
  }
  edges = std::move(kept);
  if (trimmed.empty()) return;
  pattern.notes.push_back(counted(trimmed.size(), "edge that stuck", "edges that stuck") +
                          " out of the paper ended at its border");
}

/// Tells border from cuts, and finds the border where a drawing has neither.
void findDrawnBorder(CreasePattern& pattern) {
  auto& edges = pattern.edges;
  const bool has_outline = std::any_of(edges.begin(), edges.end(), isOutline);
  std::vector<std::size_t> candidates;
  std::vector<std::array<int, 2>> ends;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (has_outline && !isOutline(edges[i])) continue;
    candidates.push_back(i);
    ends.push_back(edges[i].vertices);
  }
  const FaceWalks walks = walkFaces(pattern.points, ends);
  const double size = extentOf(pattern.points);
  const int outside = walks.outermost(1e-9 * size * size);
  if (outside < 0) {
    if (has_outline) return;  // traceOutline() names the place where it ends
    reject("has no outline: no border edges (B), no faces, and its edges enclose no paper");
  }
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    PatternEdge& edge = edges[candidates[k]];
    const auto [left, right] = walks.of_edges[k];
    if ((left == outside) != (right == outside)) {
      edge.kind = 'B';
      edge.angle = 0;
    } else if (edge.isBorder() && left == right) {
      edge.kind = 'C';
    }
  }
  trimAtBorder(pattern);
  if (!has_outline) {
    pattern.notes.push_back(
        "it has no border, so that what surrounds all its edges is taken as one");
  }
}

}  // namespace

void makePlanar(CreasePattern& pattern, bool keep_flat_edges) {
  const auto& edges = pattern.edges;
  if (!keep_flat_edges && std::any_of(edges.begin(), edges.end(), isOutline)) {
    dropFlatEdges(pattern);
  }
  dropUnused(pattern, true);
  Planarizer(pattern).run();
  findDrawnBorder(pattern);
}

}  // namespace shell_origami
