#include <shell_origami/node/undo_history.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <utility>

namespace shell_origami {

void UndoHistory::setMemory(std::size_t bytes) {
  most_bytes_ = bytes;
  dropOldest();
}

void UndoHistory::add(BeforeEdit before) {
  const std::size_t bytes = memoryOf(before.paper);
  kept_.push_back({std::move(before), bytes});
  bytes_ += bytes;
  dropOldest();
}

void UndoHistory::dropOldest() {
  while (bytes_ > most_bytes_) {
    bytes_ -= kept_.front().bytes;
    kept_.pop_front();
  }
}

std::uint32_t UndoHistory::countFrom(std::uint64_t edit) const {
  const auto after =
      std::upper_bound(kept_.begin(), kept_.end(), edit,
                       [](std::uint64_t e, const Kept& kept) { return e < kept.before.edit; });
  if (after == kept_.begin()) return 0;
  return static_cast<std::uint32_t>(kept_.end() - after) + 1;
}

BeforeEdit UndoHistory::goBack(std::uint32_t count) {
  if (kept_.empty()) reject("there is no edit that can be undone");
  if (count > kept_.size()) {
    reject("edits is ", count, ", but only the last ", kept_.size(), " can be undone");
  }
  BeforeEdit first = std::move(kept_[kept_.size() - count].before);
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes_ -= kept_.back().bytes;
    kept_.pop_back();
  }
  return first;
}

}  // namespace shell_origami
