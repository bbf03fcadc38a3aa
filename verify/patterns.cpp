/// \file
/// origami_patterns TABLE.md PATTERN...: folds crease patterns to their own angles, 180 degrees
/// taken as 178, compares what comes out with the exact state of rigid panels, and writes a table.
/// Exit code 1: a pattern is off and the library does not say so; 2: it cannot run.
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/sheet/rigid_panels.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace shell_origami;

constexpr double kWidth = 0.15;              // [m]
constexpr double kAngle = 178 * M_PI / 180;  // in the place of 180 degrees
constexpr double kClosed = M_PI / 180;       // panels are open by less, as files round their angles
constexpr double kRightDistance = 0.02;      // rms, in widths
constexpr const char* kMost = "5";           // time to settle [s]

double inDegrees(double radians) { return radians * 180 / M_PI; }

/// Where rigid panels are at the pattern's angles; nothing where they do not close.
std::optional<Positions> rigidState(const Sheet& sheet) {
  std::vector<double> angles;
  for (const Crease& crease : sheet.creases()) {
    angles.push_back(std::isnan(crease.pattern_angle) ? 0 : crease.pattern_angle);
  }
  for (int v : innerCreaseVertices(sheet)) {
    if (closingError(sheet, v, angles) > kClosed) return std::nullopt;
  }
  return foldRigidly(sheet, angles);
}

/// Root mean square distance of two shapes after a rigid fit, in widths.
double distance(const Positions& shape, const Positions& target) {
  const Eigen::Affine3d fit(Eigen::umeyama(shape, target, false));
  return std::sqrt((fit * shape - target).squaredNorm() / static_cast<double>(shape.cols())) /
         kWidth;
}

struct Folded {
  Simulation simulation;
  double cpu = 0;  // [s]
  std::string failure;
};

Folded fold(const std::string& path, const std::string& compliance) {
  std::ostringstream part;
  part << "[{fold: [{crease: all, part: " << kAngle / M_PI << "}]}, {settle: {timeout: " << kMost
       << "}}]";
  RecipeRunner runner(readRecipe(patternRecipe(path, kWidth), {}, {},
                                 {{"steps", part.str()}, {"compliance/factor", compliance}}));
  Folded folded{makeSimulation(runner.recipe().sheet, runner.recipe().config), 0, ""};
  const std::clock_t start = std::clock();
  while (runner.update(folded.simulation)) {
    const StepReport report = folded.simulation.step();
    if (report.converged) continue;
    folded.failure = report.failure;
    break;
  }
  folded.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return folded;
}

struct Row {
  std::string text;
  bool silent = false;  // off, without a word about it
};

Row compare(const std::string& path) {
  const Folded folded = fold(path, "0"), true_paper = fold(path, "1");
  const Simulation& simulation = folded.simulation;
  std::vector<double> errors;
  for (const CreaseStatus& crease : simulation.creases()) {
    if (crease.driven) errors.push_back(std::abs(crease.angle - crease.target_angle));
  }
  if (errors.empty()) throw std::invalid_argument(path + " asks for no fold");
  std::sort(errors.begin(), errors.end());
  const auto exact = rigidState(simulation.sheet());
  const double rms = exact ? distance(simulation.positions(), *exact) : std::nan("");
  const std::vector<MissedCrease> missed = missedCreases(simulation);
  std::string said = !folded.failure.empty() ? folded.failure : missedSentence(missed);
  if (said.empty() && !simulation.settled()) said = "has not settled";
  char figures[200];
  std::snprintf(figures, sizeof figures, "| %zu | %.2f | %.2f | %.1e | %.2f | %.2f | %s |",
                simulation.sheet().triangles().size(), folded.cpu / simulation.time(),
                true_paper.cpu / true_paper.simulation.time(), simulation.maxStrain(),
                inDegrees(errors.back()), inDegrees(errors[errors.size() / 2]),
                exact ? std::to_string(rms).substr(0, 6).c_str() : "none");
  Row row;
  row.text =
      "| " + std::filesystem::path(path).filename().string() + " " + figures + " " + said + " |";
  row.silent = said.empty() && (rms > kRightDistance || errors.back() > kMissedBy);
  return row;
}

constexpr const char* kHead =
    "# Crease patterns, folded\n\n"
    "Written by `scripts/patterns`. Each pattern of `test/data/patterns` is 0.15 m wide, its "
    "triangles'\n"
    "edges are at most 0.015 m long, and all creases fold at once in 1 s to the angles that it "
    "asks for,\n"
    "180 degrees taken as 178; then it settles. Layers may pass through each other. CPU seconds "
    "are for a\n"
    "simulated second, beside those of paper that does not give way (`compliance/factor` 1); "
    "strain is\n"
    "the largest at the end; crease errors are in degrees; the distance from the exact state of "
    "rigid\n"
    "panels is a root mean square, in widths, and `none` where these panels do not close.\n\n"
    "| pattern | triangles | CPU | CPU, true paper | strain | worst crease | median crease | "
    "distance | "
    "what is said |\n"
    "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";

int run(const std::vector<std::string>& words) {
  std::ofstream table(words[0]);
  table << kHead;
  int silent = 0;
  for (std::size_t i = 1; i < words.size(); ++i) {
    Row row;
    try {
      row = compare(words[i]);
    } catch (const std::invalid_argument& error) {
      row.text = "| " + std::filesystem::path(words[i]).filename().string() + " | | | | | | | | " +
                 error.what() + " |";
    }
    table << row.text << "\n" << std::flush;
    std::printf("%s%s\n", row.text.c_str(), row.silent ? " SILENTLY OFF" : "");
    std::fflush(stdout);
    silent += row.silent ? 1 : 0;
  }
  table.close();
  if (!table) throw std::runtime_error("cannot write " + words[0]);
  return silent == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: origami_patterns TABLE.md PATTERN...\n");
    return 2;
  }
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "origami_patterns: %s\n", error.what());
    return 2;
  }
}
