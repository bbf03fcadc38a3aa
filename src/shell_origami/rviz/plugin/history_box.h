/// \file
/// The part of the panel that lists the edits and goes back to them.
#pragma once

#include <shell_origami/rviz/plugin/panel_desk.h>

#include <QWidget>

class QListWidget;
class QPushButton;

namespace shell_origami {

/// The last edits that the node has told of since the panel listens, without those that were
/// undone.
class HistoryBox : public QWidget {
 public:
  /// A paper is edited for hours, and each reset is one more edit that can be undone: without a
  /// limit the list would take ever more memory. ~undo goes back further where the node remembers
  /// more.
  static constexpr int kMostRows = 1000;

  explicit HistoryBox(PanelDesk& desk);
  void refresh();

 private:
  void hear(const msg::Edit& edit);
  void forget(std::uint64_t from);
  void goBack();

  PanelDesk& desk_;
  NodeTopic<msg::Edit> edit_topic_;
  QListWidget* list_;
  QPushButton* back_;
  ros::Time since_;   ///< when the first of them was
  std::string node_;  ///< whose edits are listed
};

}  // namespace shell_origami
