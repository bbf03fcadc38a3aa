#include <shell_origami/origami/recipe_writer.h>

#include <shell_origami/origami/landmark_text.h>
#include <shell_origami/origami/parameter_table.h>
#include <shell_origami/origami/recipe_obstacles.h>
#include <shell_origami/origami/yaml_text.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <variant>

namespace shell_origami {
namespace {

/// Part of a time step to which times are rounded.
constexpr double kTimeRounding = 1e-3;

struct ValueText {
  std::string operator()(const double* value) const { return numberText(*value); }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const std::string* value) const { return word(*value); }
  std::string operator()(const Vector3* value) const { return numbers(*value); }
  std::string operator()(const Choice& value) const { return value.get(); }
};

struct AxiomText {
  const LandmarkText& text;
  YamlMap& entries;

  void operator()(const BringPoint& bring) const {
    entries.add("bring", text(bring.from)).add("to", text(bring.to));
  }
  void operator()(const BringEdge& bring) const {
    entries.add("edge", text.several(bring.edge)).add("to_edge", text.several(bring.to_edge));
  }
  void operator()(const FoldAcross& across) const {
    entries.add("across", text.several(across.edge)).add("at", text(across.at));
    entries.add("move", text(across.move));
  }
  void operator()(const FoldAlong& along) const {
    entries.add("through", text.several(along.points)).add("move", text(along.move));
  }
};

/// Which layers a fold moves, and which way.
void addLayers(const FoldThrough& fold, const LandmarkText& text, YamlMap& entries) {
  if (fold.layers == FoldLayers::kTop) {
    entries.add("layers", "{top: " + std::to_string(fold.count) + "}");
  }
  if (fold.layers == FoldLayers::kFlap) entries.add("flap", text(fold.flap));
  if (fold.behind) entries.add("way", "behind");
}

struct ManoeuvreText {
  const LandmarkText& text;
  YamlMap& entries;

  void operator()(const PetalFold& petal) const { entries.add("flap", text(petal.flap)); }
  void operator()(const PleatFold& pleat) const {
    std::visit(AxiomText{text, entries}, pleat.fold.axiom);
    entries.add("back", text.several(pleat.back));
    addLayers(pleat.fold, text, entries);
  }
  void operator()(const RabbitEar& ear) const {
    entries.add("flap", text(ear.flap)).add("base", text.several(ear.base));
    if (ear.behind) entries.add("way", "behind");
  }
  void operator()(const SquashFold& squash) const {
    entries.add("flap", text(squash.flap)).add("bring", text(squash.bring));
    entries.add("to", text.several(squash.onto));
  }
  void operator()(const ReverseFold& reverse) const {
    entries.add("flap", text(reverse.flap));
    std::visit(AxiomText{text, entries}, reverse.axiom);
    if (!reverse.inside) entries.add("inside", "false");
  }
};

struct WhereText {
  std::string operator()(const std::vector<std::int64_t>& vertices) const {
    return "{vertices: " + list(vertices, [](std::int64_t v) { return std::to_string(v); }) + "}";
  }
  std::string operator()(const std::vector<Vector2>& places) const {
    return "{points: " + points(places) + "}";
  }
  std::string operator()(const Region& region) const {
    return "{region: " + points(region.corners) + "}";
  }
  /// Recipes have none: a journal notes the vertices in it.
  std::string operator()(const Ball&) const { return "{}"; }
};

/// A step, and its duration where it has one that is not by default.
struct StepText {
  const PaperOrigin& origin;
  const LandmarkText& landmark;

  std::string operator()(const PinStep& step) const {
    return "pin: " + std::visit(WhereText{}, step.where);
  }
  std::string operator()(const UnpinStep& step) const {
    return "unpin: " + (step.where ? std::visit(WhereText{}, *step.where) : "all");
  }
  std::string operator()(const FoldStep& step) const {
    std::string folds;
    for (std::size_t i = 0; i < step.folds.size(); ++i) {
      const auto ends = step.lines.find(i);
      // As far as the opening bracket.
      folds += (folds.empty() ? "" : ",\n           ");
      folds += fold(step.folds[i], ends == step.lines.end() ? "" : landmark.several(ends->second));
    }
    return "fold: [" + folds + "]" + duration(step.duration);
  }
  std::string operator()(const SettleStep& step) const {
    YamlMap entries;
    if (!step.quasi_static || step.timeout != SettleStep().timeout) {
      entries.add("timeout", numberText(step.timeout));
    }
    if (step.quasi_static) entries.add("quasi_static", "true");
    return "settle: " + entries.text();
  }
  std::string operator()(const FoldThroughStep& step) const {
    const FoldThrough& fold = *step.fold;
    YamlMap entries;
    std::visit(AxiomText{landmark, entries}, fold.axiom);
    addLayers(fold, landmark, entries);
    if (fold.angle != kShutAngle) entries.add("angle_deg", degrees(fold.angle));
    if (!fold.name.empty()) entries.add("name", word(fold.name));
    return "fold_through: " + entries.text() + duration(step.duration);
  }
  std::string operator()(const TurnOverStep&) const { return "turn_over: {}"; }
  std::string operator()(const LookStep& step) const { return "look_from: " + numbers(step.from); }
  std::string operator()(const WaitStep& step) const { return "wait: " + seconds(step.seconds); }
  std::string operator()(const AddVertexStep& step) const {
    const auto [a, b] = step.edit.edge;
    return "add_vertex: {edge: [" + std::to_string(a) + ", " + std::to_string(b) +
           "], fraction: " + numberText(step.edit.fraction) + "}";
  }
  std::string operator()(const StopStep&) const { return "stop: {}"; }
  std::string operator()(const ConfigureStep& step) const {
    YamlMap entries;
    if (step.gravity) entries.add("gravity", numbers(*step.gravity));
    if (step.air_damping) entries.add("air_damping", numberText(*step.air_damping));
    if (step.fold_duration) entries.add("fold_duration", numberText(*step.fold_duration));
    return "configure: " + entries.text();
  }

  std::string operator()(const ManoeuvreStep& step) const {
    YamlMap entries;
    std::visit(ManoeuvreText{landmark, entries}, *step.manoeuvre);
    if (step.manner.angle != kShutAngle) entries.add("angle_deg", degrees(step.manner.angle));
    const double by_default = origin.config.fold_duration * lengthOf(*step.manoeuvre);
    return std::string(wordOf(*step.manoeuvre)) + ": " + entries.text() +
           duration(step.manner.duration, by_default);
  }
  std::string operator()(const UnfoldStep& step) const {
    return "unfold: {step: last}" + duration(step.duration);
  }
  std::string operator()(const LoosenStep& step) const {
    std::string creases;
    const auto add = [&](const std::string& crease) {
      creases += (creases.empty() ? "" : ", ") + crease;
    };
    for (const std::string& name : step.names) add(word(name));
    for (const auto& ends : step.lines) add(landmark.several(ends));
    YamlMap entries;
    entries.add("creases", "[" + creases + "]").add("stiffness", numberText(step.stiffness));
    return "loosen: " + entries.text();
  }
  std::string operator()(const AddObstacleStep& step) const {
    return "add_obstacle: " + list(step.obstacles, obstacleText);
  }
  std::string operator()(const RemoveObstacleStep& step) const {
    return "remove_obstacle: " + (step.ids.empty() ? "all" : list(step.ids, word));
  }
  std::string operator()(const GraspStep& step) const {
    const Firmness& firmness = step.edit.firmness;
    YamlMap entries;
    entries.add("id", word(step.edit.id));
    // Without its braces.
    const std::string where = std::visit(WhereText{}, step.edit.where);
    const std::size_t colon = where.find(": ");
    entries.add(where.substr(1, colon - 1), where.substr(colon + 2, where.size() - colon - 3));
    entries.add("stiffness", numberText(firmness.stiffness));
    entries.add("max_force", numberText(firmness.max_force));
    entries.add("reach", numberText(firmness.reach));
    return "grasp: " + entries.text();
  }
  std::string operator()(const ReleaseStep& step) const {
    return "release: " + (step.ids.empty() ? "all" : list(step.ids, word));
  }
  std::string operator()(const MoveObstacleStep& step) const {
    YamlMap pose, entries;
    addPose(step.pose, pose);
    entries.add("id", word(step.id)).add("move", pose.text());
    return "obstacle: " + entries.text() + duration(step.duration);
  }

  /// A time in as few digits as tell its number of steps.
  std::string seconds(double time) const {
    const double rounding = kTimeRounding * origin.config.solver.time_step;
    for (double unit = 1; unit < 1e12; unit *= 10) {
      const double rounded = std::round(time * unit) / unit;
      if (std::abs(rounded - time) < rounding) return numberText(rounded);
    }
    return numberText(time);
  }

 private:
  std::string duration(double time) const { return duration(time, origin.config.fold_duration); }
  static std::string duration(double time, double by_default) {
    if (time == by_default) return "";
    return "\n    duration: " + numberText(time);
  }

  /// \param ends  of its line, where landmarks give them; else empty
  std::string fold(const FoldEdit& edit, const std::string& ends) const {
    YamlMap entries;
    if (!ends.empty()) {
      entries.add("line", ends);
    } else if (const auto* line = std::get_if<Segment>(&edit.where)) {
      entries.add("line", points({(*line)[0], (*line)[1]}));
    } else if (const auto* crease = std::get_if<CreaseName>(&edit.where)) {
      entries.add("crease", word(crease->name));
    }
    if (edit.part > 0) entries.add("part", numberText(edit.part));
    else entries.add("angle_deg", degrees(edit.angle));
    if (edit.stiffness && *edit.stiffness != origin.config.material.crease_stiffness) {
      entries.add("stiffness", numberText(*edit.stiffness));
    }
    if (!edit.name.empty()) entries.add("name", word(edit.name));
    return entries.text();
  }
};

std::string sheetText(const PaperOrigin& origin) {
  const SheetSource& sheet = origin.sheet;
  YamlMap entries;
  if (sheet.pattern.empty()) {
    entries.add("size", numbers(Vector2(sheet.width, sheet.height)));
  } else {
    entries.add("pattern", word(std::filesystem::absolute(sheet.pattern).string()));
    if (sheet.form == FoldForm::kFlat) entries.add("form", "flat");
    if (sheet.pattern_width != 0) entries.add("width", numberText(sheet.pattern_width));
    else if (sheet.scale != 0) entries.add("scale", numberText(sheet.scale));
  }
  entries.add("max_edge", numberText(sheet.max_edge));
  if (!sheet.position.isZero(0) || !sheet.roll_pitch_yaw.isZero(0)) {
    const Vector3& angles = sheet.roll_pitch_yaw;
    YamlMap pose;
    pose.add("position", numbers(sheet.position));
    pose.add("rpy_deg", "[" + degrees(angles.x()) + ", " + degrees(angles.y()) + ", " +
                            degrees(angles.z()) + "]");
    entries.add("pose", pose.text());
  }
  const NaturalCurvature& roll = origin.config.rest;
  if (roll.curvature != 0) {
    YamlMap curvature;
    curvature.add("value", numberText(roll.curvature)).add("axis_deg", degrees(roll.axis));
    entries.add("curvature", curvature.text());
  }
  return "sheet: " + entries.text() + "\n";
}

/// The parameters that are not as by default, each group in a line.
std::string parametersText(SimulationConfig config) {
  SimulationConfig defaults;
  std::vector<std::string> order;
  std::map<std::string, YamlMap> groups;
  std::string text;
  for (const auto& parameter : simulationParameters()) {
    const std::string value = std::visit(ValueText{}, parameter.place(config));
    if (value == std::visit(ValueText{}, parameter.place(defaults))) continue;
    const std::size_t slash = parameter.name.find('/');
    if (slash == std::string::npos) {
      text += parameter.name + ": " + value + "\n";
      continue;
    }
    const std::string group = parameter.name.substr(0, slash);
    if (groups.count(group) == 0) order.push_back(group);
    groups[group].add(parameter.name.substr(slash + 1), value);
  }
  std::string grouped;
  for (const std::string& group : order) grouped += group + ": " + groups[group].text() + "\n";
  return grouped + text;
}

}  // namespace

std::string recipeText(const PaperOrigin& origin, const std::vector<WrittenStep>& steps) {
  std::string text = sheetText(origin) + parametersText(origin.config);
  const LandmarkText landmark(origin.names);
  if (!origin.names.empty()) text += "names:\n" + namesText(origin.names);
  text += steps.empty() ? "steps: []\n" : "steps:\n";
  const StepText step_text{origin, landmark};
  for (const auto& [step, lasts, frame] : steps) {
    if (!frame.empty()) {
      text += "  # frame " + word(frame) + " carried this; a recipe holds it in place\n";
    }
    text += "  - " + std::visit(step_text, step) + "\n";
    if (lasts) text += "    lasts: " + step_text.seconds(*lasts) + "\n";
  }
  return text;
}

}  // namespace shell_origami
