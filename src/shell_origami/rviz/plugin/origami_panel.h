/// \file
/// rviz's panel of a node that folds paper.
#pragma once

#ifndef Q_MOC_RUN  // moc does not understand the headers of boost
#include <shell_origami/rviz/plugin/panel_desk.h>

#include <rviz/panel.h>
#endif

#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QTabWidget;

namespace shell_origami {

class CreaseBox;
class FileBox;
class HeldBox;
class HistoryBox;
class RecipeBox;
class RunBox;

/// Time and readings on top, below them in tabs creases, held vertices, recipes, edits and files.
class OrigamiPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit OrigamiPanel(QWidget* parent = nullptr);
  ~OrigamiPanel() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void refresh();
  void chooseNode(const QString& node);
  void lookForNodes();
  void tell(const std::string& message, bool refused);

  std::shared_ptr<PaperLink> link_;
  Requests requests_;  ///< of the boxes; before them, so that it ends after them
  Requests searches_;
  PanelDesk desk_;
  QComboBox* node_;
  QLabel *problem_, *answer_;
  RunBox* run_;
  CreaseBox* creases_;
  HeldBox* held_;
  RecipeBox* recipe_;
  HistoryBox* history_;
  FileBox* file_;
  int ticks_ = 0;
};

}  // namespace shell_origami
