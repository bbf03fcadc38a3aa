/// \file
/// The part of the panel that loads and saves the paper, and says how it is drawn.
#pragma once

#include <shell_origami/rviz/plugin/panel_desk.h>

#include <dynamic_reconfigure/Config.h>
#include <QWidget>

#include <map>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLineEdit;

namespace shell_origami {

class FileBox : public QWidget {
 public:
  explicit FileBox(PanelDesk& desk);
  void refresh();

 private:
  void addFile(QGridLayout& grid, int row);
  void addDrawing(QGridLayout& grid, int row);
  void browse();
  void load();
  void save();
  void hear(const dynamic_reconfigure::Config& config);
  void change(const dynamic_reconfigure::Config& config);

  PanelDesk& desk_;
  NodeTopic<dynamic_reconfigure::Config> config_topic_;
  QLineEdit* path_;
  QComboBox* coloring_;
  int changes_ = 0;                             ///< that the node has not answered yet
  std::map<std::string, QCheckBox*> switches_;  ///< by the names of their parameters
};

}  // namespace shell_origami
