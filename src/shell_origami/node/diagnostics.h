/// \file
/// The node's health on /diagnostics.
#pragma once

#include <shell_origami/node/origami_node.h>

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace shell_origami {

/// Once a period by the wall clock, also while simulation time stands still: how the solver fares,
/// whether the node keeps pace, and how the paper is. Figures of a period are those since the
/// message before.
class Diagnostics {
 public:
  Diagnostics(ros::NodeHandle& node, OrigamiNode& origami);

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  /// Findings about the paper at one time that take milliseconds.
  struct Outcome {
    std::uint64_t edits = 0;
    Positions positions;
    bool settled = false;
    std::size_t missed = 0;  ///< creases
    std::string shortfalls;  ///< of settled paper
  };

  void update();
  void solver(Status& status) const;
  void pace(Status& status) const;
  void paper(Status& status);
  const Outcome& outcome();
  void warnOfStrain(double strain, bool overstretched);

  OrigamiNode& origami_;
  Counters counters_;               ///< when it was last told
  double dropped_ = 0;              ///< [s] when it was last told
  bool overstretched_ = false;      ///< as the log was told
  std::optional<Outcome> outcome_;  ///< the last one
  diagnostic_updater::Updater updater_;
  ros::SteadyTimer timer_;
};

}  // namespace shell_origami
