/// \file
/// A recipe under way: what it does is told in the log, and its results are written at the end.
#pragma once

#include <shell_origami/origami/recipe.h>

#include <ros/time.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace shell_origami {

class RecipeRun {
 public:
  /// Hears how the recipe ended: why it was abandoned, or an empty sentence when it is done.
  using Listener = std::function<void(const RecipeRun& run, const std::string& why)>;

  /// \param output  folder for the results; empty: none are written
  RecipeRun(Recipe recipe, std::string output, Listener listener = nullptr);
  /// Goes on where checkpoint() was taken; nobody listens. The view is the session's to keep.
  /// \throws std::invalid_argument, nlohmann::json::exception
  explicit RecipeRun(const nlohmann::json& checkpoint);
  nlohmann::json checkpoint() const;

  /// Looks at the paper as somebody else does.
  void look(const Viewpoint& view) { runner_.look(view); }
  /// The view after the last update(). \pre there was one
  const Viewpoint& view() const { return *runner_.place().view; }

  /// Does what is due before the next step. Returns false once the recipe is over.
  /// \throws std::exception when the paper refuses an edit or the results cannot be written.
  /// \param listener  of its steps
  bool update(const Simulation& simulation, const RecipeRunner::Apply& apply,
              RecipeListener* listener);

  /// To be called after every edit while the recipe is under way, with the edit's number.
  void remember(std::uint64_t edit);
  /// Goes back to where it was before the edit of this number. Returns false where it had not begun
  /// then.
  bool goBack(std::uint64_t edit);

  /// Number of the first edit of the step under way, if it is known.
  std::optional<std::uint64_t> firstEdit() const;
  /// RecipeRunner::tryAgain(), once the paper is as it was before that edit.
  bool tryAgain(const StepFailed& failed) { return runner_.tryAgain(failed, runner_.place()); }

  /// Tells the listener of the end, and the log of an early one.
  void end(const std::string& why);
  /// Nobody hears of the end any more.
  void forgetListener() { listener_ = nullptr; }

  const Recipe& recipe() const { return runner_.recipe(); }
  const RecipeRunner& runner() const { return runner_; }
  int stepNumber() const;  ///< of the step under way, from 1; 0 where the recipe has none

 private:
  void finish(const Simulation& simulation) const;
  std::string place() const;

  RecipeRunner runner_;
  std::string output_;
  Listener listener_;
  int told_ = 0;  ///< number of the step that the log told of
  ros::SteadyTime start_;
  double start_time_ = 0;  ///< of the simulation [s]
  /// Where the recipe was before each edit since it began, by the edits' numbers.
  std::map<std::uint64_t, RecipePlace> places_;
  std::optional<RecipePlace> before_;  ///< edits that the recipe makes now
};

}  // namespace shell_origami
