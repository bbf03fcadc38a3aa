/// \file
/// Ways along the creases and the outline of a sheet.
#pragma once

#include <shell_origami/sheet/sheet.h>

#include <array>
#include <vector>

namespace shell_origami {

/// Whether a way from one vertex to another and on to a third goes straight on, but for few
/// degrees.
bool goesStraight(const Sheet& sheet, int from, int at, int to);

/// The creases of a sheet that are folded. Others, such as those drawn before, may cross them.
class FoldedCreases {
 public:
  /// \param folded  of each crease
  FoldedCreases(const Sheet& sheet, std::vector<bool> folded);

  bool has(int crease) const { return folded_[crease]; }
  /// Returns the other ends of the folded edges at a vertex, in the order around it.
  std::vector<int> at(int vertex) const;
  /// Goes along the folded edge from `from` to `to`, and straight on to where another one meets it,
  /// it turns or it ends. Returns the vertices, both ends included.
  std::vector<int> along(int from, int to) const;
  /// Goes along the outline from a vertex of it, each way, to the next vertex at which a folded
  /// crease ends. Returns these two vertices; where there is none, the vertex itself.
  std::array<int, 2> nextOnOutline(int vertex) const;

 private:
  const Sheet& sheet_;
  std::vector<bool> folded_;
};

/// Returns the crease of the edge between two vertices, as an index into Sheet::creases(); -1:
/// none.
int creaseBetween(const Sheet& sheet, int a, int b);
/// The ends of a crease on the flat sheet [m].
Segment lineOf(int crease, const Sheet& sheet);
/// Returns the creases that lie on a line, ascending.
std::vector<int> creasesAlong(const Sheet& sheet, const Segment& line);

/// Where the lines through two segments meet. \throws std::invalid_argument where they are parallel
Vector2 meetingOf(const Segment& first, const Segment& second);
/// The mirror image of a point across the line through a segment.
Vector2 mirrored(const Vector2& point, const Segment& line);

}  // namespace shell_origami
