/// \file
/// Square papers whose pattern is drawn on a lattice, with slits or without.
#pragma once

#include "test/fold_format/fold_samples.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace shell_origami {

constexpr int kCells = 4;

inline int at(int x, int y) { return x + (kCells + 1) * y; }

enum class Faces { kNone, kQuads, kTriangles };

/// A square of 4 x 4 unit cells: lines of its lattice are cut, folded or flat.
class Lattice {
 public:
  /// Assigns the edges from one lattice point straight on to another.
  Lattice& line(std::array<int, 2> from, std::array<int, 2> to, char kind) {
    const int dx = (to[0] > from[0]) - (to[0] < from[0]);
    const int dy = (to[1] > from[1]) - (to[1] < from[1]);
    for (; from != to; from = {from[0] + dx, from[1] + dy}) {
      const int a = at(from[0], from[1]), b = at(from[0] + dx, from[1] + dy);
      kinds_[std::minmax(a, b)] = kind;
    }
    return *this;
  }

  json document(Faces faces) const {
    json result{{"vertices_coords", json::array()},
                {"edges_vertices", json::array()},
                {"edges_assignment", json::array()}};
    for (int y = 0; y <= kCells; ++y) {
      for (int x = 0; x <= kCells; ++x) result["vertices_coords"].push_back({x, y});
    }
    Lattice whole = *this;
    whole.line({0, 0}, {kCells, 0}, 'B').line({kCells, 0}, {kCells, kCells}, 'B');
    whole.line({0, kCells}, {kCells, kCells}, 'B').line({0, 0}, {0, kCells}, 'B');
    for (const auto& [ends, kind] : whole.kinds_) {
      result["edges_vertices"].push_back({ends.first, ends.second});
      result["edges_assignment"].push_back(std::string(1, kind));
    }
    for (int y = 0; y < kCells && faces != Faces::kNone; ++y) {
      for (int x = 0; x < kCells; ++x) {
        const int a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
        if (faces == Faces::kQuads) result["faces_vertices"].push_back({a, b, c, d});
        if (faces == Faces::kQuads) continue;
        result["faces_vertices"].push_back({a, b, c});
        result["faces_vertices"].push_back({a, c, d});
      }
    }
    return result;
  }

 private:
  std::map<std::pair<int, int>, char> kinds_;
};

inline Lattice insideSlit() { return Lattice().line({1, 2}, {3, 2}, 'C'); }
inline Lattice borderSlit() { return Lattice().line({0, 2}, {2, 2}, 'C'); }
inline Lattice crossOfSlits() { return insideSlit().line({2, 1}, {2, 3}, 'C'); }

inline double length(const Sheet& sheet, const Edge& edge) {
  const auto [a, b] = edge.vertices;
  return (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm();
}

inline double creaseLength(const Sheet& sheet) {
  double sum = 0;
  for (const Edge& edge : sheet.edges()) sum += edge.crease < 0 ? 0 : length(sheet, edge);
  return sum;
}

}  // namespace shell_origami
