/// \file
/// Survives the master: where another takes its place, the node is registered there.
#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

namespace shell_origami {

/// Looks after the master in a thread of its own, once a second. roscpp registers a node's topics
/// and services once; what connections there are outlive the master, but nobody new finds the node.
class MasterWatch {
 public:
  MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;
  ~MasterWatch();

 private:
  void run();
  bool endsWithin(std::chrono::seconds period);
  void look();
  void remember();
  void registerAgain() const;

  std::optional<int> pid_;  ///< of the master that knows the node
  /// The node as the master knows it.
  std::map<std::string, std::string> types_;  ///< of every topic
  std::set<std::string> publications_, subscriptions_, services_;
  std::string service_uri_;

  std::mutex mutex_;
  std::condition_variable ending_;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace shell_origami
