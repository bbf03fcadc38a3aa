/// \file
/// The paper of a node, as the tool and the panel hear of it.
#pragma once

#include <shell_origami/node/messages.h>
#include <shell_origami/rviz/ray_caster.h>
#include <shell_origami/rviz/shown_paper.h>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <memory>
#include <optional>
#include <string>

namespace shell_origami {

/// Listens to ~sheet and ~state of one node at a time. Everything happens in the thread that polls.
class PaperLink {
 public:
  static constexpr const char* kDefaultNode = "origami";

  PaperLink();

  /// Listens to another node. \param node  its name, relative to rviz's namespace or absolute
  void choose(const std::string& node);
  /// The name as it was chosen, and the resolved one of a topic or service of the node.
  const std::string& node() const { return node_; }
  std::string resolved(const std::string& name) const;

  /// Takes in what has been heard.
  void poll();
  /// Why there is no paper, or why it may be out of date; empty: there is one.
  std::string problem() const;
  /// The paper where it is; null: there is none.
  const ShownPaper* paper() const { return heard_.isZero() ? nullptr : paper_.get(); }
  /// The caster on the paper as it is. \pre paper()
  const RayCaster& caster();
  /// The last state. \pre paper()
  const msg::SheetState& state() const { return state_; }
  /// Grows with each state, and with each sheet.
  std::uint64_t states() const { return states_; }
  std::uint64_t sheets() const { return sheets_; }
  bool isPinned(int vertex) const;
  bool isGrasped(int vertex) const;

 private:
  void hearSheet(const msg::Sheet& sheet);
  void hearState(const msg::SheetState& state);

  std::string node_, unreadable_;
  ros::NodeHandle handle_;
  ros::CallbackQueue queue_;
  ros::Subscriber sheet_subscriber_, state_subscriber_;
  std::uint32_t revision_ = 0;  ///< of the paper
  std::unique_ptr<ShownPaper> paper_;
  std::optional<RayCaster> caster_;
  bool caster_follows_ = false;
  msg::SheetState state_;
  ros::WallTime heard_;  ///< when the last state was; zero: there is none of this node
  std::uint64_t states_ = 0, sheets_ = 0;
};

/// Returns the link that all tools and panels of this process share.
std::shared_ptr<PaperLink> sharedPaperLink();

}  // namespace shell_origami
