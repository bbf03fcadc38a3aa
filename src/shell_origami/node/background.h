/// \file
/// Work that would keep the node's thread from its requests.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <thread>

namespace shell_origami {

/// Runs in the node's thread, which calls what roscpp has queued, as soon as that is free.
void callInNodeThread(std::function<void()> function);

/// A function that runs in a thread of its own. The node's thread wakes up once it is done.
class Background {
 public:
  using Cancelled = std::atomic<bool>;

  /// \param work  returns early, or throws, soon after its argument has become true
  explicit Background(std::function<void(const Cancelled&)> work);
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  /// Cancels the work and waits for its end.
  ~Background();

  void cancel() { cancelled_ = true; }
  bool done() const { return done_; }
  /// Returns the exception of the work, null if there was none. \pre done()
  std::exception_ptr error() const { return error_; }

 private:
  Cancelled cancelled_{false};
  std::exception_ptr error_;
  std::atomic<bool> done_{false};
  std::thread thread_;
};

}  // namespace shell_origami
