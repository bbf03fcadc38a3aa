#include <shell_origami/origami/recipe_folds.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace shell_origami {
namespace {

/// Reads an angle of degrees into one of radians.
std::function<void(const YAML::Node&)> intoAngle(const RecipeReader& reader, double& into) {
  return [&](const YAML::Node& node) {
    const double angle = reader.number(node, "angle_deg");
    if (!(angle > 0 && angle < 180)) {
      reader.refuseAt(node, "angle_deg ", angle, " is not inside (0, 180)");
    }
    into = angle * kDegree;
  };
}

void readLayers(const RecipeReader& reader, const YAML::Node& node, FoldThrough& fold) {
  if (node.IsScalar() && node.Scalar() == "all") return;
  if (!node.IsMap() || node.size() != 1) {
    reader.refuseAt(node, "layers takes all, or top and their number");
  }
  reader.readMap(node, "layers", {{"top", reader.into(&fold.count, "top")}});
  if (fold.count < 1) reader.refuseAt(node, "top ", fold.count, " is not at least 1");
  fold.layers = FoldLayers::kTop;
}

bool readWay(const RecipeReader& reader, const YAML::Node& node) {
  const std::string way = reader.text(node, "way");
  if (way != "front" && way != "behind") {
    reader.refuseAt(node, "way is '", way, "', not front or behind");
  }
  return way == "behind";
}

/// Handlers of the words that say which layers a fold moves, and which way.
void addLayerHandlers(const RecipeReader& reader, const LandmarkNames& names, FoldThrough& fold,
                      RecipeReader::Handlers& handlers) {
  handlers["layers"] = [&](const YAML::Node& value) { readLayers(reader, value, fold); };
  handlers["flap"] = [&](const YAML::Node& value) {
    fold.layers = FoldLayers::kFlap;
    fold.flap = readLandmark(reader, value, names);
  };
  handlers["way"] = [&](const YAML::Node& value) { fold.behind = readWay(reader, value); };
}

void requireOneChoice(const RecipeReader& reader, const YAML::Node& node, const char* what) {
  if (!node["flap"].IsDefined() || !node["layers"].IsDefined()) return;
  reader.refuseAt(node, what, " takes one of layers and flap, not both");
}

/// The point of a flap, which a manoeuvre cannot do without.
class FlapReader {
 public:
  FlapReader(const RecipeReader& reader, const LandmarkNames& names)
      : reader_(reader), names_(names) {}

  std::function<void(const YAML::Node&)> handler() {
    return [this](const YAML::Node& value) { flap_ = readLandmark(reader_, value, names_); };
  }
  Landmark flap(const YAML::Node& node, const char* what) const {
    if (!flap_) reader_.refuseAt(node, what, " needs flap");
    return *flap_;
  }

 private:
  const RecipeReader& reader_;
  const LandmarkNames& names_;
  std::optional<Landmark> flap_;
};

}  // namespace

std::string readCreaseName(const RecipeReader& reader, const YAML::Node& node) {
  const std::string name = reader.text(node, "name");
  try {
    checkCreaseName(name);
  } catch (const std::invalid_argument& error) {
    reader.refuseAt(node, error.what());
  }
  return name;
}

FoldThrough readFoldThrough(const RecipeReader& reader, const YAML::Node& node,
                            const LandmarkNames& names) {
  FoldThrough fold;
  AxiomReader axiom(reader, names);
  RecipeReader::Handlers handlers = axiom.handlers();
  addLayerHandlers(reader, names, fold, handlers);
  handlers["angle_deg"] = intoAngle(reader, fold.angle);
  handlers["name"] = [&](const YAML::Node& value) { fold.name = readCreaseName(reader, value); };
  reader.readMap(node, "fold_through", handlers);
  requireOneChoice(reader, node, "fold_through");
  fold.axiom = axiom.axiom(node, "fold_through");
  return fold;
}

ManoeuvreStep readPetal(const RecipeReader& reader, const YAML::Node& node,
                        const LandmarkNames& names) {
  ManoeuvreStep step;
  FlapReader flap(reader, names);
  reader.readMap(node, "petal",
                 {{"flap", flap.handler()}, {"angle_deg", intoAngle(reader, step.manner.angle)}});
  step.manoeuvre = std::make_shared<Manoeuvre>(PetalFold{flap.flap(node, "petal")});
  return step;
}

ManoeuvreStep readPleat(const RecipeReader& reader, const YAML::Node& node,
                        const LandmarkNames& names) {
  ManoeuvreStep step;
  PleatFold pleat;
  AxiomReader axiom(reader, names);
  std::optional<std::vector<Landmark>> back;
  RecipeReader::Handlers handlers = axiom.handlers();
  addLayerHandlers(reader, names, pleat.fold, handlers);
  handlers["back"] = [&](const YAML::Node& value) {
    back = readLandmarks(reader, value, 2, "back", names);
  };
  handlers["angle_deg"] = intoAngle(reader, step.manner.angle);
  reader.readMap(node, "pleat", handlers);
  requireOneChoice(reader, node, "pleat");
  if (!back) reader.refuseAt(node, "pleat needs back, two points of a line");
  pleat.fold.axiom = axiom.axiom(node, "pleat");
  pleat.back = {(*back)[0], (*back)[1]};
  step.manoeuvre = std::make_shared<Manoeuvre>(pleat);
  return step;
}

ManoeuvreStep readRabbitEar(const RecipeReader& reader, const YAML::Node& node,
                            const LandmarkNames& names) {
  ManoeuvreStep step;
  FlapReader flap(reader, names);
  std::optional<std::vector<Landmark>> base;
  RabbitEar ear;
  reader.readMap(
      node, "rabbit_ear",
      {{"flap", flap.handler()},
       {"base",
        [&](const YAML::Node& value) { base = readLandmarks(reader, value, 2, "base", names); }},
       {"way", [&](const YAML::Node& value) { ear.behind = readWay(reader, value); }},
       {"angle_deg", intoAngle(reader, step.manner.angle)}});
  if (!base) reader.refuseAt(node, "rabbit_ear needs base, two corners of the flap");
  ear.flap = flap.flap(node, "rabbit_ear");
  ear.base = {(*base)[0], (*base)[1]};
  step.manoeuvre = std::make_shared<Manoeuvre>(ear);
  return step;
}

ManoeuvreStep readSquash(const RecipeReader& reader, const YAML::Node& node,
                         const LandmarkNames& names) {
  ManoeuvreStep step;
  FlapReader flap(reader, names);
  std::optional<Landmark> bring;
  std::optional<std::vector<Landmark>> onto;
  reader.readMap(
      node, "squash",
      {{"flap", flap.handler()},
       {"bring", [&](const YAML::Node& value) { bring = readLandmark(reader, value, names); }},
       {"to",
        [&](const YAML::Node& value) { onto = readLandmarks(reader, value, 2, "to", names); }},
       {"angle_deg", intoAngle(reader, step.manner.angle)}});
  if (!bring) reader.refuseAt(node, "squash needs bring");
  if (!onto) reader.refuseAt(node, "squash needs to, two points of a line");
  step.manoeuvre = std::make_shared<Manoeuvre>(
      SquashFold{flap.flap(node, "squash"), *bring, {(*onto)[0], (*onto)[1]}});
  return step;
}

ManoeuvreStep readReverse(const RecipeReader& reader, const YAML::Node& node,
                          const LandmarkNames& names) {
  ManoeuvreStep step;
  FlapReader flap(reader, names);
  AxiomReader axiom(reader, names);
  ReverseFold reverse;
  RecipeReader::Handlers handlers = axiom.handlers();
  handlers["flap"] = flap.handler();
  handlers["inside"] = reader.into(&reverse.inside, "inside");
  handlers["angle_deg"] = intoAngle(reader, step.manner.angle);
  reader.readMap(node, "reverse", handlers);
  reverse.flap = flap.flap(node, "reverse");
  reverse.axiom = axiom.axiom(node, "reverse", reverse.flap);
  step.manoeuvre = std::make_shared<Manoeuvre>(reverse);
  return step;
}

LoosenStep readLoosen(const RecipeReader& reader, const YAML::Node& node,
                      const LandmarkNames& names) {
  LoosenStep step;
  reader.readMap(node, "loosen",
                 {{"creases",
                   [&](const YAML::Node& value) {
                     if (!value.IsSequence() || value.size() == 0) {
                       reader.refuseAt(value, "creases must be a list of names and lines");
                     }
                     for (const YAML::Node& entry : value) {
                       if (entry.IsScalar()) {
                         step.names.push_back(reader.text(entry, "a crease"));
                         continue;
                       }
                       const auto ends = readLandmarks(reader, entry, 2, "a line", names);
                       step.lines.push_back({ends[0], ends[1]});
                     }
                   }},
                  {"stiffness", [&](const YAML::Node& value) {
                     step.stiffness = reader.number(value, "stiffness");
                   }}});
  if (step.names.empty() && step.lines.empty()) reader.refuseAt(node, "loosen needs creases");
  if (!(step.stiffness > 0)) {
    reader.refuseAt(node, "loosen needs a stiffness over 0, not ", step.stiffness);
  }
  return step;
}

}  // namespace shell_origami
