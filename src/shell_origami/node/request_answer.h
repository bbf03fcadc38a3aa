/// \file
/// Answers to services' requests, and calls from their threads in the node's thread.
#pragma once

#include <shell_origami/node/message_text.h>
#include <shell_origami/node/services.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace shell_origami {

/// Answers with the message that the action returns, or with that of its error.
template <class Response, class Action>
bool answer(const char* service, Response& response, Action action) {
  try {
    response.message = asMessageText(action());
    response.success = true;
    ROS_INFO("%s: %s", service, response.message.c_str());
  } catch (const std::exception& error) {
    response = Response();
    response.message = asMessageText(error.what());
    ROS_WARN("%s refused: %s", service, response.message.c_str());
  }
  return true;
}

inline std::string count(std::size_t number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

inline std::string vertexCount(std::size_t number) { return count(number, "vertex", "vertices"); }

template <class Result>
Result Services::wait(std::future<Result> result) const {
  while (result.wait_for(std::chrono::milliseconds(kEndLook)) != std::future_status::ready) {
    if (ending_ || ros::isShuttingDown()) throw std::runtime_error("the node ends");
  }
  return result.get();
}

template <class Function>
auto Services::inNodeThread(Function function) {
  const auto task = std::make_shared<std::packaged_task<decltype(function())()>>(function);
  auto result = task->get_future();
  callInNodeThread([task] { (*task)(); });
  return wait(std::move(result));
}

}  // namespace shell_origami
