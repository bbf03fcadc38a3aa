/// \file
/// Service calls that never wait in the thread that makes them.
#pragma once

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <atomic>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>

namespace shell_origami {

/// Each call has a thread of its own, so that one that takes long (~settle) delays no other. What
/// its answer leads to is done in the thread that polls.
class Requests {
 public:
  Requests() = default;
  Requests(const Requests&) = delete;
  Requests& operator=(const Requests&) = delete;
  /// Calls under way are broken off, and what they were to lead to is not done.
  ~Requests();

  /// \param service  resolved name
  /// \param done     called by poll(), with null where the service does not answer
  template <class Service>
  void call(const std::string& service, const typename Service::Request& request,
            std::function<void(const typename Service::Response*)> done);
  /// Calls a service that answers success and a message.
  /// \param done  called by poll() with a response that may be the message that nobody answers
  template <class Service>
  void ask(const std::string& service, const typename Service::Request& request,
           std::function<void(const typename Service::Response&)> done);
  /// Does work in a thread of its own that ends soon. \param done  called by poll() with its result
  template <class Result>
  void run(std::function<Result()> work, std::function<void(const Result&)> done);
  /// Does what has to be done for every answer that has come.
  void poll();
  bool underWay() const { return !calls_.empty(); }

 private:
  struct Call {
    std::thread thread;
    std::mutex mutex;           ///< for `client`
    ros::ServiceClient client;  ///< valid while the service is being called
    std::atomic<bool> broken_off{false};
    std::atomic<bool> ended{false};
    std::function<void()> finish;
  };

  std::list<Call> calls_;
};

/// Returns the message that stands for the answer of a service that gives none.
std::string noAnswer(const std::string& service);

template <class Service>
void Requests::call(const std::string& service, const typename Service::Request& request,
                    std::function<void(const typename Service::Response*)> done) {
  Call& call = calls_.emplace_back();
  call.thread = std::thread([&call, service, request, done] {
    typename Service::Response response;
    bool answered = false;
    // A persistent client, for another one cannot be broken off.
    ros::ServiceClient client = ros::NodeHandle().serviceClient<Service>(service, true);
    {
      const std::lock_guard<std::mutex> lock(call.mutex);
      call.client = client;
    }
    if (!call.broken_off && client.isValid()) answered = client.call(request, response);
    call.finish = [done, answered, response] { done(answered ? &response : nullptr); };
    call.ended = true;
  });
}

template <class Result>
void Requests::run(std::function<Result()> work, std::function<void(const Result&)> done) {
  Call& call = calls_.emplace_back();
  call.thread = std::thread([&call, work, done] {
    call.finish = [done, result = work()] { done(result); };
    call.ended = true;
  });
}

template <class Service>
void Requests::ask(const std::string& service, const typename Service::Request& request,
                   std::function<void(const typename Service::Response&)> done) {
  call<Service>(service, request, [service, done](const typename Service::Response* response) {
    if (response) return done(*response);
    typename Service::Response none;
    none.success = false;
    none.message = noAnswer(service);
    done(none);
  });
}

}  // namespace shell_origami
