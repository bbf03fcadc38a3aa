#include <shell_origami/mesh/cuts.h>

#include <shell_origami/base/error.h>
#include <shell_origami/mesh/mesh_refine.h>

#include <algorithm>

namespace shell_origami {
namespace {

using Side = Triangulation::Side;

constexpr int kCut = 0;  ///< the label of a cut

/// The edge at which the triangle of a fan begins, counter-clockwise around v.
Side firstSide(const Triangulation& mesh, int triangle, int v) {
  return {triangle, (mesh.cornerOf(triangle, v) + 2) % 3};
}

/// Whether the triangles around v fall apart.
bool fallsApart(const Triangulation& mesh, int v) {
  const std::vector<int> fan = mesh.around(v);
  return std::count_if(fan.begin(), fan.end(),
                       [&](int t) { return isFixed(mesh, firstSide(mesh, t, v)); }) > 1;
}

void labelCut(Triangulation& mesh, const std::vector<int>& chain) {
  for (std::size_t k = 1; k < chain.size(); ++k) {
    mesh.setLabel(*mesh.findSide(chain[k - 1], chain[k]), kCut);
  }
}

/// The triangles with their corners renumbered, each part of the fan around a vertex its own.
std::vector<Triangle> partFans(const Triangulation& mesh, std::vector<Vector2>& points,
                               std::vector<std::array<int, 2>>& sources) {
  std::vector<Triangle> triangles = mesh.triangles();
  for (int v = 0; v < static_cast<int>(mesh.points().size()); ++v) {
    const auto begins = [&](int t) { return isFixed(mesh, firstSide(mesh, t, v)); };
    std::vector<int> fan = mesh.around(v);
    const auto first = std::find_if(fan.begin(), fan.end(), begins);
    if (first == fan.end()) continue;
    std::rotate(fan.begin(), first, fan.end());
    int own = v;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      if (i > 0 && begins(fan[i])) {
        own = static_cast<int>(points.size());
        points.push_back(points[v]);
        sources.push_back(sources[v]);
      }
      triangles[fan[i]][mesh.cornerOf(fan[i], v)] = own;
    }
  }
  return triangles;
}

/// The chain's vertices after its triangles were renumbered.
std::vector<int> renumbered(const std::vector<int>& chain, const Triangulation& before,
                            const std::vector<Triangle>& triangles) {
  std::vector<int> result;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    // An end may be doubled, and the edge tells which of its doubles is meant.
    const Side side = *before.findSide(chain[k], chain[k == 0 ? 1 : k - 1]);
    result.push_back(triangles[side.triangle][before.cornerOf(side.triangle, chain[k])]);
  }
  return result;
}

int countPieces(const Triangulation& mesh) {
  int pieces = 0;
  std::vector<bool> reached(mesh.triangles().size());
  for (std::size_t start = 0; start < reached.size(); ++start) {
    if (reached[start]) continue;
    ++pieces;
    reached[start] = true;
    std::vector<int> stack{static_cast<int>(start)};
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int other = mesh.neighbour({t, k});
        if (other == Triangulation::kNone || reached[other]) continue;
        reached[other] = true;
        stack.push_back(other);
      }
    }
  }
  return pieces;
}

}  // namespace

std::vector<std::array<int, 2>> openCuts(GraphMesh& mesh, const std::vector<std::size_t>& cuts) {
  Triangulation shut = mesh.triangulation;
  std::vector<std::array<int, 2>> sources;
  for (int v = 0; v < static_cast<int>(shut.points().size()); ++v) sources.push_back({v, v});
  for (std::size_t cut : cuts) labelCut(shut, mesh.chains[cut]);
  for (std::size_t cut : cuts) {
    const int a = mesh.chains[cut].front(), b = mesh.chains[cut].back();
    if (mesh.chains[cut].size() > 2 || fallsApart(shut, a) || fallsApart(shut, b)) continue;
    const Vector2 middle = (shut.points()[a] + shut.points()[b]) / 2;
    shut.splitEdge(*shut.findSide(a, b), middle);
    sources.push_back({a, b});
  }
  std::vector<Vector2> points = shut.points();
  const std::vector<Triangle> triangles = partFans(shut, points, sources);
  for (std::vector<int>& chain : mesh.chains) {
    if (shut.findSide(chain[0], chain[1])) chain = renumbered(chain, shut, triangles);
  }
  mesh.triangulation = Triangulation(std::move(points), triangles);
  const int pieces = countPieces(mesh.triangulation);
  if (pieces > 1) reject("its cuts part the paper into ", pieces, " pieces, but a sheet is one");
  return sources;
}

}  // namespace shell_origami
