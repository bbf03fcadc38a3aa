#include <shell_origami/contact/crossings.h>

#include <shell_origami/mesh/intersections.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace shell_origami {

std::vector<TrianglePair> crossings(const Sheet& sheet, const Positions& positions) {
  std::vector<int> names(sheet.vertexCount());
  std::map<std::pair<double, double>, int> first;
  for (int v = 0; v < sheet.vertexCount(); ++v) {
    const Vector2& p = sheet.flatPositions()[v];
    names[v] = first.emplace(std::make_pair(p.x(), p.y()), v).first->second;
  }
  return intersections(positions, sheet.triangles(), names);
}

int cutTriangle(const Sheet& sheet, const Positions& positions, const Surface& body,
                const Positions& places) {
  const auto& triangles = sheet.triangles();
  if (body.half_space) {
    const Vector3 origin = places.col(0);
    const Vector3 up = (places.col(1) - origin).cross(places.col(2) - origin);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (int v : triangles[t]) {
        if (up.dot(positions.col(v) - origin) <= 0) return static_cast<int>(t);
      }
    }
    return -1;
  }
  const int sheet_vertices = sheet.vertexCount();
  Positions all(3, sheet_vertices + places.cols());
  all << positions.leftCols(sheet_vertices), places;
  std::vector<int> names(all.cols());
  std::iota(names.begin(), names.end(), 0);
  std::vector<Triangle> both = triangles;
  for (Triangle t : body.faces) {
    for (int& v : t) v += sheet_vertices;
    both.push_back(t);
  }
  const int count = static_cast<int>(triangles.size());
  for (const auto& [f, g] : intersections(all, both, names)) {
    if (f < count && g >= count) return f;
  }
  const Surface placed{places, body.faces};
  for (int t = 0; t < count; ++t) {
    if (contains(placed, positions.col(triangles[t][0]))) return t;
  }
  return -1;
}

}  // namespace shell_origami
