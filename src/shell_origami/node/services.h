/// \file
/// The node's services. A rejected request changes nothing and says why.
#pragma once

#include <shell_origami/node/fold_requests.h>
#include <shell_origami/node/held_frames.h>
#include <shell_origami/node/origami_node.h>

#include <ros/callback_queue.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <functional>
#include <future>
#include <string>
#include <vector>

namespace shell_origami {

/// Most are answered in the node's own thread. Those that may wait, of which the answer is the end
/// (step, settle, load) or which wait for a frame (pin, grasp, add_obstacle, fold_through, layers),
/// are called in threads of their own and reach the paper through the node's.
class Services {
 public:
  /// \param tf  what is heard on /tf; must live as long
  Services(ros::NodeHandle& node, OrigamiNode& origami, HeldFrames& held_frames,
           const tf2_ros::Buffer& tf);
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;
  /// Requests under way fail.
  ~Services();

 private:
  bool fold(msg::Fold::Request& request, msg::Fold::Response& response);
  bool foldThrough(msg::FoldThrough::Request& request, msg::FoldThrough::Response& response);
  bool layers(msg::Layers::Request& request, msg::Layers::Response& response);
  bool turnOver(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool pin(msg::Pin::Request& request, msg::Pin::Response& response);
  bool unpin(msg::Unpin::Request& request, msg::Unpin::Response& response);
  bool grasp(msg::Grasp::Request& request, msg::Grasp::Response& response);
  bool release(msg::Release::Request& request, msg::Release::Response& response);
  bool addVertex(msg::AddVertex::Request& request, msg::AddVertex::Response& response);
  bool addObstacle(msg::AddObstacle::Request& request, msg::AddObstacle::Response& response);
  bool removeObstacle(msg::RemoveObstacle::Request& request,
                      msg::RemoveObstacle::Response& response);
  bool load(msg::Load::Request& request, msg::Load::Response& response);
  bool save(msg::Save::Request& request, msg::Save::Response& response);
  bool step(msg::Step::Request& request, msg::Step::Response& response);
  bool settle(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool pause(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool resume(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool undo(msg::Undo::Request& request, msg::Undo::Response& response);

  // Called in the threads of requests that may wait. Templates are defined where they are used.

  static constexpr int kEndLook = 20;  ///< how often they look whether the node ends [ms]

  /// Calls a function in the node's thread and returns its result, or throws what it throws. It
  /// may outlive this call where the node ends, and must own what it uses.
  template <class Function>
  auto inNodeThread(Function function);
  /// Returns the result of a request once it is there. \throws std::runtime_error when the node
  /// ends before
  template <class Result>
  Result wait(std::future<Result> result) const;
  void waitForFrame(const std::string& frame) const;
  bool waitForCarrier(const std::string& frame) const;
  template <class Request, class Response, class Still, class Carried>
  std::string hold(const Request& request, Response& response, const std::string& doing,
                   Still still, Carried carried);

  // Called in the node's thread.
  msg::FoldThrough::Response foldThroughNow(const msg::FoldThrough::Request& request);
  msg::Layers::Response layersNow(const msg::Layers::Request& request) const;

  RequestContext context() const;
  /// The end of a successful answer while the paper does not move.
  std::string whilePaused() const;

  OrigamiNode& origami_;
  HeldFrames& held_frames_;
  const tf2_ros::Buffer& tf_;
  std::atomic<bool> ending_{false};
  ros::CallbackQueue queue_;  ///< of requests that may wait
  ros::AsyncSpinner spinner_;
  std::vector<ros::ServiceServer> servers_;
};

}  // namespace shell_origami
