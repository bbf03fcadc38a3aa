/// \file
/// A recorded run, simulated again from its edits and compared with its states.
#pragma once

#include <shell_origami/node/messages.h>
#include <shell_origami/node/session.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace shell_origami {

/// Takes a recording's messages, edits and states each in their own order, and simulates as it
/// goes: it keeps those messages alone that wait for one of the other kind. It begins with the
/// first edit that carries a whole paper; what was recorded before cannot be simulated again.
class Resimulation {
 public:
  struct Result {
    std::size_t states = 0;     ///< that were simulated again
    std::size_t skipped = 0;    ///< recorded before the first whole paper
    std::size_t different = 0;  ///< of `states`, in any bit of a position or a crease's angle
    double largest = 0;         ///< difference of a coordinate [m]; infinite where one is NaN
    double first = 0;           ///< paper's time of the first that differs [s]
    std::size_t edits = 0;      ///< that were made again
    double duration = 0;        ///< of the paper that was simulated again [s]
  };

  // Each throws std::invalid_argument with a message when the recording holds no paper, edits are
  // missing, or what was done once cannot be done again.
  void add(msg::SheetState::ConstPtr state);
  void add(msg::Edit::ConstPtr edit);
  /// Simulates what still waits.
  Result finish();

 private:
  void advance();
  void make(const msg::Edit& edit);
  void advanceTo(std::uint64_t step);
  void compare(const msg::SheetState& then);

  /// Those that wait: a state for the edits before it, an edit for a state after it.
  std::deque<msg::SheetState::ConstPtr> states_;
  std::deque<msg::Edit::ConstPtr> edits_;
  std::optional<Session> session_;
  double start_time_ = 0;
  Result result_;
};

}  // namespace shell_origami
