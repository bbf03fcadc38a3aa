/// \file
/// The part of the panel that starts and stops time, and tells how the paper is.
#pragma once

#include <shell_origami/rviz/plugin/panel_desk.h>

#include <QWidget>

#include <optional>

class QGridLayout;
class QLabel;
class QSpinBox;

namespace shell_origami {

class RunBox : public QWidget {
 public:
  explicit RunBox(PanelDesk& desk);
  void refresh();

 private:
  void addButton(QGridLayout& grid, int row, int column, const QString& text, const QString& tip,
                 const std::function<void()>& pressed);
  void addReading(QGridLayout& grid, int row, int column, const QString& name, QLabel*& reading);

  PanelDesk& desk_;
  NodeTopic<msg::Energy> energy_topic_;
  std::optional<msg::Energy> energy_;
  QSpinBox* steps_;
  QLabel *rest_, *pace_, *strain_, *contacts_;
};

}  // namespace shell_origami
