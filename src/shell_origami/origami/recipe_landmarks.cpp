#include <shell_origami/origami/recipe_landmarks.h>

namespace shell_origami {
namespace {

Vector2 readPoint(const RecipeReader& reader, const YAML::Node& node) {
  const std::vector<double> numbers = reader.numbers(node, 2, "a point");
  return {numbers[0], numbers[1]};
}

Landmark readNamed(const RecipeReader& reader, const YAML::Node& node, const LandmarkNames& names) {
  const std::string name = reader.text(node, "a point");
  const auto found = names.find(name);
  if (found == names.end()) reader.refuseAt(node, "'", name, "' is none of the recipe's names");
  return {found->second.place, name};
}

}  // namespace

Landmark readLandmark(const RecipeReader& reader, const YAML::Node& node,
                      const LandmarkNames& names) {
  if (node.IsScalar()) return readNamed(reader, node, names);
  if (node.IsSequence()) return {readPoint(reader, node)};
  if (!node.IsMap() || node.size() == 0) {
    reader.refuseAt(node, "a point is a name, [x, y], or one of corner, on and meet");
  }
  Landmark point;
  PartOfWay way;
  int places = 0;
  bool has_part = false;
  reader.readMap(node, "a point",
                 {{"corner",
                   [&](const YAML::Node& value) {
                     point.place = CornerNear{readPoint(reader, value)};
                     ++places;
                   }},
                  {"on",
                   [&](const YAML::Node& value) {
                     way.ends = readLandmarks(reader, value, 2, "on", names);
                     ++places;
                   }},
                  {"at",
                   [&](const YAML::Node& value) {
                     way.part = reader.number(value, "at");
                     if (!(way.part >= 0 && way.part <= 1)) {
                       reader.refuseAt(value, "at ", way.part, " is not from 0 to 1");
                     }
                     has_part = true;
                   }},
                  {"meet", [&](const YAML::Node& value) {
                     point.place = LinesMeet{readLandmarks(reader, value, 4, "meet", names)};
                     ++places;
                   }}});
  if (places != 1) reader.refuseAt(node, "a point takes one of corner, on and meet");
  if (way.ends.empty() && has_part) reader.refuseAt(node, "at belongs to a point with on");
  if (!way.ends.empty()) point.place = way;
  return point;
}

std::vector<Landmark> readLandmarks(const RecipeReader& reader, const YAML::Node& node,
                                    std::size_t count, const char* what,
                                    const LandmarkNames& names) {
  if (!node.IsSequence() || node.size() != count) {
    reader.refuseAt(node, what, " takes ", count, " points");
  }
  std::vector<Landmark> points;
  for (const YAML::Node& entry : node) points.push_back(readLandmark(reader, entry, names));
  return points;
}

LandmarkNames readNames(const RecipeReader& reader, const YAML::Node& node) {
  if (!node.IsMap()) reader.refuseAt(node, "names must be a map of points");
  LandmarkNames names;
  for (const auto& entry : node) {
    const std::string name = reader.text(entry.first, "a name");
    if (names.count(name) > 0) reader.refuseAt(entry.first, "'", name, "' is there twice");
    const Landmark landmark = readLandmark(reader, entry.second, names);
    names.emplace(name, landmark);
  }
  return names;
}

RecipeReader::Handlers AxiomReader::handlers() {
  const auto into = [this](std::optional<std::vector<Landmark>>& entry, std::size_t count,
                           const char* what) {
    return [this, &entry, count, what](const YAML::Node& value) {
      entry = count == 1 ? std::vector<Landmark>{readLandmark(reader_, value, names_)}
                         : readLandmarks(reader_, value, count, what, names_);
    };
  };
  return {{"bring", into(bring_, 1, "bring")},       {"to", into(to_, 1, "to")},
          {"edge", into(edge_, 2, "edge")},          {"to_edge", into(to_edge_, 2, "to_edge")},
          {"across", into(across_, 2, "across")},    {"at", into(at_, 1, "at")},
          {"through", into(through_, 2, "through")}, {"move", into(move_, 1, "move")}};
}

FoldAxiom AxiomReader::axiom(const YAML::Node& node, const char* what,
                             const std::optional<Landmark>& moving) const {
  requireNoOther(node);
  const int axioms = (bring_ ? 1 : 0) + (edge_ ? 1 : 0) + (across_ ? 1 : 0) + (through_ ? 1 : 0);
  if (axioms != 1) {
    reader_.refuseAt(node, what, " takes one of bring, edge, across and through, not ", axioms);
  }
  const auto need = [&](const auto& entry, const char* of, const char* word) {
    if (!entry) reader_.refuseAt(node, of, " needs ", word);
    return *entry;
  };
  const auto mover = [&](const char* of) {
    return !move_ && moving ? *moving : need(move_, of, "move")[0];
  };
  const auto pair = [](const std::vector<Landmark>& points) {
    return std::array<Landmark, 2>{points[0], points[1]};
  };
  if (bring_) return BringPoint{(*bring_)[0], need(to_, "bring", "to")[0]};
  if (edge_) return BringEdge{pair(*edge_), pair(need(to_edge_, "edge", "to_edge"))};
  if (across_) return FoldAcross{pair(*across_), need(at_, "across", "at")[0], mover("across")};
  return FoldAlong{pair(*through_), mover("through")};
}

void AxiomReader::requireNoOther(const YAML::Node& node) const {
  const auto refuse = [&](bool there, bool belongs, const char* what, const char* to) {
    if (there && !belongs) reader_.refuseAt(node, what, " belongs to ", to);
  };
  refuse(to_.has_value(), bring_.has_value(), "to", "bring");
  refuse(to_edge_.has_value(), edge_.has_value(), "to_edge", "edge");
  refuse(at_.has_value(), across_.has_value(), "at", "across");
  refuse(move_.has_value(), across_ || through_, "move", "across and through");
}

}  // namespace shell_origami
