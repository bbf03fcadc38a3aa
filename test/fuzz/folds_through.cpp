#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/fold_through.h>
#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/snapshot.h>
#include "test/fuzz/bounds.h"
#include "test/fuzz/fuzz.h"
#include "test/fuzz/random_folds.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

constexpr int kMostFolds = 3;  // 8 layers
/// Folds that are tried on one paper, the rejected ones included.
constexpr int kTries = 12;
constexpr double kSettles = 1;  // [s]
/// Steps after which crossings are looked for.
constexpr std::uint64_t kLook = 10;
/// Creases whose folds end nearer to flat than this may end on either side [rad].
constexpr double kNoSide = 5 * M_PI / 180;

/// What became of the folds.
struct Tally {
  int folded = 0, rejected = 0, stuck = 0, short_of = 0;
  std::map<std::string, int> reasons, shortfalls;  ///< by their first words

  void print() const {
    std::printf("%d folded, %d rejected, %d stuck, %d papers with shortfalls\n", folded, rejected,
                stuck, short_of);
    for (const auto& [words, count] : reasons) {
      std::printf("  rejected %d: %s ...\n", count, words.c_str());
    }
    for (const auto& [words, count] : shortfalls) {
      std::printf("  short %d: %s ...\n", count, words.c_str());
    }
  }
};

/// The first words of a sentence that are no numbers.
std::string firstWords(const std::string& sentence) {
  std::istringstream text(sentence);
  std::string words, word;
  for (int i = 0; i < 8 && text >> word;) {
    if (word.find_first_of("0123456789") != std::string::npos) continue;
    words += (i++ == 0 ? "" : " ") + word;
  }
  return words;
}

Simulation paperOfLayers() {
  SimulationConfig config;
  config.material.crease_stiffness = 0.1;
  config.contact.distance = 2e-5;
  config.compliance.factor = 1000;
  return Simulation(Sheet(triangulateRectangle(0.15, 0.15, 0.03)), config);
}

std::vector<std::uint8_t> bytesOf(const Simulation& paper) {
  return nlohmann::json::to_cbor(toJson(paper.snapshot()));
}

void checkSides(const Simulation& paper) {
  for (const CreaseStatus& crease : paper.creases()) {
    if (!crease.driven || std::abs(crease.target_angle) < kNoSide) continue;
    if ((crease.angle > 0) == (crease.target_angle > 0)) continue;
    std::ostringstream text;
    text << "crease " << crease.name << " is at " << crease.angle * 180 / M_PI
         << " degrees, not at " << crease.target_angle * 180 / M_PI;
    throw std::logic_error(text.str());
  }
}

void checkUncrossed(const Simulation& paper) {
  const std::string crossing = crossingSentence(paper);
  if (!crossing.empty()) throw std::logic_error(crossing);
}

/// Advances by a step. Returns the reason why it did not converge; empty: it did.
/// \throws std::logic_error where a step that did not converge moved the paper
std::string step(Simulation& paper) {
  const Positions positions = paper.positions(), velocities = paper.velocities();
  const double time = paper.time();
  const StepReport report = paper.step();
  if (!report.converged) {
    if (report.failure.empty()) throw std::logic_error("a step fails without a reason");
    if (paper.positions() != positions || paper.velocities() != velocities ||
        paper.time() != time) {
      throw std::logic_error("a step that did not converge moved the paper");
    }
    checkUncrossed(paper);
  } else if (paper.counters().steps % kLook == 0) {
    checkUncrossed(paper);
  }
  return report.failure;
}

/// Folds and settles. Returns the reason why a step did not converge; empty: all did.
std::string run(Simulation& paper) {
  const auto advance = [&](double until) -> std::string {
    while (paper.folding() || (paper.time() < until && !paper.settled())) {
      std::string failure = step(paper);
      if (!failure.empty()) return failure;
    }
    return "";
  };
  std::string failure = advance(0);
  if (failure.empty()) failure = advance(paper.time() + kSettles);
  checkUncrossed(paper);
  return failure;
}

/// Plans a fold and begins it. Returns the plan's viewpoint; none: the fold is rejected.
/// \throws std::logic_error where a rejected fold has changed the paper
std::optional<Viewpoint> begin(Simulation& paper, const FoldThrough& fold, const Viewpoint& view,
                               Tally& tally) {
  const std::vector<std::uint8_t> before = bytesOf(paper);
  try {
    const FoldPlan plan = planFold(fold, view, paper);
    if (bytesOf(paper) != before) throw std::logic_error("a plan changes the paper");
    const std::vector<FoldEdit> edits = foldEdits(plan, fold);
    paper.apply(std::vector<Edit>(edits.begin(), edits.end()));
    return plan.after;
  } catch (const std::invalid_argument& reason) {
    if (bytesOf(paper) != before) {
      throw std::logic_error("a rejected fold changes the paper: " + std::string(reason.what()));
    }
    ++tally.rejected;
    ++tally.reasons[firstWords(reason.what())];
  }
  return std::nullopt;
}

/// Folds a new paper up to three times. \throws std::logic_error where a promise is broken
void foldPaper(int number, RandomSheets& random, Tally& tally) {
  Simulation paper = paperOfLayers();
  Viewpoint view = frontOf(paper.sheet());
  const int wanted = 1 + random.below(kMostFolds);
  for (int folds = 0, tries = 0; folds < wanted && tries < kTries; ++tries) {
    if (random.below(2) == 0) view.front = !view.front;
    const FoldThrough fold = randomFoldThrough(random, paper.sheet());
    const std::optional<Viewpoint> after = begin(paper, fold, view, tally);
    if (!after) continue;
    view = *after;
    ++folds;
    const std::string failure = run(paper);
    if (!failure.empty()) {
      ++tally.stuck;
      std::printf("paper %d is stuck in fold %d: %s\n", number, folds, failure.c_str());
      return;
    }
    checkSides(paper);
    paper.sheet().validate();
    ++tally.folded;
  }
  const std::vector<std::string> sentences = shortfalls(paper);
  if (!sentences.empty()) ++tally.short_of;
  for (const std::string& sentence : sentences) {
    ++tally.shortfalls[firstWords(sentence)];
    std::printf("paper %d falls short: %s\n", number, sentence.c_str());
  }
}

}  // namespace

bool fuzzFoldsThrough(int papers, unsigned seed) {
  Tally tally;
  int broken = 0;
  for (int i = 0; i < papers; ++i) {
    // Each paper has a seed of its own, from which it can be folded again alone.
    RandomSheets random(seed + static_cast<unsigned>(i));
    try {
      foldPaper(i, random, tally);
    } catch (const std::exception& fault) {
      ++broken;
      std::printf("paper %d (seed %u) is broken: %s\n", i, seed + static_cast<unsigned>(i),
                  fault.what());
    }
    std::fflush(stdout);
  }
  std::printf("%d papers, %d of them broken: ", papers, broken);
  tally.print();
  return broken == 0;
}

}  // namespace shell_origami
