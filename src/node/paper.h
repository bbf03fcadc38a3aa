/// \file
/// The simulation under way, through every paper that is loaded.
#pragma once

#include "origami/simulation.h"

#include <cstdint>
#include <vector>

namespace shell_origami {

/// One paper at a time. Time, counters and revision keep growing when another takes its place.
class Paper {
 public:
  explicit Paper(Simulation simulation);

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
  std::uint32_t revision() const { return revision_before_ + simulation_.sheet().revision(); }

 private:
  struct Original {
    explicit Original(const Simulation& simulation);

    Sheet sheet;
    Positions positions;
    std::vector<double> rest_angles;  ///< NaN: a free crease
  };
  void follow(Simulation simulation);

  Simulation simulation_;
  Original original_;
  double time_before_ = 0;
  Counters counters_before_;
  std::uint32_t revision_before_ = 0;
};

}  // namespace shell_origami
