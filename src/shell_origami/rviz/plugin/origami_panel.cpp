#include <shell_origami/rviz/plugin/origami_panel.h>

#include <shell_origami/rviz/plugin/crease_box.h>
#include <shell_origami/rviz/plugin/file_box.h>
#include <shell_origami/rviz/plugin/fold_status.h>
#include <shell_origami/rviz/plugin/held_box.h>
#include <shell_origami/rviz/plugin/history_box.h>
#include <shell_origami/rviz/plugin/recipe_box.h>
#include <shell_origami/rviz/plugin/run_box.h>

#include <ros/master.h>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

namespace shell_origami {
namespace {

constexpr int kPeriod = 100;      ///< of looking for news [ms]
constexpr int kSearchTicks = 20;  ///< of these, between two looks for nodes

using Names = std::vector<std::string>;

/// Returns the nodes that publish a sheet. A master that does not answer is not waited for.
Names findNodes() {
  const std::string suffix = "/sheet";
  XmlRpc::XmlRpcValue arguments, result, topics;
  arguments[0] = ros::this_node::getName();
  arguments[1] = "";
  Names nodes;
  if (!ros::master::execute("getPublishedTopics", arguments, result, topics, false)) return nodes;
  for (int i = 0; i < topics.size(); ++i) {
    const std::string topic = topics[i][0], type = topics[i][1];
    const bool is_sheet = type == "shell_origami/Sheet" && topic.size() > suffix.size();
    if (is_sheet) nodes.push_back(topic.substr(0, topic.size() - suffix.size()));
  }
  return nodes;
}

}  // namespace

OrigamiPanel::OrigamiPanel(QWidget* parent)
    : rviz::Panel(parent),
      link_(sharedPaperLink()),
      desk_{*link_, requests_,
            [this](const std::string& message, bool refused) { tell(message, refused); }},
      node_(new QComboBox),
      problem_(new QLabel),
      answer_(new QLabel),
      run_(new RunBox(desk_)),
      creases_(new CreaseBox(desk_)),
      held_(new HeldBox(desk_)),
      recipe_(new RecipeBox(desk_)),
      history_(new HistoryBox(desk_)),
      file_(new FileBox(desk_)) {
  auto* layout = new QVBoxLayout(this);
  auto* tabs = new QTabWidget;
  node_->setObjectName("node");
  node_->setEditable(true);
  node_->setToolTip("The node whose paper is folded, also by the tool Fold");
  problem_->setObjectName("problem");
  problem_->setWordWrap(true);
  answer_->setObjectName("answer");
  answer_->setWordWrap(true);
  tabs->setObjectName("tabs");
  tabs->setUsesScrollButtons(false);
  tabs->addTab(creases_, "Creases");
  tabs->addTab(held_, "Held");
  tabs->addTab(recipe_, "Recipe");
  tabs->addTab(history_, "Edits");
  tabs->addTab(file_, "File");
  for (QWidget* part : std::vector<QWidget*>{node_, problem_, run_, answer_}) {
    layout->addWidget(part);
  }
  layout->addWidget(tabs, 1);
  connect(node_, QOverload<int>::of(&QComboBox::activated),
          [this](int) { chooseNode(node_->currentText()); });
  connect(node_->lineEdit(), &QLineEdit::editingFinished,
          [this] { chooseNode(node_->currentText()); });
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, [this] { refresh(); });
  timer->start(kPeriod);
  refresh();
}

OrigamiPanel::~OrigamiPanel() = default;

void OrigamiPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString node;
  if (config.mapGetString("Node", &node)) chooseNode(node);
}

void OrigamiPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", QString::fromStdString(link_->node()));
}

void OrigamiPanel::chooseNode(const QString& node) {
  if (node.toStdString() == link_->node()) return;
  link_->choose(node.toStdString());
  answer_->clear();
  Q_EMIT configChanged();
}

void OrigamiPanel::lookForNodes() {
  if (searches_.underWay()) return;
  searches_.run<Names>(findNodes, [this](const Names& names) {
    const QString chosen = node_->currentText();
    if (node_->lineEdit()->hasFocus() || node_->view()->isVisible()) return;
    node_->clear();
    for (const std::string& name : names) node_->addItem(QString::fromStdString(name));
    node_->setEditText(chosen);
  });
}

void OrigamiPanel::tell(const std::string& message, bool refused) {
  answer_->setText(QString::fromStdString(refused ? refusal(message) : plain(message)));
}

void OrigamiPanel::refresh() {
  link_->poll();
  requests_.poll();
  searches_.poll();
  if (ticks_++ % kSearchTicks == 0) lookForNodes();
  if (!node_->lineEdit()->hasFocus()) node_->setEditText(QString::fromStdString(link_->node()));
  const std::string problem = link_->problem();
  problem_->setVisible(!problem.empty());
  problem_->setText(QString::fromStdString(problem.empty() ? "" : refusal(problem)));
  run_->refresh();
  creases_->refresh();
  held_->refresh();
  recipe_->refresh();
  history_->refresh();
  file_->refresh();
}

}  // namespace shell_origami

PLUGINLIB_EXPORT_CLASS(shell_origami::OrigamiPanel, rviz::Panel)
