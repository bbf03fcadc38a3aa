#include <shell_origami/base/bounded_json.h>
#include <shell_origami/base/files.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/mesh/triangulate.h>
#include <shell_origami/origami/simulation.h>
#include <shell_origami/origami/snapshot.h>
#include "test/fuzz/bounds.h"
#include "test/fuzz/fuzz.h"
#include "test/fuzz/mutate.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <vector>

namespace shell_origami {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestPattern = 100000;  // [bytes]

struct PatternText {
  std::string extension, text;
};

std::vector<PatternText> patternTexts() {
  static const std::set<std::string> kExtensions{".cp", ".fold", ".opx", ".svg"};
  std::vector<fs::path> paths;
  for (const char* folder : {"test/data/patterns", "recipes/patterns"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_FOLDER) / folder)) {
      const bool is_small = entry.file_size() <= kLargestPattern;
      const bool is_pattern = kExtensions.count(entry.path().extension().string()) > 0;
      if (is_pattern && is_small) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<PatternText> texts;
  for (const fs::path& path : paths) {
    texts.push_back({path.extension().string(), readFile(path.string(), kLargestPattern)});
  }
  return texts;
}

std::string mutatedText(const PatternText& pattern, RandomSheets& random) {
  std::string result = pattern.text;
  if (pattern.extension != ".fold" || random.below(2) == 0) {
    mutate(result, random);
  } else {
    Json document = Json::parse(pattern.text);
    mutate(document, random);
    result = document.dump();
  }
  return result;
}

/// Papers for snapshots: folded, pinned, and free.
std::vector<Json> snapshots() {
  std::vector<Json> result;
  for (const double angle : {0.0, 1.0}) {
    Simulation simulation(Sheet(triangulateRectangle(0.1, 0.08, 0.04)), {});
    FoldEdit fold;
    fold.where = Segment{Vector2(0, 0.03), Vector2(0.1, 0.05)};
    fold.angle = angle;
    if (angle > 0) simulation.fold(fold);
    simulation.pin(std::vector<std::int64_t>{0, 1});
    if (angle > 0) simulation.pin(std::vector<std::int64_t>{3}, "hand", {});
    for (int i = 0; i < 5; ++i) simulation.step();
    result.push_back(toJson(simulation.snapshot()));
  }
  return result;
}

/// Reads inputs one after the other. `read` throws std::invalid_argument where it rejects one.
template <class Read>
bool readAll(int inputs, Read read) {
  limitProgram();
  int accepted = 0;
  for (int i = 0; i < inputs; ++i) {
    const InputTimer timer(i);
    try {
      read();
      ++accepted;
    } catch (const std::invalid_argument& rejection) {
      if (std::string(rejection.what()).find("bad_alloc") == std::string::npos) continue;
      std::printf("input %d takes too much memory: %s\n", i, rejection.what());
      return false;
    } catch (const std::exception& error) {
      std::printf("input %d is not rejected in order: %s\n", i, error.what());
      return false;
    }
  }
  std::printf("%d inputs, %d of them accepted\n", inputs, accepted);
  return true;
}

}  // namespace

bool fuzzFoldText(int inputs, unsigned seed) {
  RandomSheets random(seed);
  const std::vector<PatternText> texts = patternTexts();
  const fs::path stem = fs::temp_directory_path() / ("origami_fuzz." + std::to_string(getpid()));
  std::string path;
  const bool kept = readAll(inputs, [&] {
    const auto which = static_cast<std::size_t>(random.below(static_cast<int>(texts.size())));
    fs::remove(path);
    path = stem.string() + texts[which].extension;
    std::ofstream(path, std::ios::binary) << mutatedText(texts[which], random);
    const FoldReadOptions options{0, random.below(2) == 0 ? 0 : 0.05, FoldForm::kFolded, 0.15};
    const FoldPaper paper = readPatternFile(path, options);
    paper.sheet.validate();
    if (paper.positions) Simulation(paper.sheet, {}, *paper.positions, paper.rest_angles);
  });
  if (kept) fs::remove(path);
  else std::printf("it is in %s\n", path.c_str());
  return kept;
}

bool fuzzCbor(int inputs, unsigned seed) {
  RandomSheets random(seed);
  const std::vector<Json> papers = snapshots();
  return readAll(inputs, [&] {
    Json paper = papers[static_cast<std::size_t>(random.below(2))];
    const bool by_value = random.below(2) == 0;
    if (by_value) mutate(paper, random);
    std::string bytes;
    Json::to_cbor(paper, bytes);
    if (!by_value) mutate(bytes, random);
    Simulation simulation(snapshotFrom(parseCbor({bytes.begin(), bytes.end()})));
    simulation.sheet().validate();
    simulation.step();
  });
}

}  // namespace shell_origami
