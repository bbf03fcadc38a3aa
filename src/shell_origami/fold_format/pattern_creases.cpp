#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/crease_pattern.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace shell_origami {
namespace {

/// Vertices of one crease may stand this part of the pattern's size off its straight line.
constexpr double kStraightness = 4e-7;

/// Joins crease edges into straight lines.
class LineGatherer {
 public:
  explicit LineGatherer(const CreasePattern& pattern)
      : pattern_(pattern), taken_(pattern.edges.size()), edges_at_(pattern.points.size()) {
    Eigen::AlignedBox2d box;
    for (const Vector2& p : pattern.points) box.extend(p);
    tolerance_ = kStraightness * box.sizes().maxCoeff();
    for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
      taken_[i] = !pattern.edges[i].isCrease();
      for (int v : pattern.edges[i].vertices) edges_at_[v].push_back(i);
    }
  }

  bool taken(std::size_t edge) const { return taken_[edge]; }

  /// Takes the edges along a noted crease.
  void take(const NotedCrease& crease) {
    for (std::size_t k = 1; k < crease.vertices.size(); ++k) {
      const int a = crease.vertices[k - 1], b = crease.vertices[k];
      const auto& around = edges_at_[a];
      const auto found = std::find_if(around.begin(), around.end(), [&](std::size_t i) {
        return !taken_[i] && otherEnd(i, a) == b;
      });
      if (found == around.end()) {
        reject("crease ", crease.name, " runs from ", pattern_.vertexName(a), " to ",
               pattern_.vertexName(b), ", where no edge is left to fold");
      }
      taken_[*found] = true;
    }
  }

  /// The whole straight line through an edge, which it takes.
  std::vector<int> lineThrough(std::size_t edge) {
    taken_[edge] = true;
    const auto [a, b] = pattern_.edges[edge].vertices;
    std::vector<int> line{a, b};
    extend(line, edge);
    std::reverse(line.begin(), line.end());
    extend(line, edge);
    std::reverse(line.begin(), line.end());
    return line;
  }

 private:
  int otherEnd(std::size_t edge, int v) const {
    const auto [a, b] = pattern_.edges[edge].vertices;
    return a == v ? b : a;
  }

  bool staysStraight(const std::vector<int>& line, int next) const {
    const Vector2 &from = pattern_.points[line.front()], &to = pattern_.points[next];
    const Vector2& last = pattern_.points[line.back()];
    const Vector2 before = last - pattern_.points[line[line.size() - 2]];
    if (before.dot(to - last) < 0.99 * before.norm() * (to - last).norm()) return false;
    return std::all_of(line.begin(), line.end(), [&](int v) {
      return distanceToSegment(pattern_.points[v], from, to) <= tolerance_;
    });
  }

  /// Whether the paper falls apart around v.
  bool isCutThrough(int v) const {
    int cuts = 0, borders = 0;
    for (std::size_t i : edges_at_[v]) {
      cuts += pattern_.edges[i].isCut();
      borders += pattern_.edges[i].isBorder();
    }
    return cuts > 0 && cuts + borders > 1;
  }

  void extend(std::vector<int>& line, std::size_t like) {
    for (bool grown = true; grown && !isCutThrough(line.back());) {
      grown = false;
      for (std::size_t i : edges_at_[line.back()]) {
        const int next = otherEnd(i, line.back());
        if (taken_[i] || !pattern_.edges[i].foldsLike(pattern_.edges[like])) continue;
        if (!staysStraight(line, next)) continue;
        taken_[i] = grown = true;
        line.push_back(next);
        break;
      }
    }
  }

  const CreasePattern& pattern_;
  std::vector<bool> taken_;
  std::vector<std::vector<std::size_t>> edges_at_;
  double tolerance_ = 0;
};

}  // namespace

std::vector<PatternCrease> gatherCreases(const CreasePattern& pattern) {
  LineGatherer gatherer(pattern);
  std::vector<PatternCrease> creases;
  std::uint32_t next_id = 0;
  std::set<std::uint32_t> ids;
  for (const NotedCrease& noted : pattern.noted) {
    if (!ids.insert(noted.id).second) reject("two creases have id ", noted.id);
    gatherer.take(noted);
    creases.push_back({noted.id, noted.name, noted.vertices, noted.pattern_angle});
    next_id = std::max(next_id, noted.id + 1);
  }
  for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
    if (gatherer.taken(i)) continue;
    const std::uint32_t id = next_id++;
    creases.push_back(
        {id, "crease_" + std::to_string(id), gatherer.lineThrough(i), pattern.edges[i].angle});
  }
  return creases;
}

}  // namespace shell_origami
