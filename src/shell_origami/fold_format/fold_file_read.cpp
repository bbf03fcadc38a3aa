#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/fold_format/folded_form.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace shell_origami {
namespace {

double metresPerUnit(const FoldDocument& document, int frame, double scale) {
  if (scale != 0) {
    if (!(scale > 0) || !std::isfinite(scale)) {
      reject("scale is ", scale, ", but must be positive and finite");
    }
    return scale;
  }
  static const std::map<std::string, double> metres{
      {"m", 1},     {"cm", 1e-2},   {"mm", 1e-3},       {"um", 1e-6},
      {"nm", 1e-9}, {"in", 0.0254}, {"pt", 0.0254 / 72}};
  const std::string unit = document.unit(frame);
  const auto found = metres.find(unit);
  if (found == metres.end()) {
    reject("states no physical unit (frame_unit is \"", unit,
           "\"): give a scale in metres per unit");
  }
  return found->second;
}

/// A paper of our own keeps its triangles where no edge is longer than this many times max_edge:
/// edge making stretches some edges of a mesh that was made for max_edge.
constexpr double kKeptStretch = 1.5;

/// The longest edge to cut the pattern for [m]; 0 keeps its triangles.
double maxEdge(const FoldDocument& document, const CreasePattern& pattern, double wanted) {
  if (!document.has(pattern.frame, "shell_origami:creases") || !pattern.hasOnlyTriangles()) {
    return wanted;
  }
  double longest = 0;
  for (const PatternEdge& edge : pattern.edges) {
    const auto [a, b] = edge.vertices;
    longest = std::max(longest, (pattern.points[a] - pattern.points[b]).norm());
  }
  return longest <= kKeptStretch * wanted ? 0 : wanted;
}

FoldPaper readDocument(const FoldDocument& document, const FoldReadOptions& options) {
  CreasePattern pattern = readPattern(document);
  const double metres = metresPerUnit(document, pattern.frame, options.scale);
  dropUnused(pattern, true);
  for (Vector2& p : pattern.points) p *= metres;
  const PatternSheet made = makeSheet(pattern, maxEdge(document, pattern, options.max_edge));
  FoldPaper paper{made.sheet, {}, {}};
  if (options.form == FoldForm::kFolded) readFoldedForm(document, pattern, metres, made, paper);
  return paper;
}

}  // namespace

FoldPaper readFold(const std::string& path, const FoldReadOptions& options) {
  try {
    return readDocument(FoldDocument(path), options);
  } catch (const std::exception& error) {
    // Whatever is wrong with a file is the file's fault, a broken sheet (std::logic_error) too.
    reject(path, ": ", error.what());
  }
}

}  // namespace shell_origami
