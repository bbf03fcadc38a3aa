#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>
#include <shell_origami/origami/bounded_yaml.h>
#include <shell_origami/origami/parameter_table.h>
#include <shell_origami/origami/recipe.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace shell_origami {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = M_PI / 180;
/// Of a recipe's file.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
/// Of a pattern that is folded without a recipe: edges of its mesh across its width, and the time
/// that it has to settle [s].
constexpr double kEdgesOfAWidth = 10, kPatternTimeout = 10;

/// A recipe's file while it is read: knows where it is, for its complaints.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  template <class... Parts>
  [[noreturn]] void refuseAt(const YAML::Node& node, const Parts&... parts) const {
    const int line = node.Mark().line;
    if (line >= 0) reject(file_, ", line ", line + 1, ": ", parts...);
    reject(file_, ": ", parts...);
  }

  using Handlers = std::map<std::string, std::function<void(const YAML::Node&)>>;
  /// Hands each entry of the map to its handler. Unknown words are refused.
  void readMap(const YAML::Node& node, const std::string& what, const Handlers& handlers) const {
    if (!node.IsMap()) refuseAt(node, what, " must be a map of key: value");
    for (const auto& entry : node) {
      const std::string key = text(entry.first, what);
      const auto handler = handlers.find(key);
      if (handler == handlers.end()) refuseAt(entry.first, what, " knows no '", key, "'");
      handler->second(entry.second);
    }
  }

  std::string text(const YAML::Node& node, const std::string& what) const {
    countValue();
    if (!node.IsScalar()) refuseAt(node, what, " must be a word");
    return node.Scalar();
  }

  double number(const YAML::Node& node, const std::string& what) const {
    countValue();
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
      refuseAt(node, what, " must be a finite number",
               node.IsScalar() ? ", not '" + node.Scalar() + "'" : "");
    }
    return value;
  }

  bool truth(const YAML::Node& node, const std::string& what) const {
    bool value = false;
    if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value)) {
      refuseAt(node, what, " must be true or false");
    }
    return value;
  }

  // Each reads a value into its place.
  void read(const YAML::Node& node, const std::string& what, double* value) const {
    *value = number(node, what);
  }
  void read(const YAML::Node& node, const std::string& what, int* value) const {
    const double count = number(node, what);
    if (count != std::floor(count) || std::abs(count) > 1e9) {
      refuseAt(node, what, " must be an integer, not ", count);
    }
    *value = static_cast<int>(count);
  }
  void read(const YAML::Node& node, const std::string& what, bool* value) const {
    *value = truth(node, what);
  }
  void read(const YAML::Node& node, const std::string& what, std::string* value) const {
    *value = text(node, what);
  }
  void read(const YAML::Node& node, const std::string& what, Vector3* value) const {
    const std::vector<double> list = numbers(node, 3, what);
    *value = {list[0], list[1], list[2]};
  }
  void read(const YAML::Node& node, const std::string& what, const Choice& choice) const {
    if (choice.set(text(node, what))) return;
    refuseAt(node, what, " must be ", choice.text(), ", not '", node.Scalar(), "'");
  }

  std::vector<double> numbers(const YAML::Node& node, std::size_t count,
                              const std::string& what) const {
    if (!node.IsSequence() || node.size() != count) {
      refuseAt(node, what, " must be a list of ", count, " numbers");
    }
    std::vector<double> values;
    for (const YAML::Node& entry : node) values.push_back(number(entry, what));
    return values;
  }

  std::vector<Vector2> points(const YAML::Node& node, const std::string& what) const {
    if (!node.IsSequence() || node.size() == 0) {
      refuseAt(node, what, " must be a list of points [x, y]");
    }
    std::vector<Vector2> points;
    for (const YAML::Node& entry : node) {
      const std::vector<double> p = numbers(entry, 2, what);
      points.emplace_back(p[0], p[1]);
    }
    return points;
  }

  std::function<void(const YAML::Node&)> into(const Place& place, const std::string& what) const {
    return [this, place, what](const YAML::Node& node) {
      std::visit([&](const auto& value) { read(node, what, value); }, place);
    };
  }

 private:
  void countValue() const {
    if (++values_ > kMostYamlValues)
      reject(file_, ": it holds more than ", kMostYamlValues, " values");
  }

  std::string file_;
  mutable std::size_t values_ = 0;  ///< read so far
};

void readPose(const Reader& reader, const YAML::Node& node, SheetSource& sheet) {
  reader.readMap(node, "sheet/pose",
                 {{"position",
                   [&](const YAML::Node& value) {
                     const auto p = reader.numbers(value, 3, "sheet/pose/position");
                     sheet.position = {p[0], p[1], p[2]};
                   }},
                  {"rpy_deg", [&](const YAML::Node& value) {
                     const auto angles = reader.numbers(value, 3, "sheet/pose/rpy_deg");
                     sheet.roll_pitch_yaw = kDegree * Vector3(angles[0], angles[1], angles[2]);
                   }}});
}

void readCurvature(const Reader& reader, const YAML::Node& node, NaturalCurvature& roll) {
  reader.readMap(node, "sheet/curvature",
                 {{"value", reader.into(&roll.curvature, "sheet/curvature/value")},
                  {"axis_deg", [&](const YAML::Node& value) {
                     roll.axis = kDegree * reader.number(value, "sheet/curvature/axis_deg");
                   }}});
}

void readSheet(const Reader& reader, const YAML::Node& node, const fs::path& folder,
               SheetSource& sheet, NaturalCurvature& roll) {
  reader.readMap(
      node, "sheet",
      {{"size",
        [&](const YAML::Node& value) {
          const auto size = reader.numbers(value, 2, "sheet/size");
          sheet.width = size[0];
          sheet.height = size[1];
        }},
       {"max_edge", reader.into(&sheet.max_edge, "sheet/max_edge")},
       {"pattern",
        [&](const YAML::Node& value) {
          sheet.pattern = (folder / expandedPath(reader.text(value, "sheet/pattern"))).string();
        }},
       {"form",
        [&](const YAML::Node& value) {
          static const std::map<std::string, FoldForm> kForms{{"flat", FoldForm::kFlat},
                                                              {"folded", FoldForm::kFolded}};
          reader.read(value, "sheet/form", Choice(kForms, sheet.form));
        }},
       {"scale", reader.into(&sheet.scale, "sheet/scale")},
       {"width", reader.into(&sheet.pattern_width, "sheet/width")},
       {"pose", [&](const YAML::Node& value) { readPose(reader, value, sheet); }},
       {"curvature", [&](const YAML::Node& value) { readCurvature(reader, value, roll); }}});
  if (sheet.pattern_width == 0) return;
  if (sheet.pattern.empty()) {
    reader.refuseAt(node, "sheet/width is for a pattern; a rectangle has a size");
  }
  if (sheet.scale != 0) {
    reader.refuseAt(node, "sheet has a width and a scale, of which each is enough");
  }
}

/// The handlers of every parameter in a folder, such as "material/".
Reader::Handlers parametersIn(const std::string& folder, const Reader& reader,
                              SimulationConfig& config) {
  Reader::Handlers handlers;
  for (const auto& parameter : simulationParameters()) {
    const std::string& name = parameter.name;
    if (name.compare(0, folder.size(), folder) != 0) continue;
    const std::string key = name.substr(folder.size());
    if (key.find('/') == std::string::npos) {
      handlers[key] = reader.into(parameter.place(config), name);
    }
  }
  return handlers;
}

void readView(const Reader& reader, const YAML::Node& node, View& view) {
  const auto degrees = [&reader](double& angle, const std::string& what) {
    return [&reader, &angle, what](const YAML::Node& value) {
      angle = reader.number(value, what) * kDegree;
    };
  };
  reader.readMap(node, "view",
                 {{"yaw_deg", degrees(view.yaw, "yaw_deg")},
                  {"pitch_deg", degrees(view.pitch, "pitch_deg")},
                  {"distance", reader.into(&view.distance, "distance")}});
}

FoldEdit readFoldEntry(const Reader& reader, const YAML::Node& node) {
  FoldEdit fold;
  bool has_place = false;
  int angles = 0;
  const auto place = [&](const YAML::Node& value) {
    if (has_place) reader.refuseAt(value, "a fold takes one of line and crease, not both");
    has_place = true;
  };
  reader.readMap(
      node, "a fold",
      {{"line",
        [&](const YAML::Node& value) {
          place(value);
          const auto ends = reader.points(value, "line");
          if (ends.size() != 2) reader.refuseAt(value, "a line has two ends");
          fold.where = Segment{ends[0], ends[1]};
        }},
       {"crease",
        [&](const YAML::Node& value) {
          place(value);
          fold.where = CreaseName{reader.text(value, "crease")};
        }},
       {"angle_deg",
        [&](const YAML::Node& value) {
          const double angle = reader.number(value, "angle_deg");
          if (!(std::abs(angle) < 180)) {
            reader.refuseAt(value, "angle_deg ", angle, " is not inside (-180, 180)");
          }
          fold.angle = angle * kDegree;
          ++angles;
        }},
       {"part",
        [&](const YAML::Node& value) {
          fold.part = reader.number(value, "part");
          if (!(fold.part >= 0 && fold.part <= 1)) {
            reader.refuseAt(value, "part ", fold.part, " is not from 0 to 1");
          }
          ++angles;
        }},
       {"stiffness",
        [&](const YAML::Node& value) { fold.stiffness = reader.number(value, "stiffness"); }},
       {"name", [&](const YAML::Node& value) {
          fold.name = reader.text(value, "name");
          try {
            checkCreaseName(fold.name);
          } catch (const std::invalid_argument& error) {
            reader.refuseAt(value, error.what());
          }
        }}});
  if (!has_place) reader.refuseAt(node, "a fold needs a line or a crease");
  if (angles != 1) reader.refuseAt(node, "a fold needs either angle_deg or part");
  return fold;
}

PinStep readPin(const Reader& reader, const YAML::Node& node) {
  PinStep pin;
  if (node.IsMap() && node.size() != 1) reader.refuseAt(node, "pin takes one of region and points");
  reader.readMap(
      node, "pin",
      {{"region",
        [&](const YAML::Node& value) { pin.where = Region{reader.points(value, "region")}; }},
       {"points", [&](const YAML::Node& value) { pin.where = reader.points(value, "points"); }}});
  return pin;
}

UnpinStep readUnpin(const Reader& reader, const YAML::Node& node) {
  UnpinStep unpin;
  if (node.IsScalar() && node.Scalar() == "all") return unpin;
  if (!node.IsMap() || node.size() != 1) reader.refuseAt(node, "unpin takes all or points");
  reader.readMap(node, "unpin", {{"points", [&](const YAML::Node& value) {
                                    unpin.points = reader.points(value, "points");
                                  }}});
  return unpin;
}

double readSeconds(const Reader& reader, const YAML::Node& node, const std::string& what) {
  const double seconds = reader.number(node, what);
  if (seconds < 0) reader.refuseAt(node, what, " ", seconds, " s is negative");
  return seconds;
}

RecipeStep readStep(const Reader& reader, const YAML::Node& node, double fold_duration) {
  std::vector<RecipeStep> steps;
  double duration = fold_duration;
  bool has_duration = false;
  reader.readMap(
      node, "a step",
      {{"pin", [&](const YAML::Node& value) { steps.push_back(readPin(reader, value)); }},
       {"unpin", [&](const YAML::Node& value) { steps.push_back(readUnpin(reader, value)); }},
       {"fold",
        [&](const YAML::Node& value) {
          if (!value.IsSequence() || value.size() == 0) {
            reader.refuseAt(value, "fold must be a list of folds");
          }
          FoldStep step;
          for (const YAML::Node& entry : value) step.folds.push_back(readFoldEntry(reader, entry));
          steps.push_back(step);
        }},
       {"duration",
        [&](const YAML::Node& value) {
          duration = readSeconds(reader, value, "duration");
          has_duration = true;
        }},
       {"settle", [&](const YAML::Node& value) {
          SettleStep step;
          reader.readMap(value, "settle",
                         {{"timeout",
                           [&](const YAML::Node& timeout) {
                             step.timeout = readSeconds(reader, timeout, "timeout");
                           }},
                          {"quasi_static", [&](const YAML::Node& at_once) {
                             step.quasi_static = reader.truth(at_once, "quasi_static");
                           }}});
          steps.push_back(step);
        }}});
  if (steps.size() != 1) {
    reader.refuseAt(node, "a step does one thing: pin, unpin, fold or settle, not ", steps.size());
  }
  FoldStep* fold = std::get_if<FoldStep>(&steps[0]);
  if (has_duration && !fold) reader.refuseAt(node, "duration belongs to a fold");
  if (fold) fold->duration = duration;
  return steps[0];
}

void apply(const Overrides& overrides, const Reader& reader, YAML::Node root) {
  for (const auto& [key, value] : overrides) {
    YAML::Node place = root;
    std::size_t start = 0;
    for (std::size_t end; (end = key.find('/', start)) != std::string::npos; start = end + 1) {
      place.reset(place[key.substr(start, end - start)]);
      if (place.IsDefined() && !place.IsMap() && !place.IsNull()) {
        reader.refuseAt(place, "'", key, "' does not lead to a value");
      }
    }
    place[key.substr(start)] = loadBoundedYaml(value);
  }
}

void readRoot(const Reader& reader, const YAML::Node& root, const fs::path& folder,
              Recipe& recipe) {
  SimulationConfig& config = recipe.config;
  YAML::Node steps;
  Reader::Handlers handlers = parametersIn("", reader, config);
  for (const std::string group : {"material", "solver", "compliance", "contact"}) {
    handlers[group] = [&reader, &config, group](const YAML::Node& node) {
      reader.readMap(node, group, parametersIn(group + "/", reader, config));
    };
  }
  handlers["sheet"] = [&](const YAML::Node& node) {
    readSheet(reader, node, folder, recipe.sheet, config.rest);
  };
  handlers["view"] = [&](const YAML::Node& node) { readView(reader, node, recipe.view); };
  handlers["steps"] = [&](const YAML::Node& node) { steps = node; };
  reader.readMap(root, "the recipe", handlers);
  for (const auto& entry : root) recipe.stated.insert(entry.first.Scalar());
  if (steps.IsDefined() && !steps.IsNull() && !steps.IsSequence()) {
    reader.refuseAt(steps, "steps must be a list");
  }
  for (const YAML::Node& step : steps) {
    recipe.steps.push_back(readStep(reader, step, config.fold_duration));
  }
}

/// Writes the recipe that folds a pattern.
RecipeText patternRecipe(const std::string& path, double width) {
  const fs::path file = fs::absolute(expandedPath(path));
  std::string quoted;
  for (const char c : file.string()) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "sheet: {pattern: '" << quoted << "', form: flat, width: " << width
       << ", max_edge: " << width / kEdgesOfAWidth << "}\n"
       << "steps:\n"
       << "  - fold: [{crease: all, part: 1}]\n"
       << "  - settle: {timeout: " << kPatternTimeout << "}\n";
  return {path, file.parent_path().string(), text.str()};
}

}  // namespace

bool isRecipe(const std::string& path) {
  const fs::path extension = fs::path(path).extension();
  return extension == ".yaml" || extension == ".yml";
}

Recipe readRecipe(const RecipeText& source, const SimulationConfig& defaults,
                  const SheetSource& sheet, const Overrides& overrides) {
  const Reader reader(source.called);
  Recipe recipe;
  recipe.source = source;
  recipe.name = fs::path(source.called).stem().string();
  recipe.config = recipe.defaults = defaults;
  recipe.sheet = sheet;
  try {
    YAML::Node root = loadBoundedYaml(source.text);
    apply(overrides, reader, root);
    readRoot(reader, root, source.folder, recipe);
  } catch (const YAML::Exception& error) {
    reject(source.called, ", line ", error.mark.line + 1, ": ", error.msg);
  }
  try {
    checkConfig(recipe.config);
  } catch (const std::invalid_argument& error) {
    reject(source.called, ": ", error.what());
  }
  return recipe;
}

Recipe loadRecipe(const std::string& path, const SimulationConfig& defaults,
                  const SheetSource& sheet, const Overrides& overrides) {
  if (!isRecipe(path)) {
    return readRecipe(patternRecipe(path, sheet.width), defaults, sheet, overrides);
  }
  const std::string file = expandedPath(path);
  std::string text;
  try {
    text = readFile(file, kMostBytes);
  } catch (const std::invalid_argument& error) {
    reject(path, ": ", error.what());
  }
  return readRecipe({path, fs::path(file).parent_path().string(), text}, defaults, sheet,
                    overrides);
}

}  // namespace shell_origami
