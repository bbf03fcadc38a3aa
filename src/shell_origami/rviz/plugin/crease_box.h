/// \file
/// The part of the panel that lists the creases and turns them.
#pragma once

#include <shell_origami/rviz/plugin/panel_desk.h>

#include <QWidget>

#include <vector>

class QSlider;
class QTableWidget;

namespace shell_origami {

/// A row for each crease. Its slider is at its target; where it is let go, the crease is folded to.
class CreaseBox : public QWidget {
 public:
  explicit CreaseBox(PanelDesk& desk);
  void refresh();

 private:
  void makeRows();
  void turn(int row);

  PanelDesk& desk_;
  QTableWidget* table_;
  std::vector<QSlider*> sliders_;
  std::uint64_t sheets_ = 0;  ///< of the link that the rows belong to
};

}  // namespace shell_origami
