/// \file
/// The flat sheet: triangles, edges and creases.
#pragma once

#include <shell_origami/base/geometry.h>
#include <shell_origami/mesh/triangulation.h>

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace shell_origami {

/// A straight line of edges on the flat sheet along which the paper may fold.
struct Crease {
  std::uint32_t id = 0;       ///< unique for the life of the sheet, never reused
  std::string name;           ///< pieces of one crease share it
  std::vector<int> vertices;  ///< the polyline in order, at least two vertices
  /// Fold angle in the pattern that the sheet was loaded from [rad], valley > 0; NaN: none.
  double pattern_angle = std::numeric_limits<double>::quiet_NaN();
};

/// Which of two places on the flat sheet lies above the other one where the paper is folded flat,
/// as the file says that it was loaded from.
struct LayerOrder {
  Vector2 first, second;  ///< [m]
  int side;  ///< 1: the first is on the front side of the second; -1: behind; 0: unknown
};

/// Throws std::invalid_argument if a crease may not have the name: it is empty, longer than 100
/// bytes, or the name of a group of creases (all, mountains, valleys).
void checkCreaseName(const std::string& name);
/// Whether a crease belongs to a group: all, mountains or valleys of the pattern.
bool inGroup(const Crease& crease, const std::string& group);

/// Shortest edge that edge making leaves, as a part of the sheet's mean edge: shorter ones make a
/// step's matrix singular. A line whose end is closer than kMergedFeature to the border, a crease
/// or a vertex of theirs ends there instead.
constexpr double kShortestEdge = 1e-4;
constexpr double kMergedFeature = 1e-2;

/// An edge with its two triangles. Seen from +z the first triangle lies left of
/// vertices[0] -> vertices[1]:
///
///              opposite[0]
///               /      \          .
///     vertices[0] ---- vertices[1]
///               \      /          .
///              opposite[1]
struct Edge {
  std::array<int, 2> vertices;
  std::array<int, 2> opposite;   ///< the far vertex of each triangle; second is -1 on the border
  std::array<int, 2> triangles;  ///< second is -1 on the border
  int crease = -1;               ///< index into Sheet::creases(), or -1

  bool onBorder() const { return triangles[1] < 0; }
};

/// A sheet of paper with flat coordinates kept for life. Edits are made by the functions of
/// fold_line.h; each leaves a valid sheet or throws and leaves it as it was.
class Sheet {
 public:
  /// \throws std::invalid_argument when the triangulation or a crease is not valid.
  explicit Sheet(Triangulation triangulation, std::vector<Crease> creases = {});

  int vertexCount() const { return static_cast<int>(flatPositions().size()); }
  const std::vector<Vector2>& flatPositions() const { return triangulation_.points(); }
  const std::vector<Triangle>& triangles() const { return triangulation_.triangles(); }
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Crease>& creases() const { return creases_; }
  const Triangulation& triangulation() const { return triangulation_; }
  /// Kept for life, and not used by folding.
  const std::vector<LayerOrder>& layerOrders() const { return layer_orders_; }
  void setLayerOrders(std::vector<LayerOrder> orders) { layer_orders_ = std::move(orders); }
  /// Grows by one with every edit.
  std::uint32_t revision() const { return revision_; }
  std::uint32_t nextCreaseId() const { return next_crease_id_; }
  /// Sets the counters of a sheet that is constructed from the parts of another one.
  /// \throws std::invalid_argument when a crease has the next id or one after it
  void restore(std::uint32_t revision, std::uint32_t next_crease_id);

  /// Mean flat length of the edges [m].
  double meanEdge() const;
  /// Largest extent along x or y [m].
  double size() const;
  double area() const;  ///< flat [m^2]
  /// Index into edges() of a triangle's side.
  int edgeIndex(Triangulation::Side side) const { return edge_of_side_[side.triangle][side.edge]; }
  /// Index into creases() of the crease with this id, or -1.
  int creaseIndex(std::uint32_t id) const;
  /// Vertex whose flat position is nearest to p; of those that coincide, as on the sides of a slit,
  /// the one with the lowest number.
  int nearestVertex(const Vector2& p) const;

  /// Checks everything this class promises. \throws std::logic_error naming what is broken.
  void validate() const;

 private:
  void rebuildEdges();

  Triangulation triangulation_;
  std::vector<Crease> creases_;
  std::vector<LayerOrder> layer_orders_;
  std::vector<Edge> edges_;
  std::vector<std::array<int, 3>> edge_of_side_;
  std::uint32_t revision_ = 0;
  std::uint32_t next_crease_id_ = 0;
};

}  // namespace shell_origami
