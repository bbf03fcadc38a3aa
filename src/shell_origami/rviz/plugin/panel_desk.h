/// \file
/// The panel's link to the node, shared by its parts.
#pragma once

#include <shell_origami/rviz/plugin/paper_link.h>
#include <shell_origami/rviz/plugin/requests.h>

#include <functional>
#include <string>

namespace shell_origami {

/// The node that the panel is about, and where its answers are shown.
struct PanelDesk {
  PaperLink& link;
  Requests& requests;
  std::function<void(const std::string& message, bool refused)> tell;

  /// Asks the node; its message is shown.
  template <class Service>
  void ask(const std::string& service, const typename Service::Request& request = {}) {
    requests.ask<Service>(
        link.resolved(service), request,
        [say = tell](const typename Service::Response& r) { say(r.message, !r.success); });
  }
};

/// A topic of the node that the link has chosen; follows it to another node.
template <class Message>
class NodeTopic {
 public:
  using Hear = std::function<void(const Message&)>;

  /// \param hear  called by poll(), for no message older than the last `queue`
  NodeTopic(const PaperLink& link, const std::string& topic, std::uint32_t queue, Hear hear)
      : link_(link), topic_(topic), length_(queue), hear_(std::move(hear)) {
    handle_.setCallbackQueue(&queue_);
  }

  /// Returns whether the node is another one than at the last call.
  bool poll() {
    const bool another = node_ != link_.node();
    if (another) {
      node_ = link_.node();
      subscriber_ = ros::Subscriber();
      queue_.clear();
      subscribe();
    }
    queue_.callAvailable();
    return another;
  }

 private:
  void subscribe() {
    try {
      subscriber_ = handle_.subscribe<Message>(
          link_.resolved(topic_), length_,
          boost::function<void(const boost::shared_ptr<const Message>&)>(
              [this](const boost::shared_ptr<const Message>& message) { hear_(*message); }));
    } catch (const ros::InvalidNameException&) {
      // The link says so.
    }
  }

  const PaperLink& link_;
  std::string topic_, node_;
  std::uint32_t length_;
  Hear hear_;
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  ros::Subscriber subscriber_;
};

}  // namespace shell_origami
