/// \file
/// origami_verify OUT_DIR [--fast]: compares the simulation with closed forms, prints a table and
/// writes it to OUT_DIR/results.csv, beside one CSV file for each figure. --fast: coarser meshes,
/// fewer samples. Exit code 1: a row is outside its tolerance; 2: it cannot run.
#include "verify/topics.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace {

int verify(const std::string& folder, bool fast) {
  using namespace shell_origami;
  std::filesystem::create_directories(folder);
  VerificationReport report(folder, fast);
  for (const auto topic :
       {verifyDerivatives, verifyMomentum, verifyTimeOrder, verifyVibration, verifyCantilever,
        verifyCylinder, verifyCreaseMoment, verifyDegree4, verifyMiura, verifyWaterbomb, verifyCone,
        verifyFlatFolded, verifyIntegrators, verifyChoices, verifyContact, verifyObstacles,
        verifyPressedCrease}) {
    topic(report);
  }
  report.write();
  const auto off = std::count_if(report.rows().begin(), report.rows().end(),
                                 [](const VerifiedRow& row) { return !row.holds(); });
  std::printf("%zu rows, %td outside their tolerance\n", report.rows().size(), off);
  return off == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool fast = words.size() == 2 && words[1] == "--fast";
  if (words.empty() || words[0].rfind("--", 0) == 0 || (words.size() > 1 && !fast)) {
    std::fprintf(stderr, "usage: origami_verify OUT_DIR [--fast]\n");
    return 2;
  }
  try {
    return verify(words[0], fast);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "origami_verify: %s\n", error.what());
    return 2;
  }
}
