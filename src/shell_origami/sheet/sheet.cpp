#include <shell_origami/sheet/sheet.h>

#include <shell_origami/base/error.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace shell_origami {

void checkCreaseName(const std::string& name) {
  constexpr std::size_t kLongest = 100;
  if (name.empty()) reject("the name of a crease is empty");
  if (name.size() > kLongest) {
    reject("the name of a crease has ", name.size(), " bytes, more than ", kLongest);
  }
  for (const char* group : {"all", "mountains", "valleys"}) {
    if (name == group) reject("a crease cannot be named '", name, "': that is a group of creases");
  }
}

bool inGroup(const Crease& crease, const std::string& group) {
  return (group == "mountains" && crease.pattern_angle < 0) ||
         (group == "valleys" && crease.pattern_angle > 0) ||
         (group == "all" && std::abs(crease.pattern_angle) > 0);
}

Sheet::Sheet(Triangulation triangulation, std::vector<Crease> creases)
    : triangulation_(std::move(triangulation)), creases_(std::move(creases)) {
  if (triangulation_.triangles().empty()) {
    throw std::invalid_argument("a sheet needs at least one triangle");
  }
  for (std::size_t i = 0; i < creases_.size(); ++i) {
    const std::vector<int>& line = creases_[i].vertices;
    for (std::size_t j = 1; j < line.size(); ++j) {
      const auto side = triangulation_.findSide(line[j - 1], line[j]);
      if (!side || triangulation_.neighbour(*side) == Triangulation::kNone) {
        std::ostringstream sentence;
        sentence << "crease " << creases_[i].name << " runs from vertex " << line[j - 1] << " to "
                 << line[j] << ", which is no edge inside the paper";
        throw std::invalid_argument(sentence.str());
      }
      triangulation_.setLabel(*side, static_cast<int>(i));
    }
    next_crease_id_ = std::max(next_crease_id_, creases_[i].id + 1);
  }
  triangulation_.forgetHistory();
  rebuildEdges();
}

void Sheet::restore(std::uint32_t revision, std::uint32_t next_crease_id) {
  if (next_crease_id < next_crease_id_) {
    throw std::invalid_argument("the next crease id " + std::to_string(next_crease_id) +
                                " is one that a crease has");
  }
  revision_ = revision;
  next_crease_id_ = next_crease_id;
}

void Sheet::rebuildEdges() {
  edges_.clear();
  edges_.reserve(3 * triangles().size() / 2 + 64);
  edge_of_side_.assign(triangles().size(), {-1, -1, -1});
  for (int t = 0; t < static_cast<int>(triangles().size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Triangulation::Side side{t, k};
      const int other = triangulation_.neighbour(side);
      if (other != Triangulation::kNone && other < t) continue;
      Edge edge{triangulation_.ends(side),
                {triangulation_.apex(side), -1},
                {t, other},
                triangulation_.label(side)};
      edge_of_side_[t][k] = static_cast<int>(edges_.size());
      if (!edge.onBorder()) {
        const Triangulation::Side across = triangulation_.opposite(side);
        edge.opposite[1] = triangulation_.apex(across);
        edge_of_side_[across.triangle][across.edge] = edge_of_side_[t][k];
      }
      edges_.push_back(edge);
    }
  }
}

double Sheet::meanEdge() const {
  double sum = 0;
  for (const Edge& edge : edges_) {
    sum += (flatPositions()[edge.vertices[0]] - flatPositions()[edge.vertices[1]]).norm();
  }
  return sum / static_cast<double>(edges_.size());
}

double Sheet::size() const {
  Eigen::AlignedBox2d box;
  for (const Vector2& p : flatPositions()) box.extend(p);
  return box.sizes().maxCoeff();
}

double Sheet::area() const {
  double doubled = 0;
  for (const Triangle& t : triangles()) {
    doubled += doubleArea(flatPositions()[t[0]], flatPositions()[t[1]], flatPositions()[t[2]]);
  }
  return doubled / 2;
}

int Sheet::creaseIndex(std::uint32_t id) const {
  const auto found = std::find_if(creases_.begin(), creases_.end(),
                                  [id](const Crease& crease) { return crease.id == id; });
  return found == creases_.end() ? -1 : static_cast<int>(found - creases_.begin());
}

int Sheet::nearestVertex(const Vector2& p) const {
  const auto& points = flatPositions();
  const auto nearest =
      std::min_element(points.begin(), points.end(), [&p](const Vector2& a, const Vector2& b) {
        return (a - p).squaredNorm() < (b - p).squaredNorm();
      });
  return static_cast<int>(nearest - points.begin());
}

namespace {

[[noreturn]] void broken(const std::string& what) { throw std::logic_error("sheet: " + what); }

void validateTriangulation(const Triangulation& mesh) {
  // Building it anew checks indices, orientation and that it is a manifold.
  const Triangulation again(mesh.points(), mesh.triangles());
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (again.neighbour({t, k}) != mesh.neighbour({t, k})) broken("a neighbour is wrong");
      if (mesh.neighbour({t, k}) == Triangulation::kNone) continue;
      if (mesh.label({t, k}) != mesh.label(mesh.opposite({t, k}))) broken("a label is one-sided");
    }
  }
  for (int v = 0; v < static_cast<int>(mesh.points().size()); ++v) {
    double angle = 0;
    const std::vector<int> fan = mesh.around(v);
    for (int t : fan) {
      const int k = mesh.cornerOf(t, v);
      const Triangle& corners = mesh.triangles()[t];
      if (corners[k] != v) broken("a vertex does not know its triangle");
      const Vector2 a = mesh.points()[corners[(k + 1) % 3]] - mesh.points()[v];
      const Vector2 b = mesh.points()[corners[(k + 2) % 3]] - mesh.points()[v];
      angle += std::atan2(cross(a, b), a.dot(b));
    }
    const double full = 2 * M_PI;
    if (mesh.onBorder(v) ? angle > full + 1e-9 : std::abs(angle - full) > 1e-9) {
      broken("triangles overlap around a vertex");
    }
  }
}

void validateCrease(const Crease& crease, int index, const Sheet& sheet) {
  if (crease.vertices.size() < 2) broken("crease " + crease.name + " has no edge");
  const auto& points = sheet.flatPositions();
  const Vector2 &from = points[crease.vertices.front()], &to = points[crease.vertices.back()];
  for (std::size_t j = 1; j < crease.vertices.size(); ++j) {
    const int a = crease.vertices[j - 1], b = crease.vertices[j];
    const auto side = sheet.triangulation().findSide(a, b);
    if (!side) broken("crease " + crease.name + " leaves the edges");
    if (sheet.triangulation().label(*side) != index) {
      broken("crease " + crease.name + " is not labelled");
    }
    if ((to - from).dot(points[b] - points[a]) <= 0) broken(crease.name + " turns back");
    if (std::abs(cross(to - from, points[b] - from)) > 1e-6 * (to - from).norm() * sheet.size()) {
      broken("crease " + crease.name + " is not straight");
    }
  }
}

}  // namespace

void Sheet::validate() const {
  validateTriangulation(triangulation_);
  std::map<int, std::size_t> labelled;
  for (const Edge& edge : edges_) {
    if (edge.crease >= 0) ++labelled[edge.crease];
    if (edge.crease >= 0 && edge.onBorder()) broken("a crease runs along the border");
  }
  std::size_t total = 0;
  std::map<std::uint32_t, int> ids;
  for (std::size_t i = 0; i < creases_.size(); ++i) {
    validateCrease(creases_[i], static_cast<int>(i), *this);
    if (labelled[static_cast<int>(i)] != creases_[i].vertices.size() - 1) {
      broken("crease " + creases_[i].name + " has edges that are not on its line");
    }
    if (++ids[creases_[i].id] > 1) broken("two creases have one id");
    if (creases_[i].id >= next_crease_id_) broken("a crease id may be reused");
    total += creases_[i].vertices.size() - 1;
  }
  std::size_t marked = 0;
  for (const auto& [crease, count] : labelled) marked += count;
  if (marked != total) broken("an edge is labelled with a crease that is not there");
}

}  // namespace shell_origami
