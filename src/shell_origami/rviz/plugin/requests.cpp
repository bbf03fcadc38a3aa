#include <shell_origami/rviz/plugin/requests.h>

#include <utility>
#include <vector>

namespace shell_origami {

Requests::~Requests() {
  for (Call& call : calls_) {
    call.broken_off = true;
    const std::lock_guard<std::mutex> lock(call.mutex);
    call.client.shutdown();
  }
  for (Call& call : calls_) call.thread.join();
}

void Requests::poll() {
  // What is done may make further calls.
  std::vector<std::function<void()>> finished;
  for (auto call = calls_.begin(); call != calls_.end();) {
    if (!call->ended) {
      ++call;
      continue;
    }
    call->thread.join();
    finished.push_back(std::move(call->finish));
    call = calls_.erase(call);
  }
  for (const auto& finish : finished) finish();
}

std::string noAnswer(const std::string& service) {
  return service + " does not answer: is its node running?";
}

}  // namespace shell_origami
