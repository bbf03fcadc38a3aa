#include <shell_origami/sheet/fold_line.h>

#include <shell_origami/base/error.h>
#include <shell_origami/sheet/sheet_editor.h>

namespace shell_origami {

FoldLine makeFoldLine(Sheet& sheet, const Segment& line, const std::string& name,
                      const EditContext& context) {
  for (const Vector2& end : line) {
    if (!end.allFinite()) {
      reject("an end of the line is not finite: (", end.x(), ", ", end.y(), ")");
    }
  }
  if (!name.empty()) checkCreaseName(name);
  SheetEditor editor(sheet, context);
  if ((line[1] - line[0]).norm() <= editor.mesh().snap()) {
    reject("both ends of the line are the same point (", line[0].x(), ", ", line[0].y(), ")");
  }
  const int from = editor.insertEnd(line[0], line[1] - line[0]);
  const int to = editor.insertEnd(line[1], line[0] - line[1]);
  if (from == to) reject("both ends of the line are vertex ", from);
  const std::vector<std::vector<int>> parts = editor.insertLine(from, to);
  if (parts.empty()) reject("the line runs along the border of the paper");
  improve(editor.mesh());
  return editor.commit(sheet, parts, name);
}

AddedVertex addVertex(Sheet& sheet, int a, int b, double fraction) {
  const auto inside = [&sheet](int v) { return v >= 0 && v < sheet.vertexCount(); };
  for (int v : {a, b}) {
    if (!inside(v)) reject("vertex ", v, " does not exist: the sheet has ", sheet.vertexCount());
  }
  if (!(fraction > 0 && fraction < 1)) reject("fraction ", fraction, " is not inside (0, 1)");
  SheetEditor editor(sheet, {});
  const auto side = a == b ? std::nullopt : sheet.triangulation().findSide(a, b);
  if (!side) reject("vertices ", a, " and ", b, " share no edge");
  const Vector2 &from = sheet.flatPositions()[a], &to = sheet.flatPositions()[b];
  const int vertex = editor.mesh().splitEdge(*side, from + fraction * (to - from));
  return {vertex, editor.commit(sheet, {}, "").remap};
}

}  // namespace shell_origami
