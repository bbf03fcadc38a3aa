#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/fold_format/fold_stages.h>
#include <shell_origami/fold_format/folded_form.h>
#include <shell_origami/fold_format/line_drawing.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

namespace shell_origami {
namespace {

/// Of a drawing's file. Its XML takes up to some ten times as much memory.
constexpr std::uintmax_t kMostDrawingBytes = std::uintmax_t{16} << 20;

void checkSize(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    reject(name, " is ", value, ", but must be positive and finite");
  }
}

double metresPerUnit(const std::string& unit, const CreasePattern& pattern,
                     const FoldReadOptions& options) {
  if (options.width != 0) {
    checkSize("width", options.width);
    if (options.scale != 0) reject("is given a scale and a width, of which each is enough");
    Eigen::AlignedBox2d box;
    for (const Vector2& p : pattern.points) box.extend(p);
    const double extent = box.sizes().x();
    if (!(extent > 0)) reject("has no extent along x");
    return options.width / extent;
  }
  if (options.scale != 0) {
    checkSize("scale", options.scale);
    return options.scale;
  }
  static const std::map<std::string, double> metres{
      {"m", 1},     {"cm", 1e-2},   {"mm", 1e-3},       {"um", 1e-6},
      {"nm", 1e-9}, {"in", 0.0254}, {"pt", 0.0254 / 72}};
  const auto found = metres.find(unit);
  if (found == metres.end()) {
    const std::string stated = unit == "unit" ? "" : " (frame_unit is \"" + unit + "\")";
    reject("states no physical unit", stated, ": give a scale in meters per unit, or a width");
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

/// Brings the pattern to metres. Returns the metres of one of its units.
double rescale(const std::string& unit, const FoldReadOptions& options, CreasePattern& pattern) {
  dropUnused(pattern, true);
  const double metres = metresPerUnit(unit, pattern, options);
  for (Vector2& p : pattern.points) p *= metres;
  for (LayerOrder& order : pattern.orders) {
    order.first *= metres;
    order.second *= metres;
  }
  return metres;
}

FoldPaper readDocument(const FoldDocument& document, const FoldReadOptions& options) {
  CreasePattern pattern = readPattern(document, options.max_edge == 0);
  const double metres = rescale(document.unit(pattern.frame), options, pattern);
  const PatternSheet made = makeSheet(pattern, maxEdge(document, pattern, options.max_edge));
  FoldPaper paper{made.sheet, {}, {}, {}, pattern.notes};
  paper.sheet.setLayerOrders(pattern.orders);
  paper.stages = readStages(document, pattern, metres, paper);
  if (options.form == FoldForm::kFolded) readFoldedForm(document, pattern, metres, made, paper);
  return paper;
}

FoldPaper readDrawing(LineDrawing drawing, const FoldReadOptions& options) {
  CreasePattern pattern = patternOf(std::move(drawing), options.max_edge == 0);
  rescale("unit", options, pattern);
  return {makeSheet(pattern, options.max_edge).sheet, {}, {}, {}, std::move(pattern.notes)};
}

/// Returns what `read` makes of the file. Whatever is wrong with a file is the file's fault, a
/// broken sheet (std::logic_error) too.
template <class Read>
auto namingFile(const std::string& path, Read read) {
  try {
    return read();
  } catch (const std::exception& error) {
    reject(path, ": ", error.what());
  }
}

std::string readText(const std::string& path) {
  std::string text = readFile(path, kMostDrawingBytes);
  if (text.rfind("\xef\xbb\xbf", 0) == 0) text.erase(0, 3);  // a byte order mark
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos) {
    reject("is no text: line ", 1 + std::count(text.begin(), text.begin() + zero, '\n'),
           " holds a zero byte");
  }
  return text;
}

using DrawingReader = LineDrawing (*)(const std::string& text);

/// Returns the reader of a drawing by the extension of its file; null: it is a FOLD file.
DrawingReader drawingReader(const std::string& path) {
  static const std::map<std::string, DrawingReader> kReaders{
      {".cp", readCp}, {".opx", readOpx}, {".svg", readSvg}};
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto found = kReaders.find(extension);
  return found == kReaders.end() ? nullptr : found->second;
}

}  // namespace

FoldPaper readFold(const std::string& path, const FoldReadOptions& options) {
  return namingFile(path, [&] { return readDocument(FoldDocument(path), options); });
}

FoldPaper readPatternFile(const std::string& path, const FoldReadOptions& options) {
  const DrawingReader read = drawingReader(path);
  if (!read) return readFold(path, options);
  return namingFile(path, [&] { return readDrawing(read(readText(path)), options); });
}

bool isFoldSequence(const std::string& path) {
  return !drawingReader(path) &&
         namingFile(path, [&] { return FoldDocument(path).isOfClass("diagrams"); });
}

}  // namespace shell_origami
