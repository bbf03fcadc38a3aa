#include <shell_origami/contact/crossings.h>

#include <shell_origami/mesh/intersections.h>

#include <map>
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

}  // namespace shell_origami
