/// \file
/// The simulation under way, through every paper that is loaded.
#pragma once

#include <shell_origami/origami/simulation.h>

#include <cstdint>
#include <vector>

namespace shell_origami {

/// One paper at a time. Time, counters, edits and revision keep growing when another takes its
/// place.
class Session {
 public:
  explicit Session(Simulation simulation);
  /// The paper that toJson() or checkpoint() wrote. \throws std::invalid_argument,
  /// nlohmann::json::exception
  explicit Session(const nlohmann::json& json);

  /// Exact, as Snapshot is. A checkpoint knows, too, how the paper was when it was loaded.
  nlohmann::json toJson() const;
  nlohmann::json checkpoint() const;

  /// Puts another paper in the place of this one.
  void replace(Simulation simulation);
  /// Makes the paper again as it was when it was loaded.
  void reset();

  /// The edits taken since the last call, oldest first, by this paper's time, steps and revision.
  std::vector<EditRecord> takeEdits();

  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }

  double time() const { return time_before_ + simulation_.time(); }  ///< [s]
  Counters counters() const;                                         ///< over every paper so far
  std::uint64_t steps() const { return counters().steps; }
  /// Those that takeEdits() gave, and papers that were replaced or reset.
  std::uint64_t edits() const { return edits_; }
  std::uint32_t revision() const { return revision_before_ + simulation_.sheet().revision(); }

 private:
  void follow(Simulation simulation);

  Simulation simulation_;
  Snapshot original_;
  double time_before_ = 0;
  std::uint64_t edits_ = 0;
  Counters counters_before_;
  std::uint32_t revision_before_ = 0;
};

}  // namespace shell_origami
