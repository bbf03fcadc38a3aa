/// \file
/// The part of the panel that lists pinned and grasped vertices and lets go of them.
#pragma once

#include <shell_origami/rviz/plugin/panel_desk.h>

#include <QWidget>

class QListWidget;

namespace shell_origami {

class HeldBox : public QWidget {
 public:
  explicit HeldBox(PanelDesk& desk);
  void refresh();

 private:
  void unpinSelected();

  PanelDesk& desk_;
  QListWidget* list_;
  std::vector<std::uint32_t> pinned_, grasped_;  ///< as listed
};

}  // namespace shell_origami
