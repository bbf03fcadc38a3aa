/// \file
/// Landmarks and what is said of a fold by them, in a recipe's file.
#pragma once

#include <shell_origami/origami/fold_plane.h>
#include <shell_origami/origami/recipe_reader.h>

#include <optional>
#include <vector>

namespace shell_origami {

// Each throws std::invalid_argument with one sentence naming file, line and offending value.

/// Reads `names`. A landmark may use the names before it.
LandmarkNames readNames(const RecipeReader& reader, const YAML::Node& node);
Landmark readLandmark(const RecipeReader& reader, const YAML::Node& node,
                      const LandmarkNames& names);
/// Reads a list of so many landmarks. `what` is its name in messages.
std::vector<Landmark> readLandmarks(const RecipeReader& reader, const YAML::Node& node,
                                    std::size_t count, const char* what,
                                    const LandmarkNames& names);

/// Reads the words of a fold that are a FoldAxiom, among others of the same map.
class AxiomReader {
 public:
  AxiomReader(const RecipeReader& reader, const LandmarkNames& names)
      : reader_(reader), names_(names) {}

  /// Handlers of the words of all axioms. \pre this outlives them
  RecipeReader::Handlers handlers();
  /// The axiom of the words that were read.
  /// \param what    the name of the map in messages
  /// \param moving  on the side that moves, where the map need not say it
  FoldAxiom axiom(const YAML::Node& node, const char* what,
                  const std::optional<Landmark>& moving = std::nullopt) const;

 private:
  void requireNoOther(const YAML::Node& node) const;

  const RecipeReader& reader_;
  const LandmarkNames& names_;
  std::optional<std::vector<Landmark>> bring_, to_, edge_, to_edge_, across_, at_, through_, move_;
};

}  // namespace shell_origami
