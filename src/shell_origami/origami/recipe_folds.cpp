#include <shell_origami/origami/recipe_folds.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace shell_origami {
namespace {

/// The entries of one fold, each a landmark or more.
struct Entries {
  std::optional<std::vector<Landmark>> bring, to, edge, to_edge, across, at, through, move;
};

class FoldReader {
 public:
  FoldReader(const RecipeReader& reader, const LandmarkNames& names)
      : reader_(reader), names_(names) {}

  Landmark landmark(const YAML::Node& node) const {
    if (node.IsScalar()) return named(node);
    if (node.IsSequence()) return {point(node)};
    if (!node.IsMap() || node.size() == 0) {
      reader_.refuseAt(node, "a point is a name, [x, y], or one of corner, on and meet");
    }
    std::vector<Landmark> found;
    PartOfWay way;
    bool has_part = false;
    reader_.readMap(
        node, "a point",
        {{"corner",
          [&](const YAML::Node& value) { found.push_back(at(CornerNear{point(value)})); }},
         {"on",
          [&](const YAML::Node& value) {
            way.ends = landmarks(value, 2, "on");
            found.emplace_back();
          }},
         {"at",
          [&](const YAML::Node& value) {
            way.part = reader_.number(value, "at");
            if (!(way.part >= 0 && way.part <= 1)) {
              reader_.refuseAt(value, "at ", way.part, " is not from 0 to 1");
            }
            has_part = true;
          }},
         {"meet", [&](const YAML::Node& value) {
            found.push_back(at(LinesMeet{landmarks(value, 4, "meet")}));
          }}});
    if (found.size() != 1) reader_.refuseAt(node, "a point takes one of corner, on and meet");
    if (way.ends.empty() && has_part) reader_.refuseAt(node, "at belongs to a point with on");
    return way.ends.empty() ? found[0] : at(way);
  }

  FoldThrough fold(const YAML::Node& node) const {
    FoldThrough fold;
    Entries entries;
    const auto into = [this](std::optional<std::vector<Landmark>>& entry, std::size_t count,
                             const char* what) {
      return [this, &entry, count, what](const YAML::Node& value) {
        entry = count == 1 ? std::vector<Landmark>{landmark(value)} : landmarks(value, count, what);
      };
    };
    reader_.readMap(node, "fold_through",
                    {{"bring", into(entries.bring, 1, "bring")},
                     {"to", into(entries.to, 1, "to")},
                     {"edge", into(entries.edge, 2, "edge")},
                     {"to_edge", into(entries.to_edge, 2, "to_edge")},
                     {"across", into(entries.across, 2, "across")},
                     {"at", into(entries.at, 1, "at")},
                     {"through", into(entries.through, 2, "through")},
                     {"move", into(entries.move, 1, "move")},
                     {"layers", [&](const YAML::Node& value) { readLayers(value, fold); }},
                     {"flap",
                      [&](const YAML::Node& value) {
                        fold.layers = FoldLayers::kFlap;
                        fold.flap = landmark(value);
                      }},
                     {"way", [&](const YAML::Node& value) { fold.behind = behind(value); }},
                     {"angle_deg", [&](const YAML::Node& value) {
                        const double angle = reader_.number(value, "angle_deg");
                        if (!(angle > 0 && angle < 180)) {
                          reader_.refuseAt(value, "angle_deg ", angle, " is not inside (0, 180)");
                        }
                        fold.angle = angle * kDegree;
                      }}});
    if (node["flap"].IsDefined() && node["layers"].IsDefined()) {
      reader_.refuseAt(node, "fold_through takes one of layers and flap, not both");
    }
    fold.axiom = axiom(node, entries);
    requireNoOther(node, entries);
    return fold;
  }

 private:
  Landmark named(const YAML::Node& node) const {
    const std::string name = reader_.text(node, "a point");
    const auto found = names_.find(name);
    if (found == names_.end()) reader_.refuseAt(node, "'", name, "' is none of the recipe's names");
    return {found->second.place, name};
  }

  static Landmark at(decltype(Landmark::place) place) {
    Landmark landmark;
    landmark.place = std::move(place);
    return landmark;
  }

  Vector2 point(const YAML::Node& node) const {
    const std::vector<double> numbers = reader_.numbers(node, 2, "a point");
    return {numbers[0], numbers[1]};
  }

  std::vector<Landmark> landmarks(const YAML::Node& node, std::size_t count,
                                  const char* what) const {
    if (!node.IsSequence() || node.size() != count) {
      reader_.refuseAt(node, what, " takes ", count, " points");
    }
    std::vector<Landmark> points;
    for (const YAML::Node& entry : node) points.push_back(landmark(entry));
    return points;
  }

  void readLayers(const YAML::Node& node, FoldThrough& fold) const {
    if (node.IsScalar() && node.Scalar() == "all") return;
    if (!node.IsMap() || node.size() != 1) {
      reader_.refuseAt(node, "layers takes all, or top and their number");
    }
    reader_.readMap(node, "layers", {{"top", reader_.into(&fold.count, "top")}});
    if (fold.count < 1) reader_.refuseAt(node, "top ", fold.count, " is not at least 1");
    fold.layers = FoldLayers::kTop;
  }

  bool behind(const YAML::Node& node) const {
    const std::string way = reader_.text(node, "way");
    if (way != "front" && way != "behind") {
      reader_.refuseAt(node, "way is '", way, "', not front or behind");
    }
    return way == "behind";
  }

  FoldAxiom axiom(const YAML::Node& node, const Entries& e) const {
    const int axioms =
        (e.bring ? 1 : 0) + (e.edge ? 1 : 0) + (e.across ? 1 : 0) + (e.through ? 1 : 0);
    if (axioms != 1) {
      reader_.refuseAt(node, "fold_through takes one of bring, edge, across and through, not ",
                       axioms);
    }
    const auto need = [&](const auto& entry, const char* of, const char* what) {
      if (!entry) reader_.refuseAt(node, of, " needs ", what);
      return *entry;
    };
    const auto pair = [](const std::vector<Landmark>& points) {
      return std::array<Landmark, 2>{points[0], points[1]};
    };
    if (e.bring) return BringPoint{(*e.bring)[0], need(e.to, "bring", "to")[0]};
    if (e.edge) return BringEdge{pair(*e.edge), pair(need(e.to_edge, "edge", "to_edge"))};
    if (e.across) {
      return FoldAcross{pair(*e.across), need(e.at, "across", "at")[0],
                        need(e.move, "across", "move")[0]};
    }
    return FoldAlong{pair(*e.through), need(e.move, "through", "move")[0]};
  }

  void requireNoOther(const YAML::Node& node, const Entries& e) const {
    const auto refuse = [&](bool there, bool belongs, const char* what, const char* to) {
      if (there && !belongs) reader_.refuseAt(node, what, " belongs to ", to);
    };
    refuse(e.to.has_value(), e.bring.has_value(), "to", "bring");
    refuse(e.to_edge.has_value(), e.edge.has_value(), "to_edge", "edge");
    refuse(e.at.has_value(), e.across.has_value(), "at", "across");
    refuse(e.move.has_value(), e.across || e.through, "move", "across and through");
  }

  const RecipeReader& reader_;
  const LandmarkNames& names_;
};

}  // namespace

LandmarkNames readNames(const RecipeReader& reader, const YAML::Node& node) {
  if (!node.IsMap()) reader.refuseAt(node, "names must be a map of points");
  LandmarkNames names;
  for (const auto& entry : node) {
    const std::string name = reader.text(entry.first, "a name");
    if (names.count(name) > 0) reader.refuseAt(entry.first, "'", name, "' is there twice");
    const Landmark landmark = FoldReader(reader, names).landmark(entry.second);
    names.emplace(name, landmark);
  }
  return names;
}

FoldThrough readFoldThrough(const RecipeReader& reader, const YAML::Node& node,
                            const LandmarkNames& names) {
  return FoldReader(reader, names).fold(node);
}

}  // namespace shell_origami
