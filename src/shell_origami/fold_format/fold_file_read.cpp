#include <shell_origami/base/error.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/fold_format/folded_form.h>

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

FoldPaper readDocument(const FoldDocument& document, const FoldReadOptions& options) {
  CreasePattern pattern = readPattern(document);
  const double metres = metresPerUnit(document, pattern.frame, options.scale);
  dropUnused(pattern, true);
  for (Vector2& p : pattern.points) p *= metres;
  const PatternSheet made = makeSheet(pattern, options.max_edge);
  FoldPaper paper{made.sheet, {}, {}};
  readFoldedForm(document, pattern, metres, made, paper);
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
