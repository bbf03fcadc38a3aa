/// \file
/// origami_patterns TABLE.md PATTERN...: folds crease patterns to their own angles, 180 degrees
/// taken as 178, compares what comes out with the exact state of rigid panels, and writes a table.
/// Exit code 1: a pattern is off and the library does not say so; 2: it cannot run.
#include "verify/crease_patterns.h"

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace shell_origami;

double inDegrees(double radians) { return radians * 180 / M_PI; }

std::string rowOf(const std::string& name, const PatternOutcome& folded, double true_paper_cpu) {
  char distance[20] = "none";
  if (!std::isnan(folded.distance)) {
    std::snprintf(distance, sizeof distance, "%.4f", folded.distance);
  }
  char figures[200];
  std::snprintf(figures, sizeof figures, " | %zu | %.2f | %.2f | %.1e | %.2f | %.2f | %s | ",
                folded.triangles, folded.cpu, true_paper_cpu, folded.strain,
                inDegrees(folded.worst), inDegrees(folded.median), distance);
  return "| " + name + figures + folded.said + " |";
}

constexpr const char* kHead = R"(# Crease patterns, folded

Written by `scripts/patterns`. Each pattern of `test/data/patterns` is 0.15 m wide, its triangles' edges are
at most 0.015 m long, and all creases fold at once in 1 s to the angles that it asks for, 180 degrees taken
as 178; then it settles. Layers may pass through each other (`contact/enabled: false`). CPU seconds are for
a simulated second, beside those of paper that does not give way (`compliance/factor` 1); strain is the
largest at the end; crease errors are in degrees; the distance from the exact state of rigid panels is a
root mean square, in widths, and `none` where these panels do not close.

| pattern | triangles | CPU | CPU, true paper | strain | worst crease | median crease | distance | said |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |
)";

int run(const std::vector<std::string>& words) {
  std::ofstream table(words[0]);
  table << kHead;
  int silent = 0;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string name = std::filesystem::path(words[i]).filename().string();
    std::string row;
    try {
      const PatternOutcome folded = foldPattern(words[i], 0);
      row = rowOf(name, folded, foldPattern(words[i], 1).cpu);
      if (folded.isOff() && folded.said.empty()) {
        ++silent;
        row += " SILENTLY OFF";
      }
    } catch (const std::invalid_argument& error) {
      const std::string why = error.what();  // which begins with the path of the file
      row = "| " + name + " | | | | | | | | " + why.substr(why.find(name)) + " |";
    }
    table << row << "\n" << std::flush;
    std::printf("%s\n", row.c_str());
    std::fflush(stdout);
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
