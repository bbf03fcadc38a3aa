/// \file
/// A crease pattern in the plane: outline, holes, straight creases.
#pragma once

#include <shell_origami/fold_format/fold_document.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/sheet/sheet.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

/// The plane of the flat pattern in the space of its file.
struct PatternPlane {
  Vector3 origin = Vector3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rows: x, y and up of the flat sheet

  Vector3 apply(const Vector3& p) const { return axes * (p - origin); }
};

struct PatternEdge {
  std::array<int, 2> vertices;
  char kind;     ///< one of BCMVUFJ; a cut (C) has paper on both sides
  double angle;  ///< what the file asks for [rad]; NaN: nothing
  int number;    ///< of the edge or line in the file; -1: only a side of a face

  bool isCrease() const { return kind == 'M' || kind == 'V' || kind == 'U'; }
  bool isBorder() const { return kind == 'B'; }
  bool isCut() const { return kind == 'C'; }
  bool isFlat() const { return kind == 'F' || kind == 'J'; }
  /// Whether it is of the same kind and asks for the same angle.
  bool foldsLike(const PatternEdge& other) const;
};

/// A straight line of edges of one kind and angle.
struct PatternCrease {
  std::uint32_t id;
  std::string name;
  std::vector<int> vertices;
  double angle;  ///< what the pattern asks of it [rad]; NaN: nothing
};

/// The flat sheet of a file. Vertices are numbered as in a FOLD file until dropUnused().
struct CreasePattern {
  int frame = 0;  ///< of a FOLD file
  PatternPlane plane;
  std::vector<Vector2> points;          ///< in units of the file
  std::vector<int> file_vertices;       ///< the FOLD file's number of each point; -1: it has none
  std::vector<PatternEdge> edges;       ///< each once
  std::vector<std::vector<int>> faces;  ///< counter-clockwise; empty where the file has none
  std::vector<NotedCrease> noted;
  std::vector<LayerOrder> orders;
  std::vector<std::string> places;  ///< of each line in a drawing; empty: of a FOLD file
  std::vector<std::string> notes;   ///< a sentence for each thing that was changed to read it

  bool hasOnlyTriangles() const;
  /// Numbers of the edges that are cuts.
  std::vector<std::size_t> cuts() const;
  /// For a message, with the file's numbers.
  std::string edgeName(const PatternEdge& edge) const;
  std::string vertexName(int vertex) const;
};

/// Finds the flat crease pattern of a FOLD file. Sides of faces are among the edges, and the border
/// is what has one face; vertices that coincide become one, unless the faces part there exactly
/// where the file says that border is, as at an open slit. Without faces the edges are a drawing
/// (makePlanar), of which flat edges may be left out.
/// \throws std::invalid_argument naming the place in the file: no flat frame, an edge without
///         length or of two kinds, three faces on an edge, a border inside the paper, no border
CreasePattern readPattern(const FoldDocument& document, bool keep_flat_edges);

/// The pattern as lines of the plane, without faces: vertices that coincide are one, and border
/// edges that lie on each other, as the sides of an open slit do, are one cut.
/// \throws std::invalid_argument when two edges that become one fold differently
CreasePattern closeSlits(const CreasePattern& pattern, bool keep_flat_edges);

/// The first frame whose vertices lie in a plane, a frame of class creasePattern before all
/// others, and that plane. Faces tell which side is up; otherwise it is the positive axis'.
/// \throws std::invalid_argument when there is none
void findFlatFrame(const FoldDocument& document, CreasePattern& pattern);

/// Drops edges that are neither border nor crease nor cut, unless they are to be kept, and points
/// that no edge uses.
void dropUnused(CreasePattern& pattern, bool keep_flat_edges);

/// Drops edges that are neither border nor crease nor cut.
void dropFlatEdges(CreasePattern& pattern);

/// Returns the largest extent of points along x or y.
double extentOf(const std::vector<Vector2>& points);

/// Returns the least x and y of points.
Vector2 lowerLeft(const std::vector<Vector2>& points);

/// Points closer than this are one: 1e-9 of their extent.
double coincidence(const std::vector<Vector2>& points);

/// Returns for each vertex the one that stands for it: the first of those that coincide, also by
/// way of others between them.
std::vector<int> mergeCoincident(const std::vector<Vector2>& points);

/// Collects edges, each once.
class EdgeCollector {
 public:
  explicit EdgeCollector(CreasePattern& pattern) : pattern_(pattern) {}

  /// The edge's place in the pattern. \throws std::invalid_argument when it has no length, or is
  /// there and folds differently
  std::size_t add(const PatternEdge& edge);
  /// The place of the edge between two vertices, in either direction.
  std::optional<std::size_t> find(int a, int b) const;

 private:
  CreasePattern& pattern_;
  std::map<std::pair<int, int>, std::size_t> places_;
};

/// Border and holes of a sheet.
struct Outline {
  std::vector<Vector2> border;
  std::vector<std::vector<Vector2>> holes;

  double area() const;
  bool contains(const Vector2& p) const;
};

/// Follows the border edges around. \throws std::invalid_argument when they cross, do not close,
/// meet themselves in a vertex, or surround more than one sheet
Outline traceOutline(const CreasePattern& pattern);

/// \throws std::invalid_argument naming two edges that cross or one that is off the paper
void checkEdges(const CreasePattern& pattern, const Outline& outline);

/// A point inside a simple polygon.
Vector2 pointInside(const std::vector<Vector2>& polygon);

/// The creases of a pattern: those it notes, then the straight lines of all other crease edges,
/// named crease_0, crease_1, ... in the order of their first edges. A line ends where a cut parts
/// the paper.
std::vector<PatternCrease> gatherCreases(const CreasePattern& pattern);

}  // namespace shell_origami
