/// \file
/// A file from which a run goes on where its node was killed.
#pragma once

#include <shell_origami/node/recipe_run.h>
#include <shell_origami/node/session.h>

#include <ros/time.h>

#include <optional>
#include <string>

namespace shell_origami {

/// The run of a node: its paper and its recipe.
struct Run {
  Session session;
  std::optional<RecipeRun> recipe;
  bool paused = false;
};

class Checkpoint {
 public:
  /// \param path  of the file; empty: none is kept
  /// \param period  between two writings [s] of wall time
  Checkpoint(std::string path, double period);

  /// Returns the contents of the file, or nothing if there is no such file.
  /// \throws std::invalid_argument with one sentence when it cannot be read or is damaged.
  std::optional<Run> read() const;

  /// Writes the file where the period is over and anything happened. One that cannot be written is
  /// told of in the log, and the one before stays.
  void keep(const Run& run);
  /// Writes it now.
  void write(const Run& run);

 private:
  std::string path_;
  double period_;
  ros::SteadyTime last_ = ros::SteadyTime::now();
  /// Steps, edits, pause and side that it holds.
  std::optional<std::array<std::uint64_t, 4>> kept_;
};

}  // namespace shell_origami
