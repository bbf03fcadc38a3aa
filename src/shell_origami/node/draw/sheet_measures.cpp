#include <shell_origami/node/draw/sheet_measures.h>

#include <shell_origami/energy/dihedral.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace shell_origami {
namespace {

using EdgeEnds = std::array<std::uint32_t, 2>;  ///< ascending

EdgeEnds ends(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

std::set<EdgeEnds> creaseEdges(const msg::Sheet& sheet) {
  std::set<EdgeEnds> edges;
  for (const msg::Crease& crease : sheet.creases) {
    const auto& line = crease.vertices;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) edges.insert(ends(line[i], line[i + 1]));
  }
  return edges;
}

}  // namespace

double sheetSize(const msg::Sheet& sheet) {
  Eigen::Array2d low = Eigen::Array2d::Constant(HUGE_VAL), high = -low;
  for (const auto& p : sheet.flat_positions) {
    low = low.min(Eigen::Array2d(p.x, p.y));
    high = high.max(Eigen::Array2d(p.x, p.y));
  }
  return (high - low).maxCoeff();
}

SheetMeasures::SheetMeasures(const msg::Sheet& sheet) {
  std::vector<Vector2> flat;
  for (const auto& p : sheet.flat_positions) flat.emplace_back(p.x, p.y);
  for (const auto& triangle : sheet.triangles) {
    const auto& v = triangle.vertex_indices;
    triangles_.push_back({v[0], v[1], v[2]});
    membranes_.emplace_back(std::array<Vector2, 3>{flat[v[0]], flat[v[1]], flat[v[2]]}, Material());
  }
  addBends(sheet, flat);
}

void SheetMeasures::addBends(const msg::Sheet& sheet, const std::vector<Vector2>& flat) {
  struct Side {
    std::uint32_t from, to, apex, triangle;
  };
  std::map<EdgeEnds, std::vector<Side>> sides;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const auto& v = triangles_[i];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      sides[ends(a, b)].push_back({a, b, v[(k + 2) % 3], i});
    }
  }
  for (const EdgeEnds& edge : creaseEdges(sheet)) sides.erase(edge);
  std::vector<BentEdge> edges;
  for (const auto& [both, pair] : sides) {
    if (pair.size() != 2) continue;
    const Side &left = pair[0], &right = pair[1];
    bends_.push_back({left.from, left.to, left.apex, right.apex});
    edges.push_back({flat[left.from],
                     flat[left.to],
                     {flat[left.apex], flat[right.apex]},
                     {static_cast<int>(left.triangle), static_cast<int>(right.triangle)}});
  }
  fit_ = CurvatureFit(static_cast<int>(triangles_.size()), edges);
}

std::vector<double> SheetMeasures::strains(const Positions& x) const {
  std::vector<double> result;
  result.reserve(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& v = triangles_[i];
    const MembraneStrain e = membranes_[i].strain({x.col(v[0]), x.col(v[1]), x.col(v[2])});
    result.push_back(largestPrincipal({e[0], std::sqrt(2.0) * e[2], e[1]}));
  }
  return result;
}

std::vector<double> SheetMeasures::curvatures(const Positions& x) const {
  std::vector<double> angles;
  for (const auto& v : bends_) {
    angles.push_back(foldAngle({x.col(v[0]), x.col(v[1]), x.col(v[2]), x.col(v[3])}).radians);
  }
  std::vector<double> result;
  for (const Curvature& curvature : fit_.curvatures(angles)) {
    result.push_back(largestPrincipal(curvature));
  }
  return result;
}

std::vector<double> SheetMeasures::means(const std::vector<float>& of_vertices) const {
  std::vector<double> result;
  result.reserve(triangles_.size());
  for (const auto& v : triangles_) {
    const double sum = double{of_vertices[v[0]]} + of_vertices[v[1]] + of_vertices[v[2]];
    result.push_back(sum / 3);
  }
  return result;
}

}  // namespace shell_origami
