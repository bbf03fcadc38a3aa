#include <shell_origami/origami/recipe_steps.h>

#include <shell_origami/origami/recipe_obstacles.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

/// A line that is given by two points, which may be off the paper.
Segment readLine(const RecipeReader& reader, const YAML::Node& node) {
  const auto ends = reader.points(node, "line");
  if (ends.size() != 2) reader.refuseAt(node, "a line has two ends");
  return {ends[0], ends[1]};
}

void readFoldEntry(const RecipeReader& reader, const YAML::Node& node, const LandmarkNames& names,
                   FoldStep& step) {
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
          if (value.IsSequence() && value.size() > 0 && value[0].IsSequence()) {
            fold.where = readLine(reader, value);
            return;
          }
          const auto ends = readLandmarks(reader, value, 2, "a line", names);
          step.lines[step.folds.size()] = {ends[0], ends[1]};
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
       {"name", [&](const YAML::Node& value) { fold.name = readCreaseName(reader, value); }}});
  if (!has_place) reader.refuseAt(node, "a fold needs a line or a crease");
  if (angles != 1) reader.refuseAt(node, "a fold needs either angle_deg or part");
  step.folds.push_back(std::move(fold));
}

std::vector<std::int64_t> readVertices(const RecipeReader& reader, const YAML::Node& node) {
  if (!node.IsSequence() || node.size() == 0) {
    reader.refuseAt(node, "vertices must be a list of their numbers");
  }
  std::vector<std::int64_t> vertices;
  for (const YAML::Node& entry : node) {
    int vertex = 0;
    reader.read(entry, "a vertex", &vertex);
    vertices.push_back(vertex);
  }
  return vertices;
}

PinWhere readWhere(const RecipeReader& reader, const YAML::Node& node, const std::string& what) {
  if (node.IsMap() && node.size() != 1) {
    reader.refuseAt(node, what, " takes one of region, points and vertices");
  }
  PinWhere where;
  reader.readMap(
      node, what,
      {{"region", [&](const YAML::Node& value) { where = Region{reader.points(value, "region")}; }},
       {"points", [&](const YAML::Node& value) { where = reader.points(value, "points"); }},
       {"vertices", [&](const YAML::Node& value) { where = readVertices(reader, value); }}});
  return where;
}

UnpinStep readUnpin(const RecipeReader& reader, const YAML::Node& node) {
  if (node.IsScalar() && node.Scalar() == "all") return {};
  if (!node.IsMap()) reader.refuseAt(node, "unpin takes all, region, points or vertices");
  return {readWhere(reader, node, "unpin")};
}

AddVertexStep readAddVertex(const RecipeReader& reader, const YAML::Node& node) {
  AddVertexStep step;
  bool has_edge = false, has_fraction = false;
  reader.readMap(node, "add_vertex",
                 {{"edge",
                   [&](const YAML::Node& value) {
                     const std::vector<std::int64_t> ends = readVertices(reader, value);
                     if (ends.size() != 2) reader.refuseAt(value, "an edge has two vertices");
                     step.edit.edge = {ends[0], ends[1]};
                     has_edge = true;
                   }},
                  {"fraction", [&](const YAML::Node& value) {
                     step.edit.fraction = reader.number(value, "fraction");
                     has_fraction = true;
                   }}});
  if (!has_edge || !has_fraction) reader.refuseAt(node, "add_vertex needs edge and fraction");
  return step;
}

ConfigureStep readConfigure(const RecipeReader& reader, const YAML::Node& node) {
  ConfigureStep step;
  const auto number = [&reader](std::optional<double>& place, const char* what) {
    return [&reader, &place, what](const YAML::Node& value) { place = reader.number(value, what); };
  };
  reader.readMap(node, "configure",
                 {{"gravity",
                   [&](const YAML::Node& value) {
                     step.gravity.emplace();
                     reader.read(value, "gravity", &*step.gravity);
                   }},
                  {"air_damping", number(step.air_damping, "air_damping")},
                  {"fold_duration", number(step.fold_duration, "fold_duration")}});
  return step;
}

double readSeconds(const RecipeReader& reader, const YAML::Node& node, const std::string& what) {
  const double seconds = reader.number(node, what);
  if (seconds < 0) reader.refuseAt(node, what, " ", seconds, " s is negative");
  return seconds;
}

MoveObstacleStep readMoveObstacle(const RecipeReader& reader, const YAML::Node& node) {
  MoveObstacleStep step;
  bool moves = false;
  reader.readMap(node, "obstacle",
                 {{"id", reader.into(&step.id, "id")}, {"move", [&](const YAML::Node& value) {
                                                          step.pose =
                                                              readPose(reader, value, "move");
                                                          moves = true;
                                                        }}});
  if (step.id.empty() || !moves) reader.refuseAt(node, "obstacle needs id and move");
  return step;
}

/// Reads an id, a list of them, or `all`, which is none.
std::vector<std::string> readIds(const RecipeReader& reader, const YAML::Node& node,
                                 const std::string& what) {
  std::vector<std::string> ids;
  if (node.IsSequence()) {
    for (const YAML::Node& id : node) ids.push_back(reader.text(id, "an id"));
    if (ids.empty()) reader.refuseAt(node, what, " takes all, an id or several");
    return ids;
  }
  const std::string id = reader.text(node, what);
  if (id != "all") ids = {id};
  return ids;
}

GraspStep readGrasp(const RecipeReader& reader, const YAML::Node& node) {
  GraspStep step;
  Firmness& firmness = step.edit.firmness;
  YAML::Node where(YAML::NodeType::Map);
  RecipeReader::Handlers handlers{{"id", reader.into(&step.edit.id, "id")},
                                  {"stiffness", reader.into(&firmness.stiffness, "stiffness")},
                                  {"max_force", reader.into(&firmness.max_force, "max_force")},
                                  {"reach", reader.into(&firmness.reach, "reach")}};
  for (const std::string key : {"region", "points", "vertices"}) {
    handlers[key] = [&where, key](const YAML::Node& value) { where[key] = value; };
  }
  reader.readMap(node, "grasp", handlers);
  if (step.edit.id.empty()) reader.refuseAt(node, "a grasp needs an id");
  if (where.size() != 1) {
    reader.refuseAt(node, "grasp takes one of region, points and vertices");
  }
  step.edit.where = readWhere(reader, where, "grasp");
  return step;
}

constexpr const char* kSteps =
    "pin, unpin, fold, fold_through, petal, pleat, rabbit_ear, squash, reverse, unfold, loosen, "
    "turn_over, look_from, settle, wait, add_vertex, stop, configure, add_obstacle, obstacle, "
    "remove_obstacle, grasp or release";

/// The duration that a recipe may state of a step; null: none.
struct Duration {
  double* operator()(FoldStep& step) const { return &step.duration; }
  double* operator()(FoldThroughStep& step) const { return &step.duration; }
  double* operator()(ManoeuvreStep& step) const { return &step.manner.duration; }
  double* operator()(UnfoldStep& step) const { return &step.duration; }
  double* operator()(MoveObstacleStep& step) const { return &step.duration; }
  template <class Other>
  double* operator()(Other&) const {
    return nullptr;
  }
};

}  // namespace

RecipeStep readStep(const RecipeReader& reader, const YAML::Node& node, double fold_duration,
                    const LandmarkNames& names, const std::string& folder,
                    std::optional<double>& lasts) {
  std::vector<RecipeStep> steps;
  double duration = fold_duration;
  bool has_duration = false;
  reader.readMap(
      node, "a step",
      {{"pin",
        [&](const YAML::Node& value) {
          steps.push_back(PinStep{readWhere(reader, value, "pin")});
        }},
       {"unpin", [&](const YAML::Node& value) { steps.push_back(readUnpin(reader, value)); }},
       {"fold",
        [&](const YAML::Node& value) {
          if (!value.IsSequence() || value.size() == 0) {
            reader.refuseAt(value, "fold must be a list of folds");
          }
          FoldStep step;
          for (const YAML::Node& entry : value) readFoldEntry(reader, entry, names, step);
          steps.push_back(step);
        }},
       {"fold_through",
        [&](const YAML::Node& value) {
          steps.push_back(FoldThroughStep{
              std::make_shared<FoldThrough>(readFoldThrough(reader, value, names))});
        }},
       {"petal",
        [&](const YAML::Node& value) { steps.push_back(readPetal(reader, value, names)); }},
       {"pleat",
        [&](const YAML::Node& value) { steps.push_back(readPleat(reader, value, names)); }},
       {"rabbit_ear",
        [&](const YAML::Node& value) { steps.push_back(readRabbitEar(reader, value, names)); }},
       {"squash",
        [&](const YAML::Node& value) { steps.push_back(readSquash(reader, value, names)); }},
       {"reverse",
        [&](const YAML::Node& value) { steps.push_back(readReverse(reader, value, names)); }},
       {"loosen",
        [&](const YAML::Node& value) { steps.push_back(readLoosen(reader, value, names)); }},
       {"unfold",
        [&](const YAML::Node& value) {
          reader.readMap(value, "unfold", {{"step", [&](const YAML::Node& which) {
                                              if (reader.text(which, "step") == "last") return;
                                              reader.refuseAt(which, "unfold takes step: last");
                                            }}});
          steps.push_back(UnfoldStep{});
        }},
       {"turn_over",
        [&](const YAML::Node& value) {
          reader.readMap(value, "turn_over", {});
          steps.push_back(TurnOverStep{});
        }},
       {"look_from",
        [&](const YAML::Node& value) {
          LookStep step;
          reader.read(value, "look_from", &step.from);
          steps.push_back(step);
        }},
       {"wait",
        [&](const YAML::Node& value) {
          steps.push_back(WaitStep{readSeconds(reader, value, "wait")});
        }},
       {"add_vertex",
        [&](const YAML::Node& value) { steps.push_back(readAddVertex(reader, value)); }},
       {"stop",
        [&](const YAML::Node& value) {
          reader.readMap(value, "stop", {});
          steps.push_back(StopStep{});
        }},
       {"configure",
        [&](const YAML::Node& value) { steps.push_back(readConfigure(reader, value)); }},
       {"add_obstacle",
        [&](const YAML::Node& value) {
          steps.push_back(AddObstacleStep{readObstacles(reader, value, folder)});
        }},
       {"obstacle",
        [&](const YAML::Node& value) { steps.push_back(readMoveObstacle(reader, value)); }},
       {"remove_obstacle",
        [&](const YAML::Node& value) {
          steps.push_back(RemoveObstacleStep{readIds(reader, value, "remove_obstacle")});
        }},
       {"grasp", [&](const YAML::Node& value) { steps.push_back(readGrasp(reader, value)); }},
       {"release",
        [&](const YAML::Node& value) {
          steps.push_back(ReleaseStep{readIds(reader, value, "release")});
        }},
       {"lasts", [&](const YAML::Node& value) { lasts = readSeconds(reader, value, "lasts"); }},
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
    reader.refuseAt(node, "a step does one thing: ", kSteps, ", not ", steps.size());
  }
  double* length = std::visit(Duration{}, steps[0]);
  if (has_duration && !length) reader.refuseAt(node, "duration belongs to a fold or a move");
  const auto* manoeuvre = std::get_if<ManoeuvreStep>(&steps[0]);
  if (manoeuvre && !has_duration) duration = fold_duration * lengthOf(*manoeuvre->manoeuvre);
  if (length) *length = duration;
  return steps[0];
}

}  // namespace shell_origami
