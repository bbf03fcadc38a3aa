/// \file
/// An edit of a sheet, which is made on a copy and committed as a whole.
#pragma once

#include <shell_origami/mesh/material_mesh.h>
#include <shell_origami/sheet/crease_labels.h>
#include <shell_origami/sheet/fold_line.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

class SheetEditor {
 public:
  SheetEditor(const Sheet& sheet, const EditContext& context);

  /// Returns the vertex at p: an existing one, a nearby one shifted there, or a new one. On a slit
  /// it is on the side in the direction `ahead`, if there is one. Throws std::invalid_argument if p
  /// is off the paper.
  int insertPoint(const Vector2& p, const Vector2& ahead);
  /// The same for an end of a line, which is moved onto the border, a crease or one of their
  /// vertices if it is very close (kMergedFeature).
  int insertEnd(const Vector2& p, const Vector2& ahead);
  /// Makes the straight line from one vertex to another run along edges and returns the vertices
  /// of its parts inside the paper, in order. Edges that carried no crease form a new one.
  std::vector<std::vector<int>> insertLine(int from, int to);
  MaterialMesh& mesh() { return mesh_; }

  /// Replaces the sheet by the edited copy and increases its revision. Creases are gathered from
  /// the labels; those that are new on the polyline are called `name`.
  FoldLine commit(Sheet& sheet, const std::vector<std::vector<int>>& parts,
                  const std::string& name);

 private:
  bool coincide(int v, int w) const;
  std::optional<int> nextOnLine(int current, int to, const Segment& line) const;
  std::optional<Triangulation::Side> crossedSide(int current, const Segment& line) const;
  int reenter(int current, const Segment& line);
  bool pullOntoLine(int current, const std::array<int, 2>& ends, const Segment& line);
  /// Shifts v to p if that changes neither outline, creases nor shape and leaves no sliver.
  bool shiftTo(int v, const Vector2& p);
  int vertexAt(const Vector2& p, const Vector2& ahead, double tolerance);
  std::optional<int> fixedCorner(const Triangle& corners, const Vector2& p, double tolerance) const;
  void checkEdges(const Sheet& before, const Sheet& after) const;
  std::vector<std::vector<int>> partsInside(const std::vector<int>& polyline) const;

  MaterialMesh mesh_;
  double merged_;    ///< distance within which ends are moved onto fixed vertices and edges [m]
  double shortest_;  ///< edge that may be made [m]
  CreaseLabels creases_;
  std::vector<int> protected_;  ///< ends of the line, which stay
};

}  // namespace shell_origami
