/// \file
/// A triangulation that knows where its material is in space while it is being edited.
#pragma once

#include <shell_origami/mesh/triangulation.h>

#include <set>
#include <vector>

namespace shell_origami {

/// Changes the triangulation so that the folded paper keeps its shape: a new or shifted vertex
/// stands in space where its flat point was.
class MaterialMesh {
 public:
  /// Directions in which a vertex may be shifted without changing the outline or a crease.
  struct Freedom {
    enum Kind { kFixed, kSlides, kFree } kind = kFixed;
    std::array<int, 2> rail{-1, -1};  ///< the neighbours between which it slides
  };

  /// `positions` in space, or null for a flat sheet; `held` vertices are never shifted. `exact`:
  /// nothing counts as nearly flat, so that edges are split only.
  MaterialMesh(const Triangulation& mesh, const Positions* positions, std::set<int> held,
               bool exact = false);

  const Triangulation& flat() const { return mesh_; }
  const Vector2& point(int v) const { return mesh_.points()[v]; }
  double size() const { return size_; }
  bool exact() const { return exact_; }
  /// Points closer than this are one [m].
  double snap() const { return 1e-7 * size_; }
  /// Vertices around which triangles changed so far.
  const std::vector<int>& touched() const { return touched_; }

  void setLabel(Triangulation::Side side, int label) { mesh_.setLabel(side, label); }
  int splitEdge(Triangulation::Side side, const Vector2& p);
  int splitTriangle(int triangle, const Vector2& p);
  void flip(Triangulation::Side side);
  void shift(int v, const Vector2& p);

  Freedom freedom(int v) const;
  /// Whether the edge may be flipped: unlabelled, convex, and the paper nearly flat across it.
  bool mayFlip(Triangulation::Side side) const;
  /// Whether the paper is nearly flat around v, so that shifting v keeps its shape.
  bool nearlyFlatAround(int v) const;
  /// Smallest angle [rad] of the triangles around v, with v at p; negative if one turns over.
  double smallestAngle(int v, const Vector2& p) const;

 private:
  bool nearlyFlatAcross(Triangulation::Side side) const;
  void touch(int v);

  Triangulation mesh_;
  std::vector<Vector3> space_;  ///< empty while the sheet is flat
  std::set<int> held_;
  bool exact_;
  std::vector<int> touched_;
  double size_ = 0;
};

/// Smallest angle of a triangle [rad]; negative when it is clockwise.
double smallestAngle(const Vector2& a, const Vector2& b, const Vector2& c);

/// Flips edges towards Delaunay and shifts free vertices near small angles that this edit left.
void improve(MaterialMesh& mesh);

}  // namespace shell_origami
