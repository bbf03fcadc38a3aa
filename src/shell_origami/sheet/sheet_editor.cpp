#include <shell_origami/sheet/sheet_editor.h>

#include <shell_origami/base/error.h>
#include <shell_origami/mesh/mesh_refine.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace shell_origami {
namespace {

/// A vertex this close to the line, as a part of the edge that would be cut beside it, is shifted
/// onto the line instead.
constexpr double kClose = 0.3;
/// ... provided that no angle around it falls below this [rad].
constexpr double kLeastAngle = 15 * M_PI / 180;

std::string text(const Vector2& p) {
  std::ostringstream out;
  out << "(" << p.x() << ", " << p.y() << ")";
  return out.str();
}

double offLine(const Vector2& p, const Segment& line) {
  return doubleArea(line[0], line[1], p) / (line[1] - line[0]).norm();
}

bool isBeyond(const Vector2& p, const Segment& line) {
  return (line[1] - line[0]).dot(p - line[1]) > 0;
}

/// Returns the intersection of the line through `line` and the line through a and b.
Vector2 intersection(const Vector2& a, const Vector2& b, const Segment& line) {
  const double sa = offLine(a, line), sb = offLine(b, line);
  return a + sa / (sa - sb) * (b - a);
}

}  // namespace

SheetEditor::SheetEditor(const Sheet& sheet, const EditContext& context)
    : mesh_(sheet.triangulation(), context.positions, context.held, context.exact),
      merged_(std::max(mesh_.snap(), kMergedFeature * sheet.meanEdge())),
      shortest_(kShortestEdge * sheet.meanEdge()),
      creases_(sheet.creases()) {}

bool SheetEditor::shiftTo(int v, const Vector2& p) {
  if (std::count(protected_.begin(), protected_.end(), v)) return false;
  const MaterialMesh::Freedom freedom = mesh_.freedom(v);
  if (freedom.kind == MaterialMesh::Freedom::kFixed || !mesh_.nearlyFlatAround(v)) return false;
  if (freedom.kind == MaterialMesh::Freedom::kSlides &&
      distanceToSegment(p, mesh_.point(freedom.rail[0]), mesh_.point(freedom.rail[1])) >
          1e-12 * mesh_.size()) {
    return false;
  }
  const double least = std::min(kLeastAngle, mesh_.smallestAngle(v, mesh_.point(v)));
  if (mesh_.smallestAngle(v, p) < least) return false;
  mesh_.shift(v, p);
  return true;
}

int SheetEditor::insertPoint(const Vector2& p, const Vector2& ahead) {
  protected_.push_back(vertexAt(p, ahead, mesh_.snap()));
  return protected_.back();
}

int SheetEditor::insertEnd(const Vector2& p, const Vector2& ahead) {
  protected_.push_back(vertexAt(p, ahead, merged_));
  return protected_.back();
}

/// The nearest of the corners that must keep its place and is no farther from p than `tolerance`.
std::optional<int> SheetEditor::fixedCorner(const Triangle& corners, const Vector2& p,
                                            double tolerance) const {
  std::optional<int> nearest;
  double distance = tolerance;
  for (int v : corners) {
    const double d = (mesh_.point(v) - p).norm();
    if (d > distance || mesh_.freedom(v).kind != MaterialMesh::Freedom::kFixed) continue;
    distance = d;
    nearest = v;
  }
  return nearest;
}

int SheetEditor::vertexAt(const Vector2& p, const Vector2& ahead, double tolerance) {
  auto place = mesh_.flat().locateAhead(p, ahead, mesh_.snap());
  if (!place) place = mesh_.flat().locate(p, mesh_.snap());
  if (!place) reject("the point ", text(p), " is off the paper");
  const Triangle corners = mesh_.flat().triangles()[place->triangle];
  for (int v : corners) {
    if ((mesh_.point(v) - p).norm() <= mesh_.snap()) return v;
  }
  if (const auto v = fixedCorner(corners, p, tolerance)) return *v;
  // On an edge, or in the face.
  Triangulation::Side nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const auto [a, b] = mesh_.flat().ends({place->triangle, k});
    const double d = distanceToSegment(p, mesh_.point(a), mesh_.point(b));
    if (d < distance) {
      distance = d;
      nearest = {place->triangle, k};
    }
  }
  const auto [a, b] = mesh_.flat().ends(nearest);
  Vector2 target = p;
  const bool on_edge = distance <= (isFixed(mesh_.flat(), nearest) ? tolerance : mesh_.snap());
  if (on_edge) {
    const Vector2 along = mesh_.point(b) - mesh_.point(a);
    target = mesh_.point(a) + along.dot(p - mesh_.point(a)) / along.squaredNorm() * along;
  }
  const double reach = kClose * (mesh_.point(b) - mesh_.point(a)).norm();
  for (int v : corners) {
    if ((mesh_.point(v) - target).norm() < reach && shiftTo(v, target)) return v;
  }
  if (on_edge) {
    // Beside p the edge may end.
    for (int v : {a, b}) {
      if ((mesh_.point(v) - target).norm() <= tolerance) return v;
    }
    return mesh_.splitEdge(nearest, target);
  }
  return mesh_.splitTriangle(place->triangle, target);
}

bool SheetEditor::coincide(int v, int w) const {
  return (mesh_.point(v) - mesh_.point(w)).norm() <= mesh_.snap();
}

/// The vertex after `current` if an edge already lies on the line.
std::optional<int> SheetEditor::nextOnLine(int current, int to, const Segment& line) const {
  const Vector2 ahead = line[1] - line[0];
  for (int t : mesh_.flat().around(current)) {
    for (int v : mesh_.flat().triangles()[t]) {
      if (v == current || (mesh_.point(v) - mesh_.point(current)).dot(ahead) <= 0) continue;
      if (v == to || std::abs(offLine(mesh_.point(v), line)) <= mesh_.snap()) return v;
    }
  }
  return std::nullopt;
}

/// The side of a triangle at `current` that the line goes through. None where it leaves the paper.
std::optional<Triangulation::Side> SheetEditor::crossedSide(int current,
                                                            const Segment& line) const {
  for (int t : mesh_.flat().around(current)) {
    const Triangulation::Side side{t, mesh_.flat().cornerOf(t, current)};
    const auto [right, left] = mesh_.flat().ends(side);
    if (offLine(mesh_.point(right), line) < 0 && offLine(mesh_.point(left), line) > 0) return side;
  }
  return std::nullopt;
}

/// The vertex where the line, which left the paper at `current`, first meets it again: on the other
/// side of a slit at the same place.
int SheetEditor::reenter(int current, const Segment& line) {
  const Vector2 ahead = line[1] - line[0], here = mesh_.point(current);
  if (mesh_.flat().locateAhead(here, ahead, mesh_.snap())) {
    const int across = insertPoint(here, ahead);
    if (across != current) return across;
  }
  const Vector2 along = ahead.normalized();
  double nearest = std::numeric_limits<double>::infinity();
  Vector2 entry = line[1];
  const auto consider = [&](const Vector2& p) {
    const double distance = along.dot(p - here);
    if (distance <= mesh_.snap() || distance >= nearest) return;
    nearest = distance;
    entry = p;
  };
  const Triangulation& mesh = mesh_.flat();
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.neighbour({t, k}) != Triangulation::kNone) continue;
      const auto [a, b] = mesh.ends({t, k});
      const Vector2 &p = mesh_.point(a), &q = mesh_.point(b);
      const double offset_p = offLine(p, line), offset_q = offLine(q, line);
      if (std::abs(offset_p) <= mesh_.snap()) consider(p);
      if (std::abs(offset_q) <= mesh_.snap()) consider(q);
      if (offset_p * offset_q < 0) consider(intersection(p, q, line));
    }
  }
  return insertPoint(entry, ahead);
}

/// Shifts an end of the crossed edge onto the line if one is close to it.
bool SheetEditor::pullOntoLine(int current, const std::array<int, 2>& ends, const Segment& line) {
  const double length = (mesh_.point(ends[1]) - mesh_.point(ends[0])).norm();
  std::array<int, 2> order = ends;
  if (std::abs(offLine(mesh_.point(ends[1]), line)) <
      std::abs(offLine(mesh_.point(ends[0]), line))) {
    std::swap(order[0], order[1]);
  }
  for (int v : order) {
    const Vector2& p = mesh_.point(v);
    const MaterialMesh::Freedom freedom = mesh_.freedom(v);
    Vector2 foot;
    if (freedom.kind == MaterialMesh::Freedom::kFree) {
      const Vector2 along = (line[1] - line[0]).normalized();
      foot = line[0] + along.dot(p - line[0]) * along;
    } else if (freedom.kind == MaterialMesh::Freedom::kSlides) {
      const Vector2 &a = mesh_.point(freedom.rail[0]), &b = mesh_.point(freedom.rail[1]);
      if (offLine(a, line) * offLine(b, line) >= 0) continue;
      foot = intersection(a, b, line);
    } else {
      continue;
    }
    const bool ahead = (foot - mesh_.point(current)).dot(line[1] - line[0]) > 0;
    if (ahead && (foot - p).norm() < kClose * length && shiftTo(v, foot)) return true;
  }
  return false;
}

std::vector<std::vector<int>> SheetEditor::insertLine(int from, int to) {
  const Segment line{mesh_.point(from), mesh_.point(to)};
  std::vector<std::vector<int>> parts;
  std::vector<int> polyline{from};
  const auto finish = [&] {
    for (auto& part : partsInside(polyline)) parts.push_back(std::move(part));
  };
  // Each turn of the loop brings the line forward by a vertex, pulls one onto it, or splits the
  // edge ahead. Along a slit it may pass by its end, which is a vertex of the other side.
  while (!coincide(polyline.back(), to)) {
    const int current = polyline.back();
    if (const auto next = nextOnLine(current, to, line)) {
      if (*next != to && isBeyond(mesh_.point(*next), line)) break;
      polyline.push_back(*next);
      protected_.push_back(*next);
      continue;
    }
    const auto side = crossedSide(current, line);
    if (!side) {
      finish();
      polyline = {reenter(current, line)};
      continue;
    }
    const auto ends = mesh_.flat().ends(*side);
    if (pullOntoLine(current, ends, line)) continue;
    mesh_.splitEdge(*side, intersection(mesh_.point(ends[0]), mesh_.point(ends[1]), line));
  }
  finish();
  creases_.label(parts, mesh_);
  return parts;
}

/// The runs of edges that have paper on both sides.
std::vector<std::vector<int>> SheetEditor::partsInside(const std::vector<int>& polyline) const {
  std::vector<std::vector<int>> parts;
  bool open = false;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const auto side = mesh_.flat().findSide(polyline[i - 1], polyline[i]);
    if (mesh_.flat().neighbour(*side) == Triangulation::kNone) {
      open = false;
      continue;
    }
    if (!open) parts.push_back({polyline[i - 1]});
    parts.back().push_back(polyline[i]);
    open = true;
  }
  return parts;
}

/// Throws std::invalid_argument if the edit made an edge that is too short to simulate.
void SheetEditor::checkEdges(const Sheet& before, const Sheet& after) const {
  const auto& points = after.flatPositions();
  for (const Edge& edge : after.edges()) {
    const auto [a, b] = edge.vertices;
    const double length = (points[a] - points[b]).norm();
    if (length >= shortest_) continue;
    const bool is_old =
        std::max(a, b) < before.vertexCount() && before.triangulation().findSide(a, b).has_value();
    if (is_old) continue;
    reject("an edge of ", length, " m would be left at ", text(points[a]),
           ", but the shortest possible is ", shortest_, " m (", kShortestEdge,
           " of the mean edge)");
  }
}

namespace {

/// The vertices along the labelled edges from a straight to b.
std::vector<int> chainBetween(const Triangulation& mesh, int a, int b) {
  std::vector<int> chain{a};
  const Vector2 along = (mesh.points()[b] - mesh.points()[a]).normalized();
  while (chain.back() != b) {
    const int current = chain.back();
    int best = b;
    double straightest = -1;
    for (int t : mesh.around(current)) {
      for (int k = 0; k < 3; ++k) {
        const auto [p, q] = mesh.ends({t, k});
        if (mesh.label({t, k}) == Triangulation::kNone || (p != current && q != current)) continue;
        const int far = p == current ? q : p;
        const double straight =
            along.dot((mesh.points()[far] - mesh.points()[current]).normalized());
        if (straight <= straightest) continue;
        straightest = straight;
        best = far;
      }
    }
    chain.push_back(best);
  }
  return chain;
}

}  // namespace

FoldLine SheetEditor::commit(Sheet& sheet, const std::vector<std::vector<int>>& parts,
                             const std::string& name) {
  FoldLine result;
  result.parts = static_cast<int>(parts.size());
  std::vector<Remap::Born> born;
  Sheet edited(mesh_.flat(),
               creases_.gather(mesh_.flat(), parts, name, sheet.nextCreaseId(), born));
  checkEdges(sheet, edited);
  result.remap = traceEdit(sheet, edited, mesh_.snap());
  result.remap.born = std::move(born);
  edited.restore(sheet.revision() + 1, std::max(edited.nextCreaseId(), sheet.nextCreaseId()));
  edited.setLayerOrders(sheet.layerOrders());
  // Of a crease the line is a whole part or nothing, so that the creases on it, laid end to end,
  // are the line's vertices, those that improving added among them.
  const Triangulation& mesh = edited.triangulation();
  for (const std::vector<int>& part : parts) {
    for (std::size_t i = 1; i < part.size(); ++i) {
      const std::vector<int> chain = chainBetween(mesh, part[i - 1], part[i]);
      const int crease = mesh.label(*mesh.findSide(chain[0], chain[1]));
      const std::uint32_t id = edited.creases()[crease].id;
      auto& ids = result.crease_ids;
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
      if (i == 1) result.vertices.push_back(part[0]);
      result.vertices.insert(result.vertices.end(), chain.begin() + 1, chain.end());
    }
  }
  sheet = std::move(edited);
  return result;
}

}  // namespace shell_origami
