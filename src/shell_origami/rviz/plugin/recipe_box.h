/// \file
/// The part of the panel that folds by recipes.
#pragma once

#include <shell_origami/rviz/plugin/panel_desk.h>

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/publisher.h>
#include <QWidget>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace shell_origami {

class RecipeBox : public QWidget {
 public:
  explicit RecipeBox(PanelDesk& desk);
  void refresh();

 private:
  void fold();
  void cancel();
  void hear(const FoldRecipeActionFeedback& feedback);
  void hear(const actionlib_msgs::GoalStatusArray& statuses);
  void hear(const FoldRecipeActionResult& result);

  PanelDesk& desk_;
  NodeTopic<FoldRecipeActionFeedback> feedback_topic_;
  NodeTopic<actionlib_msgs::GoalStatusArray> status_topic_;
  NodeTopic<FoldRecipeActionResult> result_topic_;
  ros::Publisher goal_, cancel_;
  QLineEdit* recipe_;
  QPushButton* cancel_button_;
  QProgressBar* progress_;
  QLabel* doing_;
  bool under_way_ = false;
};

}  // namespace shell_origami
