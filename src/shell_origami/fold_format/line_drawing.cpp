#include <shell_origami/fold_format/line_drawing.h>

#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/planarize.h>

#include <map>
#include <utility>

namespace shell_origami {
namespace {

constexpr std::size_t kMostLines = 100000;
constexpr double kMostCoordinate = 1e100;

}  // namespace

void LineDrawing::add(DrawnLine line) {
  for (const Vector2& end : {line.from, line.to}) {
    if (!(end.cwiseAbs().maxCoeff() < kMostCoordinate)) {
      reject(line.place, " has a coordinate that is not below 1e100");
    }
  }
  if (lines.size() == kMostLines) reject("holds more than ", kMostLines, " lines");
  lines.push_back(std::move(line));
}

CreasePattern patternOf(LineDrawing drawing, bool keep_flat_edges) {
  if (drawing.lines.empty()) reject("holds no lines of a crease pattern");
  CreasePattern pattern;
  pattern.notes = std::move(drawing.notes);
  std::map<std::pair<double, double>, int> vertices;
  const auto vertexAt = [&](const Vector2& p) {
    const int next = static_cast<int>(pattern.points.size());
    const auto [at, is_new] = vertices.emplace(std::make_pair(p.x(), p.y()), next);
    if (is_new) pattern.points.emplace_back(p.x(), -p.y());
    return at->second;
  };
  for (DrawnLine& line : drawing.lines) {
    const int number = static_cast<int>(pattern.places.size());
    const int from = vertexAt(line.from), to = vertexAt(line.to);
    pattern.edges.push_back({{from, to}, line.kind, line.angle, number});
    pattern.places.push_back(std::move(line.place));
  }
  pattern.file_vertices.assign(pattern.points.size(), -1);
  makePlanar(pattern, keep_flat_edges);
  dropUnused(pattern, true);
  const Vector2 corner = lowerLeft(pattern.points);
  for (Vector2& p : pattern.points) p -= corner;
  return pattern;
}

}  // namespace shell_origami
