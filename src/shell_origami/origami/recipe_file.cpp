#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>
#include <shell_origami/origami/bounded_yaml.h>
#include <shell_origami/origami/parameter_table.h>
#include <shell_origami/origami/pattern_recipe.h>
#include <shell_origami/origami/recipe.h>
#include <shell_origami/origami/recipe_obstacles.h>
#include <shell_origami/origami/recipe_reader.h>
#include <shell_origami/origami/recipe_steps.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace shell_origami {
namespace {

namespace fs = std::filesystem;

/// Of a recipe's file.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;

void readSheetPose(const RecipeReader& reader, const YAML::Node& node, SheetSource& sheet) {
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

void readCurvature(const RecipeReader& reader, const YAML::Node& node, NaturalCurvature& roll) {
  reader.readMap(node, "sheet/curvature",
                 {{"value", reader.into(&roll.curvature, "sheet/curvature/value")},
                  {"axis_deg", [&](const YAML::Node& value) {
                     roll.axis = kDegree * reader.number(value, "sheet/curvature/axis_deg");
                   }}});
}

void readSheet(const RecipeReader& reader, const YAML::Node& node, const fs::path& folder,
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
       {"pose", [&](const YAML::Node& value) { readSheetPose(reader, value, sheet); }},
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
RecipeReader::Handlers parametersIn(const std::string& folder, const RecipeReader& reader,
                                    SimulationConfig& config) {
  RecipeReader::Handlers handlers;
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

/// A preset first, wherever it stands: what else is stated overrides it.
void readMaterial(const RecipeReader& reader, const YAML::Node& node, SimulationConfig& config) {
  RecipeReader::Handlers handlers = parametersIn("material/", reader, config);
  handlers["preset"] = [](const YAML::Node&) {};
  if (node.IsMap() && node["preset"]) {
    PaperKind paper = PaperKind::kCopyPaper;
    reader.read(node["preset"], "material/preset", Choice(paperNames(), paper));
    config.material = materialOf(paper);
  }
  reader.readMap(node, "material", handlers);
}

void readView(const RecipeReader& reader, const YAML::Node& node, View& view) {
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

void apply(const Overrides& overrides, const RecipeReader& reader, YAML::Node root) {
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

void readRoot(const RecipeReader& reader, const YAML::Node& root, const fs::path& folder,
              Recipe& recipe) {
  SimulationConfig& config = recipe.config;
  YAML::Node steps, names;
  RecipeReader::Handlers handlers = parametersIn("", reader, config);
  handlers["material"] = [&](const YAML::Node& node) { readMaterial(reader, node, config); };
  for (const std::string group : {"solver", "compliance", "contact"}) {
    handlers[group] = [&reader, &config, group](const YAML::Node& node) {
      reader.readMap(node, group, parametersIn(group + "/", reader, config));
    };
  }
  handlers["sheet"] = [&](const YAML::Node& node) {
    readSheet(reader, node, folder, recipe.sheet, config.rest);
  };
  handlers["view"] = [&](const YAML::Node& node) { readView(reader, node, recipe.view); };
  handlers["precrease"] = reader.into(&recipe.precrease, "precrease");
  handlers["obstacles"] = [&](const YAML::Node& node) {
    recipe.steps.push_back(AddObstacleStep{readObstacles(reader, node, folder.string())});
  };
  handlers["names"] = [&](const YAML::Node& node) { names = node; };
  handlers["steps"] = [&](const YAML::Node& node) { steps = node; };
  reader.readMap(root, "the recipe", handlers);
  for (const auto& entry : root) recipe.stated.insert(entry.first.Scalar());
  if (steps.IsDefined() && !steps.IsNull() && !steps.IsSequence()) {
    reader.refuseAt(steps, "steps must be a list");
  }
  if (recipe.precrease && !recipe.states("sheet")) {
    reader.refuseAt(root["precrease"], "precrease needs the recipe's own sheet");
  }
  if (!names.IsNull()) recipe.names = readNames(reader, names);
  for (const YAML::Node& step : steps) {
    std::optional<double> lasts;
    recipe.steps.push_back(
        readStep(reader, step, config.fold_duration, recipe.names, folder.string(), lasts));
    if (lasts) recipe.lasts[static_cast<int>(recipe.steps.size()) - 1] = *lasts;
  }
}

}  // namespace

bool isRecipe(const std::string& path) {
  const fs::path extension = fs::path(path).extension();
  return extension == ".yaml" || extension == ".yml";
}

Recipe readRecipe(const RecipeText& source, const SimulationConfig& defaults,
                  const SheetSource& sheet, const Overrides& overrides) {
  const RecipeReader reader(source.called);
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
