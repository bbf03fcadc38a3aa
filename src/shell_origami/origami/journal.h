/// \file
/// All edits of a paper since it was loaded, as steps of a recipe.
#pragma once

#include <shell_origami/origami/recipe.h>

#include <nlohmann/json.hpp>

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace shell_origami {

/// Where a paper comes from: makeSimulation() makes it again.
struct PaperOrigin {
  SheetSource sheet;
  SimulationConfig config;
  LandmarkNames names;  ///< of the recipes that folded it
};

/// A step that was done. Times are those of the simulation.
struct DoneStep {
  RecipeStep step;
  double start = 0;                 ///< [s]
  double moved_until = 0;           ///< when the paper last moved before the next step [s]
  std::optional<double> over = {};  ///< when the step of a recipe ended by itself [s]
  std::string frame = {};           ///< that carried in truth what the step holds in place
};

/// A step as a recipe states it.
struct WrittenStep {
  RecipeStep step;
  std::optional<double> lasts = {};  ///< [s]; none: until it is done
  std::string frame = {};            ///< as of DoneStep
};

class Journal : public RecipeListener {
 public:
  explicit Journal(PaperOrigin origin = {}) : origin_(std::move(origin)) {}
  /// Reads what toJson() wrote. \throws std::invalid_argument, nlohmann::json::exception
  explicit Journal(const nlohmann::json& json);
  nlohmann::json toJson() const;

  const PaperOrigin& origin() const { return origin_; }
  /// Later names take the place of earlier ones.
  void addNames(const LandmarkNames& names);

  /// Notes a step that was done at a time [s].
  void add(RecipeStep step, double time);
  /// Notes an edit that was made by itself. Frames that move are not noted.
  /// \param given  as it was asked for
  /// \param before  the live parameters before it
  void add(const Edit& given, const EditRecord& made, const LiveConfig& before);
  /// Notes that the paper moved until a time [s].
  void moved(double time);
  // The steps of a recipe.
  void onStepBegun(const RecipeStep& step, double time) override;
  void onStepOver(double time) override;

  std::size_t size() const { return steps_.size(); }
  /// Forgets all but the first steps.
  void keepFirst(std::size_t count);

  /// Returns the steps of a recipe that does the same at the same times. Where the paper rested,
  /// time is left out.
  /// \param folding  whether a fold of the last step is under way, which then is to be ended
  std::vector<WrittenStep> written(bool folding) const;
  /// Returns the frames that carried paper.
  std::set<std::string> frames() const;

 private:
  PaperOrigin origin_;
  double moved_first_ = 0;      ///< until when the paper moved before the first step [s]
  std::deque<DoneStep> steps_;  ///< grows without a copy of all
  std::size_t of_recipe_ = 0;   ///< number of the last step that a recipe began, from 1
};

}  // namespace shell_origami
