/// \file
/// A recorded run, simulated again from its edits and held against its states.
#pragma once

#include <shell_origami/node/messages.h>
#include <shell_origami/node/session.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace shell_origami {

/// Hears a recording's messages in their order, edits and states each in their own. It begins with
/// the first edit that carries a whole paper; what was recorded before cannot be simulated again.
class Resimulation {
 public:
  struct Result {
    std::size_t states = 0;     ///< that were simulated again
    std::size_t skipped = 0;    ///< recorded before the first whole paper
    std::size_t different = 0;  ///< of `states`, in any bit of a position or a crease's angle
    double largest = 0;         ///< difference of a coordinate [m]
    double first = 0;           ///< paper's time of the first that differs [s]
    std::size_t edits = 0;      ///< that were made again
    double duration = 0;        ///< of the paper that was simulated again [s]
  };

  void add(const msg::SheetState& state);
  void add(const msg::Edit& edit);
  /// Simulates what was added. \throws std::invalid_argument with one sentence when the recording
  /// holds no paper, edits are missing, or what was done once cannot be done again.
  Result run();

 private:
  using Moment = std::pair<std::uint64_t, std::uint64_t>;  ///< edits and steps completed

  void start(const msg::Edit& edit);
  void make(const msg::Edit& edit);
  void advanceTo(std::uint64_t step);
  void compare();

  std::map<Moment, std::vector<msg::SheetState>> states_;
  std::vector<msg::Edit> edits_;
  std::optional<Session> session_;
  double start_time_ = 0;
  Result result_;
};

}  // namespace shell_origami
