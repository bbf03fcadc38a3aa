/// \file
/// The paper as the node last published it.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <vector>

namespace shell_origami {

/// A place on a triangle, by the weights of its corners, which sum up to 1.
struct PaperPlace {
  int triangle = -1;
  Vector3 weights = Vector3::Zero();
};

/// The middle of a straight way along creases or the outline, from one feature to the next.
struct Middle {
  Vector2 flat;  ///< [m]
  int edge;      ///< that it lies on, an index into Sheet::edges()
};

/// A sheet where it is in space, with what picking and snapping need of it.
class ShownPaper {
 public:
  /// The sheet lies flat at first.
  explicit ShownPaper(Sheet sheet);

  /// \param positions      one column for each vertex [m]
  /// \param crease_angles  one for each crease [rad], valley > 0
  /// \throws std::invalid_argument where the numbers of vertices or creases are not the sheet's
  void move(Positions positions, std::vector<double> crease_angles);

  const Sheet& sheet() const { return sheet_; }
  const Positions& positions() const { return positions_; }
  double creaseAngle(int crease) const { return crease_angles_[crease]; }
  /// The vertices at which the outline turns, ascending.
  const std::vector<int>& corners() const { return corners_; }
  /// The corners and the vertices at which creases end, meet or turn, ascending.
  const std::vector<int>& features() const { return features_; }
  /// The edges, as indices into Sheet::edges(), that are creases or the outline.
  const std::vector<int>& lines() const { return lines_; }
  /// Of every way from feature to feature along these edges.
  const std::vector<Middle>& middles() const { return middles_; }
  int panel(int triangle) const { return panels_[triangle]; }
  /// Whether a vertex belongs to a triangle of the panel.
  bool touches(int vertex, int panel) const;
  /// Returns the place of a vertex in the panel. \pre touches(vertex, panel)
  PaperPlace placeOf(int vertex, int panel) const;
  /// Returns the place of a point on an edge, in the panel where the edge is one of it; otherwise
  /// the triangle is -1. \param part  of the edge's length, from its first vertex
  PaperPlace placeOn(int edge, double part, int panel) const;

  Vector2 flat(const PaperPlace& place) const;   ///< [m]
  Vector3 point(const PaperPlace& place) const;  ///< [m]
  /// Returns the place of a point of the flat sheet, looked for from a triangle on; of one off the
  /// paper the triangle is -1.
  PaperPlace place(const Vector2& flat, int near = 0) const;
  /// Returns the corner of the place's triangle that is nearest to it on the flat sheet.
  int nearestVertex(const PaperPlace& place) const;
  /// Returns a triangle's normal of length 1, on its front.
  Vector3 normal(int triangle) const;

 private:
  void findMiddles();

  Sheet sheet_;
  Positions positions_;
  std::vector<double> crease_angles_;
  std::vector<int> corners_, features_, lines_, panels_;
  std::vector<Middle> middles_;
  std::vector<std::vector<int>> panels_at_;  ///< of each vertex, ascending
};

}  // namespace shell_origami
