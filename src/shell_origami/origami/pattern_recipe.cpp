#include <shell_origami/origami/pattern_recipe.h>

#include <shell_origami/base/files.h>
#include <shell_origami/energy/rest_state.h>
#include <shell_origami/fold_format/fold_file.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

namespace shell_origami {
namespace {

namespace fs = std::filesystem;

/// Edges of the pattern's mesh across its width, and the time that it has to settle at the end and
/// after each other step of a sequence [s].
constexpr double kEdgesOfAWidth = 10, kTimeout = 10, kStepTimeout = 1;
/// A crease is folded in a step of a sequence where its angle changes by more than this [rad].
constexpr double kChange = 0.1 * M_PI / 180;

/// In YAML's single quotes.
std::string quoted(const std::string& text) {
  std::string quotes = "'";
  for (const char c : text) quotes += c == '\'' ? std::string("''") : std::string(1, c);
  return quotes + "'";
}

double widthOf(const Sheet& sheet) {
  Eigen::AlignedBox2d box;
  for (const Vector2& p : sheet.flatPositions()) box.extend(p);
  return box.sizes().x();
}

/// Writes the folds of a sequence. Creases that are not yet made in a step are driven from the
/// first one on, so that the paper is stiff there.
class StageWriter {
 public:
  StageWriter(const Sheet& sheet, std::ostream& text)
      : sheet_(sheet), text_(text), angles_(sheet.creases().size(), std::nan("")) {
    for (const Crease& crease : sheet.creases()) ++counts_[crease.name];
  }

  void write(const FoldStage& stage, double timeout) {
    // Paper that is still flat, as in the first frame of most sequences, needs no step.
    begun_ = begun_ || std::any_of(stage.begin(), stage.end(),
                                   [](double angle) { return std::abs(angle) > kChange; });
    if (!begun_) return;
    bool any = false;
    for (std::size_t i = 0; i < stage.size(); ++i) {
      if (std::isnan(stage[i]) || std::abs(stage[i] - angles_[i]) <= kChange) continue;
      text_ << (any ? ",\n      " : "  - fold:\n      [");
      writeFold(sheet_.creases()[i], stage[i]);
      angles_[i] = stage[i];
      any = true;
    }
    if (any) text_ << "]\n  - settle: {timeout: " << timeout << "}\n";
  }

 private:
  void writeFold(const Crease& crease, double angle) {
    text_ << "{";
    if (counts_[crease.name] == 1) {
      text_ << "crease: " << quoted(crease.name);
    } else {  // folded by its name, others would fold with it
      const Vector2& a = sheet_.flatPositions()[crease.vertices.front()];
      const Vector2& b = sheet_.flatPositions()[crease.vertices.back()];
      text_ << "line: [[" << a.x() << ", " << a.y() << "], [" << b.x() << ", " << b.y() << "]]";
    }
    const double rest = std::clamp(angle, -kLargestRestAngle, kLargestRestAngle);
    text_ << ", angle_deg: " << rest / M_PI * 180 << "}";
  }

  const Sheet& sheet_;
  std::ostream& text_;
  std::vector<double> angles_;  ///< asked for so far [rad]; NaN: none
  std::map<std::string, int> counts_;
  bool begun_ = false;
};

void writeSteps(const std::optional<FoldPaper>& paper, std::ostream& text) {
  if (!paper || paper->stages.empty()) {
    text << "  - fold: [{crease: all, part: 1}]\n  - settle: {timeout: " << kTimeout << "}\n";
    return;
  }
  StageWriter writer(paper->sheet, text);
  for (const FoldStage& stage : paper->stages) {
    writer.write(stage, &stage == &paper->stages.back() ? kTimeout : kStepTimeout);
  }
}

}  // namespace

RecipeText patternRecipe(const std::string& path, double width) {
  const fs::path file = fs::absolute(expandedPath(path));
  std::optional<FoldPaper> paper;
  if (width == 0 || isFoldSequence(file.string())) {
    paper = readPatternFile(file.string(), {0, 0, FoldForm::kFlat, width});
    if (width == 0) width = widthOf(paper->sheet);
  }
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "sheet: {pattern: " << quoted(file.string()) << ", form: flat, width: " << width
       << ", max_edge: " << width / kEdgesOfAWidth << "}\n"
       << "steps:\n";
  writeSteps(paper, text);
  return {path, file.parent_path().string(), text.str()};
}

}  // namespace shell_origami
