/// \file
/// The papers before the last edits, as far back as memory goes.
#pragma once

#include <shell_origami/origami/journal.h>
#include <shell_origami/origami/snapshot.h>

#include <cstdint>
#include <deque>
#include <memory>

namespace shell_origami {

/// All that an edit may change.
struct BeforeEdit {
  std::uint64_t edit;                        ///< its number; the first one's of edits made together
  Snapshot paper;                            ///< before it
  std::shared_ptr<const Snapshot> original;  ///< how that paper was when it was loaded
  Viewpoint view;
  std::shared_ptr<Journal> journal;  ///< of that paper
  std::size_t steps;                 ///< that it had
};

class UndoHistory {
 public:
  /// \param bytes  that it may keep; what is older is dropped
  void setMemory(std::size_t bytes);
  /// Whether it may keep anything.
  bool keeps() const { return most_bytes_ > 0; }

  void add(BeforeEdit before);
  /// Returns how many edits have been since one, itself included; 0: it is not kept. One that was
  /// made together with others stands for all of them, one that does not count for the one before.
  std::uint32_t countFrom(std::uint64_t edit) const;
  /// Returns what was before the last `count` edits, and forgets these.
  /// \throws std::invalid_argument when it does not go back that far, and then forgets nothing
  BeforeEdit goBack(std::uint32_t count);

 private:
  struct Kept {
    BeforeEdit before;
    std::size_t bytes;
  };
  void dropOldest();

  std::deque<Kept> kept_;  ///< the last edit at the end
  std::size_t most_bytes_ = 0, bytes_ = 0;
};

}  // namespace shell_origami
