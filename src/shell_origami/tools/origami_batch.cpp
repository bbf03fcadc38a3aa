/// \file
/// origami_batch: folds a recipe, or a crease pattern, without a ROS master.
#include <shell_origami/base/files.h>
#include <shell_origami/fold_format/fold_file.h>
#include <shell_origami/origami/outcome.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/report.h>
#include <shell_origami/origami/sequence.h>

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace shell_origami;

constexpr const char* kUsage =
    "usage: origami_batch RECIPE.yaml --out DIR [--set key=value ...] [--every SECONDS]\n"
    "       origami_batch PATTERN [--width WIDTH] --out DIR [...]\n"
    "Folds a recipe, or all creases of a pattern (.fold, .cp, .svg) to the angles that it asks "
    "for;\n"
    "a folding sequence (a FOLD file of class diagrams) step by step.\n"
    "  --width WIDTH    of the flat pattern along x [m]; without it the file has to state a unit\n"
    "  --out DIR        folder for final.fold, final.obj, frames.fold, diagrams.fold and "
    "report.json\n"
    "  --set key=value  overrides one value of the recipe, such as material/thickness=2e-4\n"
    "  --every SECONDS  simulated time between the frames of frames.fold (default 0.1)\n"
    "Exit codes: 0 the recipe was folded to its end; 1 nothing was written, for example because "
    "an\n"
    "argument or the recipe is invalid; 2 folding ended early, and the files show the paper as it\n"
    "was then, with the reason in report.json; 3 it was folded to its end, but is not as it was "
    "asked\n"
    "for: creases missed their target angles, as report.json lists under missed, panels are bent, "
    "or\n"
    "paper is stretched or passes through itself.\n";

constexpr int kNothingWritten = 1, kEndedEarly = 2, kFellShort = 3;

struct Options {
  std::string recipe;  // or a pattern
  std::string out;
  double width = 0;    // [m]; 0: none is given
  double every = 0.1;  // [s]
  Overrides overrides;
};

std::pair<std::string, std::string> splitOverride(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw std::invalid_argument("--set takes key=value, not '" + text + "'");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

double positiveNumber(const std::string& option, const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !(value > 0) || !std::isfinite(value)) {
    throw std::invalid_argument(option + " takes a positive number, not '" + text + "'");
  }
  return value;
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const auto value = [&]() -> const std::string& {
      if (i + 1 == arguments.size()) throw std::invalid_argument(word + " needs a value");
      return arguments[++i];
    };
    if (word == "--out") options.out = value();
    else if (word == "--set") options.overrides.push_back(splitOverride(value()));
    else if (word == "--width") options.width = positiveNumber(word, value());
    else if (word == "--every") options.every = positiveNumber(word, value());
    else if (word.rfind("--", 0) == 0) throw std::invalid_argument("unknown option " + word);
    else if (options.recipe.empty()) options.recipe = word;
    else throw std::invalid_argument("more than one recipe: " + options.recipe + ", " + word);
  }
  if (options.recipe.empty()) throw std::invalid_argument("no recipe is given");
  if (options.width > 0 && isRecipe(options.recipe)) {
    throw std::invalid_argument("--width is for patterns; the recipe " + options.recipe +
                                " states the size of its sheet");
  }
  if (options.out.empty()) throw std::invalid_argument("--out DIR is missing");
  return options;
}

/// A line that is drawn over itself, on a terminal only.
class ProgressBar {
 public:
  void draw(const RecipeRunner& runner, const Simulation& simulation) {
    if (!isatty(STDERR_FILENO)) return;
    const double progress = runner.progress(simulation);
    const int percent = static_cast<int>(100 * progress);
    if (percent == percent_) return;
    percent_ = percent;
    std::string bar(40, ' ');
    bar.replace(0, percent * 40 / 100, std::string(percent * 40 / 100, '='));
    std::fprintf(stderr, "\r[%s] %3d %%  %-8s %s", bar.c_str(), percent, runner.doing().c_str(),
                 percent == 100 ? "\n" : "");
  }

 private:
  int percent_ = -1;
};

/// frames.fold: the flat pattern at the end, and one folded frame per instant. The first frame of
/// every revision of the sheet brings its own mesh, those that follow inherit it.
class Frames {
 public:
  explicit Frames(double every) : every_(every) {}

  void add(const Simulation& simulation) {
    if (simulation.time() + 1e-9 < next_) return;
    next_ += every_;
    const bool brings_mesh = mesh_frame_ == 0 || simulation.sheet().revision() != revision_;
    if (brings_mesh) {
      revision_ = simulation.sheet().revision();
      mesh_frame_ = static_cast<int>(frames_.size()) + 1;  // the key frame is number 0
    }
    frames_.push_back(foldFrame(simulation, brings_mesh ? 0 : mesh_frame_));
  }
  std::size_t size() const { return frames_.size(); }
  /// Forgets all but the first frames.
  void keepFirst(std::size_t count) {
    frames_.resize(count);
    next_ = static_cast<double>(count) * every_;
    mesh_frame_ = 0;
  }
  TextFile file(const Simulation& simulation, const std::string& title) const {
    nlohmann::json document = foldDocument(simulation, title);
    document["file_classes"] = {"singleModel", "animation"};
    document["file_frames"] = frames_;
    return {"frames.fold", foldText(document)};
  }

 private:
  double every_;
  double next_ = 0;
  std::uint32_t revision_ = 0;
  int mesh_frame_ = 0;  ///< which those that follow inherit; 0: none
  std::vector<nlohmann::json> frames_;
};

/// A paper that a recipe folds, and the records of it.
class Folding {
 public:
  Folding(RecipeRunner& runner, Simulation& simulation, double every)
      : frames(every), runner_(runner), simulation_(simulation) {}

  /// Folds to the recipe's end. Returns why it ended early; an empty text: it did not.
  std::string run() {
    ProgressBar bar;
    try {
      while (update()) {
        frames.add(simulation_);
        const StepReport report = simulation_.step();
        if (!report.converged) return report.failure;
        bar.draw(runner_, simulation_);
      }
    } catch (const std::exception& error) {
      return error.what();  // the paper does not take an edit of the recipe
    }
    bar.draw(runner_, simulation_);
    return "";
  }

  Frames frames;
  Sequence sequence;

 private:
  struct BeforeStep {
    Snapshot paper;
    RecipePlace place;
    Sequence sequence;
    std::size_t frames;
  };

  bool update() {
    bool goes_on = true;
    try {
      goes_on = runner_.update(simulation_, [this](const std::vector<Edit>& edits) {
        apply(edits);
        return true;
      });
    } catch (const StepFailed& failed) {
      takeBack(failed);
    }
    for (const std::string& warning : runner_.takeWarnings()) {
      std::cerr << "origami_batch: " << warning << "\n";
    }
    return goes_on;
  }

  void apply(const std::vector<Edit>& edits) {
    const RecipePlace& place = runner_.place();
    // Of all steps only manoeuvres are taken back.
    if (!place.started &&
        std::holds_alternative<ManoeuvreStep>(runner_.recipe().steps[place.step])) {
      before_.emplace(BeforeStep{simulation_.snapshot(), place, sequence, frames.size()});
    }
    sequence.before(edits, runner_, simulation_);
    sequence.after(simulation_.apply(edits), runner_);
  }

  /// \throws std::runtime_error where the step is not to be tried again
  void takeBack(const StepFailed& failed) {
    simulation_ = Simulation(before_->paper);
    sequence = before_->sequence;
    frames.keepFirst(before_->frames);
    if (!runner_.tryAgain(failed, before_->place)) {
      throw std::runtime_error(failed.what() + std::string("; the paper is as it was before"));
    }
  }

  RecipeRunner& runner_;
  Simulation& simulation_;
  std::optional<BeforeStep> before_;
};

int fold(const Options& options) {
  SheetSource sheet;
  if (!isRecipe(options.recipe)) sheet.width = options.width;
  RecipeRunner runner(loadRecipe(options.recipe, {}, sheet, options.overrides));
  std::vector<std::string> notes;
  Simulation simulation = makeSimulation(runner.recipe().sheet, runner.recipe().config, &notes);
  for (const std::string& note : notes) std::cerr << "origami_batch: " << note << "\n";
  Folding folding(runner, simulation, options.every);
  const auto start = std::chrono::steady_clock::now();
  const std::string failure = folding.run();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const std::string& name = runner.recipe().name;
  const std::string folder = expandedPath(options.out);
  writeResults(simulation, {name, wall.count(), failure, runner.place().timeouts}, folder,
               {folding.frames.file(simulation, name), folding.sequence.file(runner, simulation)});
  if (failure.empty()) {
    const std::vector<std::string> sentences = shortfalls(simulation);
    for (const std::string& sentence : sentences)
      std::cerr << "origami_batch: " << sentence << "\n";
    return sentences.empty() ? 0 : kFellShort;
  }
  const std::string crossing = crossingSentence(simulation);
  if (!crossing.empty()) std::cerr << "origami_batch: " << crossing << "\n";
  std::cerr << "origami_batch: ended early, in step " << runner.place().step + 1 << " of "
            << runner.recipe().steps.size() << " at " << simulation.time() << " s: " << failure
            << "\nThe paper as it was then is in " << folder << "\n";
  return kEndedEarly;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  for (const std::string& word : arguments) {
    if (word == "--help" || word == "-h") {
      std::cout << kUsage;
      return 0;
    }
  }
  try {
    return fold(parse(arguments));
  } catch (const std::exception& error) {
    std::cerr << "origami_batch: " << error.what() << "\n";
    return kNothingWritten;
  }
}
