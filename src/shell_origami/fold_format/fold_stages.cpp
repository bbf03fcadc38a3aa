#include <shell_origami/fold_format/fold_stages.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace shell_origami {
namespace {

/// Distance over the size of the sheet by which an edge of a frame may stand off its crease.
constexpr double kOff = 1e-5;

/// An edge of a frame that its frame calls a crease.
struct FrameEdge {
  Segment line;  ///< on the flat sheet [m]
  double angle;  ///< [rad]; NaN: the frame leaves it open
};

/// The flat positions of a frame's vertices [m].
/// \throws std::invalid_argument where it neither states them nor has the pattern's mesh
std::vector<Vector2> flatPoints(const FoldDocument& document, const CreasePattern& pattern,
                                double metres, int frame) {
  std::vector<Vector3> points = document.flatCoordinates(frame);
  if (points.empty()) {
    if (!document.has(frame, "edges_vertices") || !document.sharesMesh(frame, pattern.frame)) {
      reject("its mesh is not the pattern's, and it states no ", kFlatCoordinates);
    }
    points = document.points(pattern.frame);
  }
  std::vector<Vector2> flat;
  for (const Vector3& p : points) flat.emplace_back(metres * pattern.plane.apply(p).head<2>());
  return flat;
}

std::vector<FrameEdge> creaseEdges(const FoldDocument& document, const CreasePattern& pattern,
                                   double metres, int frame) {
  if (!document.hasOwn(frame, "edges_foldAngle")) reject("it has no edges_foldAngle of its own");
  const std::vector<Vector2> flat = flatPoints(document, pattern, metres, frame);
  const auto edges = document.edges(frame, static_cast<int>(flat.size()));
  const std::string kinds = document.assignments(frame, edges.size());
  const std::vector<double> angles = document.foldAngles(frame, edges.size());
  std::vector<FrameEdge> creases;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_crease =
        kinds.empty() ? angles[i] != 0 : kinds[i] == 'M' || kinds[i] == 'V' || kinds[i] == 'U';
    if (is_crease) creases.push_back({{flat[edges[i][0]], flat[edges[i][1]]}, angles[i]});
  }
  return creases;
}

/// The mean angle of a frame's edges along a polyline of the flat sheet [rad]: 0 where it has none,
/// as before a crease is made.
double angleAlong(const std::vector<Vector2>& polyline, const std::vector<FrameEdge>& edges,
                  double tolerance) {
  double sum = 0, length = 0;
  for (std::size_t k = 1; k < polyline.size(); ++k) {
    const Vector2& from = polyline[k - 1];
    const Vector2 way = polyline[k] - from;
    const Vector2 along = way.normalized();
    for (const FrameEdge& edge : edges) {
      const Vector2 a = edge.line[0] - from, b = edge.line[1] - from;
      if (std::max(std::abs(cross(along, a)), std::abs(cross(along, b))) > tolerance) continue;
      const auto [low, high] = std::minmax({along.dot(a), along.dot(b)});
      const double common = std::min(high, way.norm()) - std::max(low, 0.0);
      if (common <= tolerance) continue;
      sum += common * edge.angle;
      length += common;
    }
  }
  return length > 0 ? sum / length : 0;
}

FoldStage readStage(const FoldDocument& document, const CreasePattern& pattern, double metres,
                    const Sheet& sheet, int frame) {
  const std::vector<FrameEdge> edges = creaseEdges(document, pattern, metres, frame);
  FoldStage stage;
  for (const Crease& crease : sheet.creases()) {
    std::vector<Vector2> polyline;
    for (int v : crease.vertices) polyline.push_back(sheet.flatPositions()[v]);
    stage.push_back(angleAlong(polyline, edges, kOff * sheet.size()));
  }
  return stage;
}

}  // namespace

std::vector<FoldStage> readStages(const FoldDocument& document, const CreasePattern& pattern,
                                  double metres, FoldPaper& paper) {
  std::vector<FoldStage> stages;
  if (!document.isOfClass("diagrams")) return stages;
  for (int frame = 0; frame < document.frameCount(); ++frame) {
    if (frame == pattern.frame) continue;
    try {
      stages.push_back(readStage(document, pattern, metres, paper.sheet, frame));
    } catch (const std::invalid_argument& error) {
      paper.notes.push_back(FoldDocument::frameName(frame) + " was passed over: " + error.what());
    }
  }
  return stages;
}

}  // namespace shell_origami
