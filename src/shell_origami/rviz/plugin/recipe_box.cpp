#include <shell_origami/rviz/plugin/recipe_box.h>

#include <actionlib_msgs/GoalID.h>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace shell_origami {
namespace {

constexpr int kPercent = 100;

}  // namespace

RecipeBox::RecipeBox(PanelDesk& desk)
    : desk_(desk),
      feedback_topic_(desk.link, "fold_recipe/feedback", 1, [this](const auto& m) { hear(m); }),
      status_topic_(desk.link, "fold_recipe/status", 1, [this](const auto& m) { hear(m); }),
      result_topic_(desk.link, "fold_recipe/result", 1, [this](const auto& m) { hear(m); }),
      recipe_(new QLineEdit("dog")),
      cancel_button_(new QPushButton("Cancel")),
      progress_(new QProgressBar),
      doing_(new QLabel) {
  auto* grid = new QGridLayout(this);
  auto* fold_button = new QPushButton("Fold");
  recipe_->setObjectName("recipe");
  recipe_->setToolTip("One of the package's recipes, or a path on the node's machine");
  fold_button->setObjectName("fold_recipe");
  cancel_button_->setObjectName("cancel_recipe");
  progress_->setObjectName("progress");
  doing_->setObjectName("doing");
  doing_->setWordWrap(true);
  grid->addWidget(new QLabel("Recipe"), 0, 0);
  grid->addWidget(recipe_, 0, 1, 1, 2);
  grid->addWidget(fold_button, 1, 1);
  grid->addWidget(cancel_button_, 1, 2);
  grid->addWidget(progress_, 2, 0, 1, 3);
  grid->addWidget(doing_, 3, 0, 1, 3);
  grid->setRowStretch(4, 1);
  connect(fold_button, &QPushButton::clicked, [this] { fold(); });
  connect(cancel_button_, &QPushButton::clicked, [this] { cancel(); });
}

void RecipeBox::fold() {
  FoldRecipeActionGoal goal;
  goal.goal.recipe = recipe_->text().toStdString();
  goal_.publish(goal);
}

/// Whoever has sent the goal that is under way.
void RecipeBox::cancel() { cancel_.publish(actionlib_msgs::GoalID()); }

void RecipeBox::hear(const FoldRecipeActionFeedback& message) {
  const FoldRecipeFeedback& feedback = message.feedback;
  progress_->setValue(static_cast<int>(kPercent * feedback.progress));
  doing_->setText(QString("step %1 of %2: %3")
                      .arg(feedback.step)
                      .arg(feedback.steps)
                      .arg(QString::fromStdString(feedback.doing)));
}

void RecipeBox::hear(const actionlib_msgs::GoalStatusArray& statuses) {
  const auto& all = statuses.status_list;
  under_way_ = std::any_of(all.begin(), all.end(), [](const actionlib_msgs::GoalStatus& s) {
    return s.status == s.ACTIVE || s.status == s.PENDING || s.status == s.PREEMPTING;
  });
}

void RecipeBox::hear(const FoldRecipeActionResult& result) {
  using Status = actionlib_msgs::GoalStatus;
  const bool done = result.status.status == Status::SUCCEEDED;
  const std::string text = result.status.text.empty()
                               ? (done ? "the recipe is done" : "the recipe has ended")
                               : result.status.text;
  if (done) progress_->setValue(kPercent);
  doing_->setText(QString::fromStdString(text));
  desk_.tell(text, !done && result.status.status != Status::PREEMPTED);
}

void RecipeBox::refresh() {
  if (feedback_topic_.poll()) {
    under_way_ = false;
    progress_->setValue(0);
    doing_->setText("");
    ros::NodeHandle handle;
    goal_ = cancel_ = ros::Publisher();
    try {
      goal_ = handle.advertise<FoldRecipeActionGoal>(desk_.link.resolved("fold_recipe/goal"), 1);
      cancel_ =
          handle.advertise<actionlib_msgs::GoalID>(desk_.link.resolved("fold_recipe/cancel"), 1);
    } catch (const ros::InvalidNameException&) {
      // The link says so.
    }
  }
  status_topic_.poll();
  result_topic_.poll();
  cancel_button_->setEnabled(under_way_);
}

}  // namespace shell_origami
