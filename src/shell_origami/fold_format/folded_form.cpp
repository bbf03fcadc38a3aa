#include <shell_origami/fold_format/folded_form.h>

#include <shell_origami/base/error.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace shell_origami {
namespace {

/// A folded form that stretches an edge by more than this is not one of its pattern.
constexpr double kMostStretch = 1.25;
/// Edges that are stretched alike to this part share one scale.
constexpr double kSameScale = 0.01;
/// Paper folded beyond this lies on itself: the solver cannot start from there [rad].
constexpr double kFoldedFlat = 179.9 / 180 * M_PI;
/// Distance over the size of the sheet by which rounding may move a vertex off another mesh of it.
constexpr double kRounding = 1e-9;

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

/// Returns the length of each edge in space over its flat length.
std::vector<double> stretches(const Sheet& sheet, const Positions& positions) {
  std::vector<double> values;
  for (const Edge& edge : sheet.edges()) {
    const auto [a, b] = edge.vertices;
    values.push_back((positions.col(a) - positions.col(b)).norm() /
                     (sheet.flatPositions()[a] - sheet.flatPositions()[b]).norm());
  }
  return values;
}

void checkStretch(const Sheet& sheet, const Positions& positions, const std::string& frame) {
  for (const double stretch : stretches(sheet, positions)) {
    if (stretch <= kMostStretch && stretch >= 1 / kMostStretch) continue;
    reject(frame, " is no folded form of the pattern: an edge is ", stretch,
           " times as long as on the flat sheet (form: flat passes over it)");
  }
}

/// Some programs draw the folded form at another scale than the pattern. Undoes a scale that all
/// edges share.
void undoScale(const Sheet& sheet, Positions& positions) {
  const std::vector<double> values = stretches(sheet, positions);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double scale = (*least + *most) / 2;
  if (!(*most - *least <= kSameScale * scale) || std::abs(scale - 1) <= kSameScale) return;
  positions /= scale;
}

/// Whether a frame shows the pattern of another: it descends from it, or has the same mesh, as the
/// frames of a film do.
bool belongsTo(const FoldDocument& document, int frame, int pattern_frame) {
  if (document.descendsFrom(frame, pattern_frame)) return true;
  return document.has(frame, "edges_vertices") == document.has(pattern_frame, "edges_vertices") &&
         document.sharesMesh(frame, pattern_frame);
}

/// The last folded form of the pattern with vertices of its own; -1 where there is none.
int findFoldedForm(const FoldDocument& document, int pattern_frame) {
  for (int frame = document.frameCount() - 1; frame >= 0; --frame) {
    if (frame != pattern_frame && document.hasClass(frame, "foldedForm") &&
        document.hasOwn(frame, "vertices_coords") && belongsTo(document, frame, pattern_frame)) {
      return frame;
    }
  }
  return -1;
}

/// Returns the form's positions [m] for a sheet with the file's own vertices.
Positions ownPositions(const FoldDocument& document, int frame, const PatternPlane& plane,
                       double metres, const PatternSheet& own) {
  const std::vector<Vector3> points = document.points(frame);
  Positions positions(3, own.sheet.vertexCount());
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    const auto [a, b] = own.file_vertices[v];
    if (static_cast<std::size_t>(std::max(a, b)) >= points.size()) {
      reject(FoldDocument::frameName(frame), " has ", points.size(),
             " vertices, fewer than the pattern");
    }
    positions.col(v) = metres * plane.apply(a == b ? points[a] : (points[a] + points[b]) / 2);
  }
  return positions;
}

bool isFoldedFlat(const Sheet& sheet, const Positions& positions) {
  return std::any_of(sheet.edges().begin(), sheet.edges().end(), [&](const Edge& edge) {
    return !edge.onBorder() && std::abs(angleInSpace(sheet, positions, edge)) > kFoldedFlat;
  });
}

/// Positions of a sheet that covers the same paper as another: each vertex at its place in the
/// other's triangles.
Positions carryOver(const Sheet& from, const Positions& positions, const Sheet& to) {
  const Triangulation &source = from.triangulation(), &target = to.triangulation();
  const double tolerance = kRounding * from.size();
  Positions carried(3, to.vertexCount());
  for (int v = 0, near = 0; v < to.vertexCount(); ++v) {
    const Vector2& p = to.flatPositions()[v];
    // On a slit its own triangles tell on which side a vertex is.
    const Vector2 inside = target.centroid(target.around(v)[0]) - p;
    auto place = target.onBorder(v) ? source.locateAhead(p, inside, tolerance) : std::nullopt;
    if (!place) place = source.locateNear(p, tolerance, near);
    const Triangle& corners = from.triangles()[place.value().triangle];
    carried.col(v).setZero();
    for (int k = 0; k < 3; ++k) carried.col(v) += place->weights[k] * positions.col(corners[k]);
    near = place->triangle;
  }
  return carried;
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

}  // namespace

void readFoldedForm(const FoldDocument& document, const CreasePattern& pattern, double metres,
                    const PatternSheet& made, FoldPaper& paper) {
  const int frame = findFoldedForm(document, pattern.frame);
  if (frame < 0) return;
  const std::string name = FoldDocument::frameName(frame);
  const auto& numbers = pattern.file_vertices;
  if (std::count(numbers.begin(), numbers.end(), -1) > 0) {
    paper.notes.push_back(name + " was passed over: it has no vertices where edges cross");
    return;
  }
  const bool is_own = !made.file_vertices.empty();
  const PatternSheet own = is_own ? made : makeSheet(pattern, 0);
  Positions positions = ownPositions(document, frame, pattern.plane, metres, own);
  undoScale(own.sheet, positions);
  checkStretch(own.sheet, positions, name);
  if (isFoldedFlat(own.sheet, positions)) return;
  if (!is_own) {
    positions = carryOver(own.sheet, positions, paper.sheet);
    checkStretch(paper.sheet, positions, name);
  }
  paper.rest_angles = meanAngles(paper.sheet, positions);
  for (std::size_t i = 0; i < paper.rest_angles.size(); ++i) {
    const double asked = i < pattern.noted.size() ? pattern.noted[i].rest_angle
                                                  : paper.sheet.creases()[i].pattern_angle;
    if (i < pattern.noted.size() || std::isnan(asked)) paper.rest_angles[i] = asked;
  }
  paper.positions = std::move(positions);
}

}  // namespace shell_origami
