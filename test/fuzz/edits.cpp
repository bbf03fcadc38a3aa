#include <shell_origami/base/bounded_json.h>
#include <shell_origami/origami/simulation.h>
#include <shell_origami/origami/snapshot.h>
#include "test/fuzz/bounds.h"
#include "test/fuzz/fuzz.h"
#include "test/sheet/random_sheets.h"

#include <cstdio>
#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

constexpr int kEditsPerSheet = 12;

/// Makes one random edit. Throws std::invalid_argument where the paper rejects it.
void edit(Simulation& paper, RandomSheets& random) {
  const Sheet& sheet = paper.sheet();
  const auto any_vertex = [&] { return random.below(sheet.vertexCount()); };
  switch (random.below(8)) {
    case 0:
    case 1: {
      FoldEdit fold;
      fold.where = random.line(sheet);
      fold.angle = random.between(-3, 3);
      fold.duration = random.between(0, 0.5);
      if (random.below(3) == 0) fold.name = "crease" + std::to_string(random.below(3));
      paper.fold(fold);
      break;
    }
    case 2: {
      if (sheet.creases().empty()) break;
      const int crease = random.below(static_cast<int>(sheet.creases().size()));
      FoldEdit fold;
      fold.where = CreaseName{sheet.creases()[static_cast<std::size_t>(crease)].name};
      fold.angle = random.between(-3, 3);
      fold.duration = random.between(0, 0.5);
      paper.fold(fold);
      break;
    }
    case 3: paper.pin(std::vector<std::int64_t>{any_vertex(), any_vertex()}); break;
    case 4:
      if (paper.pinned().empty() || random.below(2) == 0) paper.unpin();
      else paper.unpin(std::vector<std::int64_t>{*paper.pinned().begin()});
      break;
    case 5: {
      const int which = random.below(static_cast<int>(sheet.edges().size()));
      const auto [a, b] = sheet.edges()[static_cast<std::size_t>(which)].vertices;
      paper.addVertex(a, b, random.unit());
      break;
    }
    case 6: paper.settle(); break;
    default:
      for (int i = 0; i < 5; ++i) paper.step();
  }
}

/// Whether the paper goes on to the bit when it is made again of its snapshot.
void checkSnapshot(Simulation& paper) {
  const auto bytes = nlohmann::json::to_cbor(toJson(paper.snapshot()));
  Simulation again(snapshotFrom(parseCbor(bytes)));
  for (int i = 0; i < 2; ++i) {
    const StepReport report = paper.step(), report_again = again.step();
    if (report.failure != report_again.failure) {
      throw std::logic_error("a snapshot's step ends otherwise: " + report.failure + " / " +
                             report_again.failure);
    }
  }
  if (nlohmann::json::to_cbor(toJson(paper.snapshot())) !=
      nlohmann::json::to_cbor(toJson(again.snapshot()))) {
    throw std::logic_error("a snapshot does not go on to the bit");
  }
}

}  // namespace

bool fuzzEdits(int edits, unsigned seed) {
  RandomSheets random(seed);
  limitProgram();
  int rejected = 0, made = 0;
  while (made < edits) {
    Simulation paper(Sheet(random.mesh(random.between(0.02, 0.04))), {});
    for (int i = 0; i < kEditsPerSheet && made < edits; ++i, ++made) {
      try {
        const std::uint32_t revision = paper.sheet().revision();
        try {
          edit(paper, random);
        } catch (const std::invalid_argument&) {
          ++rejected;
          if (paper.sheet().revision() != revision) throw std::logic_error("a rejected edit stays");
        }
        paper.sheet().validate();
        checkSnapshot(paper);
      } catch (const std::exception& broken) {
        std::printf("edit %d: %s\n", made, broken.what());
        return false;
      }
    }
  }
  std::printf("%d edits, %d of them rejected\n", made, rejected);
  return true;
}

}  // namespace shell_origami
