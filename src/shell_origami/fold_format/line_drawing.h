/// \file
/// Crease patterns as drawing programs keep them: straight lines, and nothing that ties them.
#pragma once

#include <shell_origami/fold_format/crease_pattern.h>

#include <string>
#include <vector>

namespace shell_origami {

struct DrawnLine {
  Vector2 from, to;   ///< y points down, as on a screen
  char kind;          ///< one of BCMVUF
  double angle;       ///< what it asks for [rad], valley > 0; NaN: nothing
  std::string place;  ///< in the file, such as "line 3"
};

struct LineDrawing {
  std::vector<DrawnLine> lines;
  std::vector<std::string> notes;  ///< a sentence for each thing that was passed over

  /// Appends a line. Throws std::invalid_argument naming the place if a coordinate is not below
  /// 1e100 or there are too many lines.
  void add(DrawnLine line);
};

/// Returns the drawing as a pattern (makePlanar) that is seen as on the screen: y points up, and
/// the lower left corner is the origin.
CreasePattern patternOf(LineDrawing drawing, bool keep_flat_edges);

/// Reads the text of a .cp file (ORIPA, Oriedita): "type x1 y1 x2 y2" in each line.
/// Throws std::invalid_argument naming the line of the file.
LineDrawing readCp(const std::string& text);

/// Reads the text of an .opx file (ORIPA's XML). Throws std::invalid_argument naming the line.
LineDrawing readOpx(const std::string& text);

/// Reads an SVG drawing in the colors of Origami Simulator: border black, mountain red, valley
/// blue, cut green, flat yellow, unassigned magenta; opacity 1 asks for 180 degrees.
/// Throws std::invalid_argument naming the element and its line.
LineDrawing readSvg(const std::string& text);

}  // namespace shell_origami
