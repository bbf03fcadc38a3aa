#include "sheet/crease_pattern.h"
#include "sheet/fold_file.h"
#include "sheet/refuse.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace shell_origami {
namespace {

/// A folded form that stretches an edge by more than this is not one of its pattern.
constexpr double kMostStretch = 1.25;
/// Paper folded beyond this lies on itself: the solver cannot start from there [rad].
constexpr double kFoldedFlat = 179.9 / 180 * M_PI;

double metresPerUnit(const FoldDocument& document, int frame, double scale) {
  if (scale != 0) {
    if (!(scale > 0) || !std::isfinite(scale)) {
      refuse("scale is ", scale, ", but must be positive and finite");
    }
    return scale;
  }
  static const std::map<std::string, double> metres{
      {"m", 1},    {"cm", 1e-2},     {"mm", 1e-3},         {"um", 1e-6},
      {"nm", 1e-9}, {"in", 0.0254}, {"pt", 0.0254 / 72}};
  const std::string unit = document.unit(frame);
  const auto found = metres.find(unit);
  if (found == metres.end()) {
    refuse("states no physical unit (frame_unit is \"", unit,
           "\"): give a scale in metres per unit");
  }
  return found->second;
}

/// The file's own triangles. \throws std::invalid_argument when they overlap or leave gaps
GraphMesh keepTriangles(const CreasePattern& pattern, const Outline& outline) {
  std::vector<Triangle> triangles;
  double area = 0;
  for (const auto& face : pattern.faces) {
    triangles.push_back({face[0], face[1], face[2]});
    area += doubleArea(pattern.points[face[0]], pattern.points[face[1]],
                       pattern.points[face[2]]) / 2;
  }
  // Counter-clockwise triangles inside a simple outline cover it once exactly when areas agree.
  if (!(std::abs(area - outline.area()) <= 1e-6 * area)) {
    refuse("faces overlap: together they have ", area / outline.area(),
           " times the area inside the outline");
  }
  GraphMesh result{Triangulation(pattern.points, triangles), {}};
  for (const PatternEdge& edge : pattern.edges) {
    result.chains.push_back({edge.vertices[0], edge.vertices[1]});
  }
  return result;
}

GraphMesh meshPattern(const CreasePattern& pattern, double max_edge) {
  const Outline outline = traceOutline(pattern);
  if (max_edge == 0 && pattern.hasOnlyTriangles()) return keepTriangles(pattern, outline);
  checkEdges(pattern, outline);
  PlanarGraph graph;
  graph.points = pattern.points;
  for (const PatternEdge& edge : pattern.edges) graph.segments.push_back(edge.vertices);
  for (const auto& hole : outline.holes) graph.holes.push_back(pointInside(hole));
  return meshGraph(graph, max_edge);
}

/// The creases as polylines of the mesh's vertices.
std::vector<Crease> meshCreases(const CreasePattern& pattern, const GraphMesh& mesh,
                                const std::vector<PatternCrease>& lines) {
  std::map<std::pair<int, int>, std::size_t> edge_at;
  for (std::size_t i = 0; i < pattern.edges.size(); ++i) {
    const auto [a, b] = pattern.edges[i].vertices;
    edge_at[{a, b}] = edge_at[{b, a}] = i;
  }
  std::vector<Crease> creases;
  for (const PatternCrease& line : lines) {
    Crease crease{line.id, line.name, {line.vertices.front()}, line.angle};
    for (std::size_t k = 1; k < line.vertices.size(); ++k) {
      std::vector<int> chain = mesh.chains[edge_at.at({line.vertices[k - 1], line.vertices[k]})];
      if (chain.front() != crease.vertices.back()) std::reverse(chain.begin(), chain.end());
      crease.vertices.insert(crease.vertices.end(), chain.begin() + 1, chain.end());
    }
    creases.push_back(std::move(crease));
  }
  return creases;
}

/// The last folded form with vertices of its own: of a film, the end.
int findFoldedForm(const FoldDocument& document, int pattern_frame) {
  for (int frame = document.frameCount() - 1; frame >= 0; --frame) {
    if (frame != pattern_frame && document.hasClass(frame, "foldedForm") &&
        document.hasOwn(frame, "vertices_coords")) {
      return frame;
    }
  }
  return -1;
}

/// Fold angle of an inner edge in space [rad], valley > 0.
double angleInSpace(const Sheet& sheet, const Positions& positions, const Edge& edge) {
  const auto normal = [&](int triangle) -> Vector3 {
    const auto [a, b, c] = sheet.triangles()[triangle];
    const Vector3 o = positions.col(a);
    return (positions.col(b) - o).cross(positions.col(c) - o).normalized();
  };
  const Vector3 left = normal(edge.triangles[0]), right = normal(edge.triangles[1]);
  const Vector3 along =
      (positions.col(edge.vertices[1]) - positions.col(edge.vertices[0])).normalized();
  return std::atan2(right.cross(left).dot(along), left.dot(right));
}

void checkStretch(const Sheet& sheet, const Positions& positions, const std::string& frame) {
  for (const Edge& edge : sheet.edges()) {
    const auto [a, b] = edge.vertices;
    const double stretch = (positions.col(a) - positions.col(b)).norm() /
                           (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm();
    if (stretch <= kMostStretch && stretch >= 1 / kMostStretch) continue;
    refuse(frame, " is no folded form of the pattern: an edge is ", stretch,
           " times as long as on the flat sheet");
  }
}

/// Each crease's mean fold angle in space.
std::vector<double> meanAngles(const Sheet& sheet, const Positions& positions) {
  std::vector<double> sums(sheet.creases().size()), lengths(sheet.creases().size());
  for (const Edge& edge : sheet.edges()) {
    if (edge.crease < 0) continue;
    const auto [a, b] = edge.vertices;
    const double length = (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm();
    sums[edge.crease] += length * angleInSpace(sheet, positions, edge);
    lengths[edge.crease] += length;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= lengths[i];
  return sums;
}

/// Puts the paper where the file has it in space, unless it lies folded flat there.
void readFoldedForm(const FoldDocument& document, const CreasePattern& pattern, double metres,
                    FoldPaper& paper) {
  const int frame = findFoldedForm(document, pattern.frame);
  if (frame < 0) return;
  const std::string name = FoldDocument::frameName(frame);
  const std::vector<Vector3> points = document.points(frame);
  Positions positions(3, paper.sheet.vertexCount());
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    const std::size_t file_vertex = pattern.file_vertices[v];
    if (file_vertex >= points.size()) {
      refuse(name, " has ", points.size(), " vertices, fewer than the pattern");
    }
    positions.col(v) = metres * pattern.plane.apply(points[file_vertex]);
  }
  checkStretch(paper.sheet, positions, name);
  for (const Edge& edge : paper.sheet.edges()) {
    if (edge.onBorder()) continue;
    if (std::abs(angleInSpace(paper.sheet, positions, edge)) > kFoldedFlat) return;
  }
  paper.rest_angles = meanAngles(paper.sheet, positions);
  for (std::size_t i = 0; i < paper.rest_angles.size(); ++i) {
    const double asked = paper.sheet.creases()[i].pattern_angle;
    if (i < pattern.noted.size() || std::isnan(asked)) paper.rest_angles[i] = asked;
  }
  paper.positions = std::move(positions);
}

FoldPaper readDocument(const FoldDocument& document, const FoldReadOptions& options) {
  CreasePattern pattern = readPattern(document);
  const double metres = metresPerUnit(document, pattern.frame, options.scale);
  dropUnused(pattern, options.max_edge == 0);
  for (Vector2& p : pattern.points) p *= metres;

  const GraphMesh mesh = meshPattern(pattern, options.max_edge);
  const std::vector<PatternCrease> lines = gatherCreases(pattern);
  FoldPaper paper{Sheet(mesh.triangulation, meshCreases(pattern, mesh, lines)), {}, {}};
  paper.sheet.validate();
  if (options.max_edge == 0) readFoldedForm(document, pattern, metres, paper);
  return paper;
}

}  // namespace

FoldPaper readFold(const std::string& path, const FoldReadOptions& options) {
  try {
    return readDocument(FoldDocument(path), options);
  } catch (const std::exception& error) {
    // Whatever is wrong with a file is the file's fault, a broken sheet (std::logic_error) too.
    refuse(path, ": ", error.what());
  }
}

}  // namespace shell_origami
